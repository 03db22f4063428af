/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimHistory.H"
#include "checkWords.H"
#include "fieldEntries.H"
#include "physicalConstants.H"
#include "readInRange.H"

#include "OFstream.H"
#include "error.H"

#include <cmath>
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

using colloid::physicalConstants::year;

// First written time over the last one
constexpr scalar firstTime = 1e-5;

// Rows of the table that is printed, and profiles that are written
constexpr label printed = 10;
constexpr label profiles = 6;


std::string row(const std::initializer_list<scalar>& values)
{
    std::ostringstream line;
    line<< std::setprecision(4);
    for (const scalar value : values)
    {
        line<< std::setw(12) << value;
    }
    return line.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rimHistory::rimHistory(const rimCase& place, const rimMatter& matter)
:
    dict_(place.dict().subDict("expansion")),
    case_(place),
    matter_(matter),
    bracket_(matter.bracket(place.edgeFraction(matter))),
    loss_(rimCase::lossName(dict_))
{
    wordList words(fieldEntries::fractionWords());
    words.append(wordList
    ({
        "method", "loss", "holeRadius", "plugVolume", "startRadius", "endTime",
        "writeTimes", "cells", "growth"
    }));
    colloid::checkWords(dict_, words);

    const word method
    (
        dict_.getOrDefault<word>("method", "full", keyType::LITERAL)
    );
    colloid::checkChoice
    (
        dict_, "method", method, wordList({"full", "pseudoSteady"})
    );

    full_ = method == "full";

    endTime_ = colloid::readInRange(dict_, "endTime", 1, 1e16, "s");
    writeTimes_ =
        label(colloid::readInRange(dict_, "writeTimes", 100, 2, 1e5, "(-)"));

    twoRegionRim::scene scene;
    scene.holeRadius =
        colloid::readInRange(dict_, "holeRadius", 1e-6, 1e3, "m");
    scene.aperture = case_.edge().aperture;
    scene.density = matter_.clay().density;
    scene.holeFraction = fieldEntries::solidFraction(dict_);

    const auto volume = colloid::numberOrWord
    (
        dict_, "plugVolume", "held", 1e-15, 1e6, "m3"
    );
    held_ = !volume;
    if (volume)
    {
        scene.plugVolume = *volume;
    }

    const scalar velocity = case_.edge().velocity;
    const scalar aperture = scene.aperture;
    const scalar density = scene.density;
    scene.lossRate =
        [=, theory = rimCase::loss(bracket_, loss_)](const scalar radius)
        {
            return theory.rate
            (
                erosionBracket::edge::around(radius, aperture, velocity),
                density
            );
        };

    twoRegionRim::controls settings;
    settings.startRadius =
        colloid::readInRange
        (
            dict_,
            "startRadius",
            1.01*scene.holeRadius,
            1.00001*scene.holeRadius,
            100*scene.holeRadius,
            "m"
        )
       /scene.holeRadius;
    settings.growth =
        colloid::readInRange(dict_, "growth", 0.005, 1e-4, 0.2, "(-)");
    settings.cells =
        label(colloid::readInRange(dict_, "cells", 200, 4, 1e4, "(-)"));
    if (!full_)
    {
        settings.cells = 0;
    }

    const scalar edge = bracket_.edgeFraction();
    if (scene.holeFraction <= edge)
    {
        FatalIOErrorInFunction(dict_)
            << "The hole's solid fraction " << scene.holeFraction
            << " is not above that of the gel's edge, " << edge << nl
            << exit(FatalIOError);
    }

    rim_.reset
    (
        new twoRegionRim(scene, matter_.diffusivity(), edge, settings)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rimHistory::run(const fileName& directory, Ostream& os)
{
    OFstream history(directory/"history.dat");
    OFstream shape(directory/"profiles.dat");

    for (OFstream* file : {&history, &shape})
    {
        if (!file->good())
        {
            FatalErrorInFunction
                << "Cannot write " << file->name() << nl << exit(FatalError);
        }
    }

    history.precision(10);
    shape.precision(8);
    history
        << "# time[a] radius[m] holeFraction[-] feed[kg/a] loss[kg/a]"
        << " clayInGel[kg] cameIn[kg] eroded[kg]" << nl;

    os  << "Expansion, " << (full_ ? "full" : "pseudo-steady")
        << ", loss " << loss_ << nl << nl
        << "    time [a]     r_R [m]    hole [-] feed [kg/a] loss [kg/a]"
        << " eroded [kg]" << nl;

    bool goesOn = true;
    for (label i = 1; i <= writeTimes_ && goesOn; ++i)
    {
        goesOn = rim_->advance
        (
            endTime_
           *std::pow(firstTime, scalar(writeTimes_ - i)/(writeTimes_ - 1))
        );

        const twoRegionRim& rim = *rim_;
        const scalar time = rim.time()/year;

        history
            << time << ' ' << rim.radius() << ' ' << rim.holeFraction() << ' '
            << rim.feedRate()*year << ' ' << rim.lossRate()*year << ' '
            << rim.clay() << ' ' << rim.cameIn() << ' ' << rim.eroded() << nl;

        // Every so many, and the last one
        const auto due = [&](const label number)
        {
            return !goesOn
             || (i*number)/writeTimes_ > ((i - 1)*number)/writeTimes_;
        };

        if (due(printed))
        {
            os  << row
                ({
                    time, rim.radius(), rim.holeFraction(),
                    rim.feedRate()*year, rim.lossRate()*year, rim.eroded()
                }).c_str() << nl;
        }
        if (due(profiles))
        {
            const scalarField r(rim.radii()), phi(rim.fractions());
            shape
                << "# time[a] " << time << nl << "# radius[m] fraction[-]"
                << nl;
            forAll(r, k)
            {
                shape<< r[k] << ' ' << phi[k] << nl;
            }
            shape<< nl << nl;
        }
    }

    const twoRegionRim& rim = *rim_;
    const scalar all = rim.startClay() + rim.cameIn();

    os  << nl;
    if (!goesOn)
    {
        os  << "The plug is spent after " << rim.time()/year << " a" << nl;
    }
    if (held_)
    {
        os  << "At rest with r_R = " << rim.steadyRadius() << " m" << nl;
    }
    os  << "Clay: " << all << " kg came in, " << rim.clay()
        << " in the gel, " << rim.eroded() << " eroded" << nl
        << (full_ ? "Imbalance " : "Neglected by the pseudo-steady profile ")
        << mag(rim.clay() + rim.eroded() - all)/all << " of it" << nl << nl;

    if (goesOn)
    {
        os  << "At the end, with r_R = " << rim.radius() << " m:" << nl << nl;
        bracket_.write
        (
            os,
            erosionBracket::edge::around
            (
                rim.radius(), case_.edge().aperture, case_.edge().velocity
            ),
            matter_.clay().density
        );
    }
}


// ************************************************************************* //
