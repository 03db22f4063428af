/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "arrangement.H"
#include "checkWords.H"

namespace Foam
{
    defineTypeNameAndDebug(arrangement, 0);
    defineRunTimeSelectionTable(arrangement, dictionary);
}

const Foam::wordList Foam::arrangement::commonWords
({
    "arrangement", "number", "fraction", "fixed"
});


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
        const label number = dict.get<label>("number");

        if (number < 1)
        {
            FatalIOErrorInFunction(dict)
                << "number is " << number << "; a group has one platelet or"
                << " more. To place none, leave the group out"
                << exit(FatalIOError);
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
