/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldEntries.H"
#include "cubicLaw.H"
#include "readInRange.H"

#include "error.H"
#include "messageStream.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// True for the first of two ways to give a quantity. FatalIOError unless it is
// given in one of them
bool isFirstWay
(
    const dictionary& dict,
    const word& first,
    const word& second,
    const char* instead
)
{
    const bool isFirst = dict.found(first, keyType::LITERAL);

    if (isFirst == dict.found(second, keyType::LITERAL))
    {
        FatalIOErrorInFunction(dict)
            << (isFirst ? "Both " : "Neither ") << first
            << (isFirst ? " and " : " nor ") << second
            << " in " << dict.dictName() << nl
            << "Valid: either  " << first << "  or  " << instead << nl
            << exit(FatalIOError);
    }

    return isFirst;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const Foam::wordList& Foam::fieldEntries::fractionWords()
{
    static const wordList words
    ({
        "fraction", "dryDensity", "grainDensity", "montmorillonite"
    });
    return words;
}


const Foam::wordList& Foam::fieldEntries::apertureWords()
{
    static const wordList words({"aperture", "transmissivity"});
    return words;
}


Foam::scalar Foam::fieldEntries::solidFraction
(
    const dictionary& dict,
    const scalar lower,
    const scalar upper
)
{
    if
    (
        isFirstWay
        (
            dict,
            "fraction",
            "dryDensity",
            "dryDensity, grainDensity and montmorillonite"
        )
    )
    {
        for (const word unused : {"grainDensity", "montmorillonite"})
        {
            if (dict.found(unused, keyType::LITERAL))
            {
                FatalIOErrorInFunction(dict)
                    << "The entry " << unused << " belongs to a dryDensity,"
                    << " and the fraction is given" << nl
                    << exit(FatalIOError);
            }
        }

        return colloid::readInRange(dict, "fraction", lower, upper, "(-)");
    }

    const scalar dry =
        colloid::readInRange(dict, "dryDensity", 1, 5000, "kg/m3");
    const scalar grain =
        colloid::readInRange(dict, "grainDensity", 1000, 25000, "kg/m3");
    const scalar share =
        colloid::readInRange(dict, "montmorillonite", 1e-3, 1, "(-)");

    const scalar fraction = dry*share/grain;

    if (fraction < lower || fraction > upper)
    {
        FatalIOErrorInFunction(dict)
            << "dryDensity " << dry << " kg/m3, grainDensity " << grain
            << " kg/m3 and montmorillonite " << share << nl
            << "make a solid fraction of " << fraction << nl
            << "Valid: from " << lower << " to " << upper << nl
            << exit(FatalIOError);
    }

    Info<< "dryDensity " << dry << " kg/m3, grainDensity " << grain
        << " kg/m3, montmorillonite " << share << " read as fraction "
        << fraction << endl;

    return fraction;
}


Foam::scalar Foam::fieldEntries::apertureOfTransmissivity
(
    const scalar transmissivity,
    const colloid::water& solution
)
{
    return colloid::apertureOf
    (
        transmissivity, solution.viscosity/solution.density
    );
}


Foam::scalar Foam::fieldEntries::aperture
(
    const dictionary& dict,
    const colloid::water& solution
)
{
    if (isFirstWay(dict, "aperture", "transmissivity", "transmissivity"))
    {
        return colloid::readInRange
        (
            dict,
            "aperture",
            colloid::narrowestFracture,
            colloid::widestFracture,
            "m"
        );
    }

    const scalar nu = solution.viscosity/solution.density;
    const scalar transmissivity = colloid::readInRange
    (
        dict,
        "transmissivity",
        colloid::transmissivityOf(colloid::narrowestFracture, nu),
        colloid::transmissivityOf(colloid::widestFracture, nu),
        "m2/s"
    );
    const scalar aperture = apertureOfTransmissivity(transmissivity, solution);

    Info<< "transmissivity " << transmissivity << " m2/s read as aperture "
        << aperture << " m (cubic law)" << endl;

    return aperture;
}


// ************************************************************************* //
