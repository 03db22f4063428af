/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "erosionBracket.H"
#include "fieldEntries.H"
#include "readInRange.H"

#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Where the rim ends, over the fraction of its edge
constexpr scalar outerPart = 0.01;


erosionBracket::theory rimTheory
(
    const char* name,
    const rimSimilarity::form equation,
    const rimSimilarity::laws& laws,
    const scalar fraction
)
{
    const rimSimilarity rim(equation, laws, fraction);
    const scalar root = std::sqrt(laws.freeDiffusivity);

    return
    {
        name,
        rim.edgeLoss()*root,
        2*root*rim.distance(outerPart*fraction)
    };
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::erosionBracket::edge Foam::erosionBracket::edge::around
(
    const scalar radius,
    const scalar aperture,
    const scalar velocity
)
{
    return {aperture, velocity, constant::mathematical::pi*radius, 2};
}


Foam::erosionBracket::edge Foam::erosionBracket::edge::straight
(
    const scalar length,
    const scalar aperture,
    const scalar velocity
)
{
    return {aperture, velocity, length, 1};
}


Foam::wordList Foam::erosionBracket::edge::words()
{
    wordList words({"velocity", "radius", "length"});
    words.append(fieldEntries::apertureWords());
    return words;
}


Foam::erosionBracket::edge Foam::erosionBracket::edge::of
(
    const dictionary& dict,
    const colloid::water& solution
)
{
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
        colloid::readInRange(dict, "velocity", 1e-14, 1, "m/s");
    const auto lengthOf = [&](const word& keyword)
    {
        return colloid::readInRange(dict, keyword, 1e-9, 1e6, "m");
    };

    return
        isHole
      ? around(lengthOf("radius"), aperture, velocity)
      : straight(lengthOf("length"), aperture, velocity);
}


Foam::scalar Foam::erosionBracket::theory::rate
(
    const edge& where,
    const scalar density
) const
{
    return
        where.sides*density*where.aperture*coefficient
       *std::sqrt(where.velocity*where.length);
}


Foam::scalar Foam::erosionBracket::theory::rimThickness
(
    const edge& where
) const
{
    return thickness*std::sqrt(where.length/where.velocity);
}


Foam::erosionBracket::matter Foam::erosionBracket::matter::of
(
    const std::function<scalar(scalar)>& diffusivity,
    const scalar freeDiffusivity,
    const colloid::coVolumeViscosity& viscosity
)
{
    return
    {
        {
            diffusivity,
            [viscosity](const scalar phi)
            {
                return viscosity.uncappedViscosity(phi);
            },
            freeDiffusivity,
            viscosity.gelStop() ? viscosity.coVolumeGelFraction() : GREAT
        },
        {
            diffusivity,
            [](const scalar) { return 1; },
            freeDiffusivity,
            viscosity.flocFraction()
        }
    };
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::erosionBracket::erosionBracket
(
    const matter& clay,
    const scalar edgeFraction
)
:
    fraction_(edgeFraction),
    printed_
    (
        rimTheory
        (
            "rim (A), as printed",
            rimSimilarity::form::printed,
            clay.clay,
            edgeFraction
        )
    ),
    conservative_
    (
        rimTheory
        (
            "rim (C)",
            rimSimilarity::form::conservative,
            clay.clay,
            edgeFraction
        )
    ),
    flocculated_
    (
        rimTheory
        (
            "rim (C), flocculated",
            rimSimilarity::form::conservative,
            clay.flocs,
            edgeFraction
        )
    ),
    penetration_
    ({
        "formula 2-2",
        2*edgeFraction*std::sqrt
        (
            clay.clay.diffusivity(edgeFraction)/constant::mathematical::pi
        ),
        0
    })
{}


// ************************************************************************* //
