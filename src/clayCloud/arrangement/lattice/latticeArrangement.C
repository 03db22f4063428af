/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeArrangement.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "countOf.H"
#include "DynamicList.H"
#include "ListOps.H"

namespace Foam
{
    defineTypeNameAndDebug(latticeArrangement, 0);
    addToRunTimeSelectionTable(arrangement, latticeArrangement, dictionary);
}

namespace
{

//- Share of what is asked for that may be missed without a word
constexpr Foam::scalar missed = 0.05;

//- By what spacings along the axes may differ from the mean for a number's sake
constexpr Foam::scalar stretched = 1.5;

} // End anonymous namespace


Foam::latticeArrangement::latticeArrangement
(
    const dictionary& dict,
    const scene& where
)
:
    arrangement(where),
    dict_(dict),
    region_(where.mesh, dict),
    perturbation_
    (
        dict.getCheckOrDefault<scalar>
        (
            "perturbation", 0, [](scalar p){ return p >= 0 && p < 0.5; }
        )
    )
{
    wordList words(commonWords);
    words.append(clayRegion::words);
    words.append("perturbation");
    colloid::checkWords(dict, words);

    spacing_ = spacingFor(dict, region_.volume(), where.parcelVolume);
}


Foam::Vector<Foam::label> Foam::latticeArrangement::nearestLayers
(
    const vector& span,
    const scalar sites
)
{
    // Layers at one spacing along all axes, but one at least along each
    FixedList<bool, 3> thin(false);
    vector ideal;
    for (direction pass = 0; pass < 3; ++pass)
    {
        scalar volume = 1;
        direction wide = 0;
        for (direction axis = 0; axis < 3; ++axis)
        {
            if (!thin[axis])
            {
                volume *= span[axis];
                ++wide;
            }
        }
        const scalar spacing = wide ? Foam::pow(volume/sites, 1.0/wide) : 1;
        for (direction axis = 0; axis < 3; ++axis)
        {
            ideal[axis] = thin[axis] ? 1 : span[axis]/spacing;
            thin[axis] = thin[axis] || ideal[axis] <= 1;
        }
    }

    Vector<label> least;
    Vector<label> most;
    for (direction axis = 0; axis < 3; ++axis)
    {
        least[axis] = max(scalar(1), std::floor(ideal[axis]/stretched));
        most[axis] = max(scalar(1), std::ceil(ideal[axis]*stretched));
    }

    Vector<label> best(1, 1, 1);
    scalar missing = GREAT;
    scalar distortion = GREAT;
    Vector<label> n;
    for (n.x() = least.x(); n.x() <= most.x(); ++n.x())
    {
        for (n.y() = least.y(); n.y() <= most.y(); ++n.y())
        {
            const scalar inPlane = scalar(n.x())*n.y();
            n.z() = min
            (
                max(std::round(sites/inPlane), scalar(least.z())),
                scalar(most.z())
            );
            const scalar misses = mag(inPlane*n.z() - sites);
            scalar distorts = 0;
            for (direction axis = 0; axis < 3; ++axis)
            {
                distorts += sqr(Foam::log(n[axis]/ideal[axis]));
            }
            if
            (
                misses < missing
             || (misses == missing && distorts < distortion)
            )
            {
                best = n;
                missing = misses;
                distortion = distorts;
            }
        }
    }
    return best;
}


Foam::Vector<Foam::label> Foam::latticeArrangement::layers() const
{
    const vector span(region_.bounds().span());
    const scalar sites = cmptProduct(span)/pow3(spacing_);

    Vector<label> n;
    scalar rounded = 1;
    for (direction axis = 0; axis < 3; ++axis)
    {
        n[axis] = colloid::countOf
        (
            max(scalar(1), std::round(span[axis]/spacing_)),
            "layers of the lattice along an axis",
            dict_
        );
        rounded *= n[axis];
    }

    const bool near = mag(rounded - sites) < missed*sites;
    numberToPlace(near ? rounded : max(rounded, sites), dict_);

    return
        near || !dict_.found("number") ? n
      : nearestLayers(span, std::round(sites));
}


Foam::pointField Foam::latticeArrangement::place(Random& random)
{
    const scalar asked = region_.volume()/pow3(spacing_);
    const Vector<label> n(layers());
    const vector span(region_.bounds().span());
    const vector step(span.x()/n.x(), span.y()/n.y(), span.z()/n.z());

    DynamicList<point> places;

    for (label i = 0; i < n.x(); ++i)
    {
        for (label j = 0; j < n.y(); ++j)
        {
            for (label k = 0; k < n.z(); ++k)
            {
                const point site
                (
                    region_.bounds().min()
                  + cmptMultiply(vector(i + 0.5, j + 0.5, k + 0.5), step)
                );

                if (region_.cellOf(site) < 0)
                {
                    continue;
                }

                // At most half a spacing away: the site's own region, or
                // again
                point x(site);
                label tries = 0;
                do
                {
                    const vector shift(random.sample01<vector>() - vector::uniform(0.5));
                    x = site + 2*perturbation_*cmptMultiply(shift, step);
                }
                while (region_.cellOf(x) < 0 && ++tries < 100);

                places.append(tries < 100 ? x : site);
            }
        }
    }

    if (mag(places.size() - asked) >= missed*asked)
    {
        WarningInFunction
            << "The lattice has " << places.size() << " places, where "
            << (dict_.found("number") ? "number" : "fraction") << " asks for "
            << std::round(asked) << ":" << nl
            << "    " << n.x() << " x " << n.y() << " x " << n.z() << " layers"
            << " fit the region's bounds. Another number or box, or the"
            << " arrangement random" << nl << endl;
    }

    // What the whole numbers of spacings came to
    if (places.size())
    {
        spacing_ = Foam::cbrt(region_.volume()/places.size());
    }
    return pointField(places);
}
