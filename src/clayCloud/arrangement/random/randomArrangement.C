/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomArrangement.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "DynamicList.H"
#include "placedPoints.H"

namespace Foam
{
    defineTypeNameAndDebug(randomArrangement, 0);
    addToRunTimeSelectionTable(arrangement, randomArrangement, dictionary);
}


Foam::randomArrangement::randomArrangement
(
    const dictionary& dict,
    const scene& where
)
:
    arrangement(where),
    dict_(dict),
    region_(where.mesh, dict),
    minimumDistance_
    (
        dict.getCheckOrDefault<scalar>
        (
            "minimumDistance", 0.5, [](scalar d){ return d >= 0; }
        )
    )
{
    wordList words(commonWords);
    words.append(clayRegion::words);
    words.append("minimumDistance");
    colloid::checkWords(dict, words);

    spacing_ = spacingFor(dict, region_.volume(), where.parcelVolume);
}


Foam::pointField Foam::randomArrangement::place(Random& random)
{
    const label number = numberToPlace
    (
        max(scalar(1), std::round(region_.volume()/pow3(spacing_))), dict_
    );
    const scalar distance = minimumDistance_*spacing_;
    placedPoints placed(scene_.axes, max(distance, 0.1*spacing_));

    DynamicList<point> places(number);

    const label maxTries = 1000;
    for (label tries = 0; places.size() < number; ++tries)
    {
        if (tries > maxTries)
        {
            FatalIOErrorInFunction(dict_)
                << "Only " << places.size() << " of " << number
                << " platelets fit at least " << distance << " m apart: "
                << maxTries << " further tries failed." << nl
                << "    Reduce minimumDistance (now " << minimumDistance_
                << " spacings), number or fraction" << exit(FatalIOError);
        }

        const point x
        (
            region_.bounds().min()
          + cmptMultiply(random.sample01<vector>(), region_.bounds().span())
        );

        if
        (
            region_.cellOf(x) >= 0
         && placed.nearest(x, distance) >= distance
        )
        {
            places.append(x);
            placed.add(x);
            tries = 0;
        }
    }

    return pointField(places);
}
