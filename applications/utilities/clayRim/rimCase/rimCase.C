/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimCase.H"
#include "checkWords.H"
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
    wordList words(erosionBracket::edge::words());
    words.append(wordList({"edgeFraction", "expansion", "sweep"}));
    colloid::checkWords(dict, words);

    return erosionBracket::edge::of(dict, solution);
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
