/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "latticeArrangement.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "DynamicList.H"
#include "ListOps.H"

namespace Foam
{
    defineTypeNameAndDebug(latticeArrangement, 0);
    addToRunTimeSelectionTable(arrangement, latticeArrangement, dictionary);
}


Foam::latticeArrangement::latticeArrangement
(
    const dictionary& dict,
    const scene& where
)
:
    arrangement(where),
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


Foam::pointField Foam::latticeArrangement::place(Random& random)
{
    const vector span(region_.bounds().span());

    Vector<label> n;
    vector step;
    for (direction axis = 0; axis < 3; ++axis)
    {
        n[axis] = max(label(1), label(std::round(span[axis]/spacing_)));
        step[axis] = span[axis]/n[axis];
    }

    DynamicList<point> places(n.x()*n.y()*n.z());

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

    // What the whole numbers of spacings came to
    if (places.size())
    {
        spacing_ = Foam::cbrt(region_.volume()/places.size());
    }
    return pointField(places);
}
