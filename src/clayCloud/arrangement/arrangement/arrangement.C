/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "arrangement.H"
#include "checkWords.H"
#include "countOf.H"

#include <cmath>

#include <unistd.h>

namespace Foam
{
    defineTypeNameAndDebug(arrangement, 0);
    defineRunTimeSelectionTable(arrangement, dictionary);
}

const Foam::wordList Foam::arrangement::commonWords
({
    "arrangement", "number", "fraction", "fixed"
});

namespace
{

//- What setClay holds of each at least: a particle and its place
constexpr Foam::scalar bytesPerPlatelet = 300;

} // End anonymous namespace


Foam::autoPtr<Foam::arrangement> Foam::arrangement::New
(
    const dictionary& dict,
    const scene& where
)
{
    const word kind(dict.get<word>("arrangement"));
    colloid::checkChoice
    (
        dict,
        "arrangement",
        kind,
        dictionaryConstructorTablePtr_->sortedToc()
    );

    return dictionaryConstructorTablePtr_->cfind(kind)()(dict, where);
}


Foam::scalar Foam::arrangement::spacingFor
(
    const dictionary& dict,
    const scalar volume,
    const scalar parcelVolume
)
{
    if (dict.found("number") == dict.found("fraction"))
    {
        FatalIOErrorInFunction(dict)
            << "Give either number or fraction" << exit(FatalIOError);
    }

    if (dict.found("number"))
    {
        const scalar number = dict.get<scalar>("number");

        if (number < 1)
        {
            FatalIOErrorInFunction(dict)
                << "number is " << number << "; a group has one platelet or"
                << " more. To place none, leave the group out"
                << exit(FatalIOError);
        }
        if (number != std::floor(number))
        {
            FatalIOErrorInFunction(dict)
                << "number is " << number << "; it counts whole platelets"
                << exit(FatalIOError);
        }
        numberToPlace(number, dict);

        const scalar filled = number*parcelVolume/volume;
        if (filled >= 1)
        {
            FatalIOErrorInFunction(dict)
                << "number is " << colloid::inDigits(number).c_str()
                << ": they would fill " << filled << " of the region's "
                << volume << " m3, each being " << parcelVolume << " m3." << nl
                << "    A solid fraction lies between 0 and 1. Is the mesh in"
                << " metres?" << exit(FatalIOError);
        }
        return cbrt(volume/number);
    }

    const scalar fraction = dict.get<scalar>("fraction");
    if (fraction <= 0 || fraction >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "fraction is " << fraction << "; a solid fraction lies between"
            << " 0 and 1" << exit(FatalIOError);
    }
    return cbrt(parcelVolume/fraction);
}


Foam::label Foam::arrangement::numberToPlace
(
    const scalar number,
    const dictionary& dict
)
{
    const label count =
        colloid::countOf(number, "platelets or parcels to place", dict);

    const scalar needed = bytesPerPlatelet*number;
    const scalar there =
        scalar(sysconf(_SC_PHYS_PAGES))*scalar(sysconf(_SC_PAGESIZE));

    if (there > 0 && needed > there)
    {
        FatalIOErrorInFunction(dict)
            << colloid::inDigits(number).c_str() << " platelets or parcels to"
            << " place need more than " << needed/1e9 << " GB, and this machine"
            << " has " << there/1e9 << " GB." << nl
            << "    Are all lengths, and the mesh (scale in blockMeshDict), in"
            << " metres? Else take parcels: coarseGraining" << nl
            << "    (clayCloudProperties)" << exit(FatalIOError);
    }
    return count;
}
