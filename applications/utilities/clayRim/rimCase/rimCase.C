/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimCase.H"
#include "checkWords.H"
#include "fieldEntries.H"
#include "readInRange.H"

#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

erosionBracket::edge edgeOf
(
    const dictionary& dict,
    const colloid::water& solution
)
{
    wordList words(fieldEntries::apertureWords());
    words.append(wordList
    ({
        "velocity", "radius", "length", "edgeFraction", "expansion", "sweep"
    }));
    colloid::checkWords(dict, words);

    const bool isHole = dict.found("radius", keyType::LITERAL);

    if (isHole == dict.found("length", keyType::LITERAL))
    {
        FatalIOErrorInFunction(dict)
            << (isHole ? "Both radius and" : "Neither radius nor")
            << " length in " << dict.dictName() << nl
            << "Valid: either  radius  of the gel around a hole, or  length"
            << "  of a straight edge" << nl
            << exit(FatalIOError);
    }

    const scalar aperture = fieldEntries::aperture(dict, solution);
    const scalar velocity =
        colloid::readInRange(dict, "velocity", 1e-14, 10, "m/s");

    return
        isHole
      ? erosionBracket::edge::around
        (
            colloid::readInRange(dict, "radius", 1e-6, 1e4, "m"),
            aperture,
            velocity
        )
      : erosionBracket::edge::straight
        (
            colloid::readInRange(dict, "length", 1e-6, 1e5, "m"),
            aperture,
            velocity
        );
}

const wordList lossNames
({
    "penetration", "printed", "conservative", "flocculated"
});

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rimCase::rimCase
(
    const dictionary& dict,
    const colloid::water& solution
)
:
    dict_(dict),
    edge_(edgeOf(dict, solution))
{
    const auto given = colloid::numberOrWord
    (
        dict_, "edgeFraction", "gel", 1e-5, 0.5, "(-), or gel"
    );

    if (given)
    {
        edgeFraction_ = *given;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::rimCase::edgeFraction(const rimMatter& matter) const
{
    return
        edgeFraction_ > 0
      ? edgeFraction_
      : matter.viscosity().coVolumeGelFraction();
}


Foam::word Foam::rimCase::lossName(const dictionary& dict)
{
    const word name
    (
        dict.getOrDefault<word>("loss", "conservative", keyType::LITERAL)
    );
    colloid::checkChoice(dict, "loss", name, lossNames);
    return name;
}


const Foam::erosionBracket::theory& Foam::rimCase::loss
(
    const erosionBracket& bracket,
    const word& name
)
{
    return
        name == "penetration" ? bracket.penetration()
      : name == "printed" ? bracket.printed()
      : name == "flocculated" ? bracket.flocculated()
      : bracket.conservative();
}


// ************************************************************************* //
