/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "parcelScale.H"
#include "checkWords.H"
#include "clayRegion.H"
#include "countOf.H"
#include "scales.H"
#include "Time.H"

#include <cmath>

namespace
{

using namespace Foam;

//- Error of swelling times layers over (alpha - 1)
constexpr scalar errorPerLayer = 1.4;

//- Smallest extent [m] of a region, leaving out whole periods; all of them where
//  there is nothing else
scalar smallestExtent(const clayRegion& region, const periodicAxes& axes)
{
    const vector span(region.bounds().span());
    scalar open = GREAT;

    for (direction axis = 0; axis < 3; ++axis)
    {
        if (!axes.periodic(axis) || span[axis] < 0.999*axes.period(axis))
        {
            open = min(open, span[axis]);
        }
    }
    return open < GREAT ? open : cmptMin(span);
}

} // End anonymous namespace


Foam::scalar Foam::parcelScale
(
    const polyMesh& mesh,
    const periodicAxes& axes,
    const colloid::clayProperties& matter,
    const cloudProperties& properties,
    const dictionary& setClayDict
)
{
    const scalar asked = properties.coarseGraining();
    if (asked > 0)
    {
        return asked;
    }

    const scalar tolerance = properties.tolerance();
    const colloid::platelet& clay = matter.clay();

    // Of the group that allows least
    scalar alpha = GREAT;
    scalar fewest = GREAT;
    scalar densest = 0;
    scalar volume = 0;

    for (const entry& group : setClayDict)
    {
        if (!group.isDict() || group.keyword() == colloid::variablesWord)
        {
            continue;
        }
        const dictionary& dict = group.dict();

        if (!dict.found("fraction"))
        {
            FatalIOErrorInFunction(dict)
                << "coarseGraining is auto, which needs the fraction of each"
                << " group." << nl << "    Give fraction here, or a number for"
                << " coarseGraining (clayCloudProperties)" << exit(FatalIOError);
        }
        const clayRegion region(mesh, dict);
        const scalar fraction = dict.get<scalar>("fraction");
        const scalar feature = setClayDict.getCheckOrDefault<scalar>
        (
            "featureSize",
            smallestExtent(region, axes),
            [](scalar length){ return length > 0; }
        );
        const scalar layers = feature/clay.cubicSpacing(fraction);

        fewest = min(fewest, layers);
        alpha = min(alpha, 1 + tolerance*layers/errorPerLayer);
        densest = max(densest, fraction);
        volume += fraction*region.volume();
    }
    if (alpha == GREAT)
    {
        return 1;
    }

    // Two digits after the point are enough
    alpha = std::floor(100*alpha)/100;

    const scalar platelets = volume/clay.volume();
    const colloid::water water(matter.waterAt(mesh.time().value()));
    const scalar step = colloid::scales
    (
        clay,
        water,
        *matter.newDoubleLayer(properties.doubleLayerDict(), water),
        *matter.newFriction("KozenyCarman", water)
    ).engineTimeStep(densest);

    Info<< nl << "coarseGraining auto: " << alpha << nl
        << "    clay " << fewest << " spacings of platelets wide, tolerance "
        << tolerance << ": swelling errs by about "
        << errorPerLayer*(alpha - 1)/fewest << " (1.4 (alpha - 1)/spacings)"
        << nl << "    about "
        << colloid::inDigits(std::floor(platelets/pow3(alpha))).c_str()
        << " parcels for " << colloid::inDigits(std::floor(platelets)).c_str()
        << " platelets, but for whole spacings of a lattice" << nl
        << "    about "
        << colloid::inDigits(std::floor(1/(sqr(alpha)*step))).c_str()
        << " evaluations per second of the clay's time for "
        << colloid::inDigits(std::floor(1/step)).c_str() << nl
        << "    (fixed step of Adams-Bashforth 2), in all "
        << 0.1*std::round(10*pow5(alpha)) << " times less work" << nl;

    return alpha;
}
