/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomArrangement.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "DynamicList.H"
#include "ListOps.H"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

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
    const label number =
        max(label(1), label(std::round(region_.volume()/pow3(spacing_))));
    const scalar distance = minimumDistance_*spacing_;
    const scalar binWidth = max(distance, 0.1*spacing_);

    DynamicList<point> places(number);

    // The places by bins of the minimum distance
    using bin = std::array<label, 3>;
    std::map<bin, std::vector<point>> bins;

    const auto binOf = [&](const point& x)
    {
        bin b;
        for (direction axis = 0; axis < 3; ++axis)
        {
            b[axis] = std::floor
            (
                (x[axis] - region_.bounds().min()[axis])/binWidth
            );
        }
        return b;
    };

    const auto isFree = [&](const point& x)
    {
        const bin centre(binOf(x));
        for (label k = 0; k < 27; ++k)
        {
            const auto found = bins.find
            ({
                centre[0] + k%3 - 1, centre[1] + k/3%3 - 1, centre[2] + k/9 - 1
            });
            if
            (
                found != bins.end()
             && std::any_of
                (
                    found->second.begin(), found->second.end(),
                    [&](const point& y){ return mag(x - y) < distance; }
                )
            )
            {
                return false;
            }
        }
        return true;
    };

    // The place itself and its images across periodic boundaries
    const auto enter = [&](const point& x)
    {
        for (label k = 0; k < 27; ++k)
        {
            const label shift[3] = {k%3 - 1, k/3%3 - 1, k/9 - 1};
            point image(x);
            bool isImage = true;
            for (direction axis = 0; axis < 3; ++axis)
            {
                isImage =
                    isImage && (shift[axis] == 0 || scene_.axes.periodic(axis));
                if (isImage && shift[axis])
                {
                    image[axis] += shift[axis]*scene_.axes.period(axis);
                }
            }
            if (isImage)
            {
                bins[binOf(image)].push_back(image);
            }
        }
    };

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

        if (region_.cellOf(x) >= 0 && isFree(x))
        {
            places.append(x);
            enter(x);
            tries = 0;
        }
    }

    return pointField(places);
}
