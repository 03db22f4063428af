/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coVolumeViscosity.H"
#include "checkWords.H"
#include "readInRange.H"
#include "Switch.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Part of the gel's fraction over which it stiffens
constexpr Foam::scalar gellingWidth = 0.05;

// Eq. 3-14
Foam::scalar coVolumeLaw(const Foam::scalar p)
{
    return 1 + p*(1.022 + 1.358*p*p);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::colloid::coVolumeViscosity::gelling
(
    const scalar liquid,
    const scalar beyond
) const
{
    if (beyond <= 0)
    {
        return liquid;
    }

    const scalar s = beyond/gellingWidth;

    if (s >= 1)
    {
        return gelViscosity_;
    }

    // Between the logarithms, with zero slope at both ends
    const scalar gel = s*s*(3 - 2*s);

    return std::pow(liquid, 1 - gel)*std::pow(gelViscosity_, gel);
}


Foam::scalar Foam::colloid::coVolumeViscosity::coVolumePerFraction
(
    const scalar concentration
) const
{
    const scalar swelling = 1 + relativeCore_/std::sqrt(concentration);

    return barePerFraction_*swelling*swelling*swelling;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::coVolumeViscosity::coVolumeViscosity
(
    const dictionary& viscosity,
    const dictionary& flocculation,
    const platelet& clay,
    const water& solution
)
:
    gelCoVolume_
    (
        readInRange(viscosity, "gelCoVolume", 0.01, 100, "(-)")
    ),
    gelStop_
    (
        viscosity.get<Switch>("gelStop", keyType::LITERAL)
    ),
    gelViscosity_
    (
        readInRange
        (
            viscosity,
            "gelViscosity",
            coVolumeLaw((1 + gellingWidth)*gelCoVolume_),
            1e12,
            "(times that of water)"
        )
    ),
    flocculated_
    (
        flocculation.get<Switch>("active", keyType::LITERAL)
    ),
    flocFraction_
    (
        readInRange(flocculation, "fraction", 1e-6, 1, "(-)")
    )
{
    checkWords
    (
        viscosity,
        wordList
        ({
            "model", "coreThickness", "gelCoVolume", "gelStop", "gelViscosity"
        })
    );

    checkChoice
    (
        viscosity,
        "model",
        viscosity.get<word>("model", keyType::LITERAL),
        wordList({"LiuCoVolume"})
    );

    checkWords(flocculation, wordList({"active", "fraction"}));

    const scalar core =
        readInRange(viscosity, "coreThickness", 0, 100, "Debye lengths");

    barePerFraction_ = 2*clay.diameter/(3*clay.thickness);
    relativeCore_ =
        2*core*std::sqrt(solution.concentration)
       /(clay.diameter*solution.inverseDebyeLength());

    coVolumePerFraction_ = coVolumePerFraction(solution.concentration);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::colloid::coVolumeViscosity Foam::colloid::coVolumeViscosity::at
(
    const scalar concentration
) const
{
    coVolumeViscosity result(*this);
    result.coVolumePerFraction_ = coVolumePerFraction(concentration);

    return result;
}


Foam::scalar Foam::colloid::coVolumeViscosity::coVolumeFraction
(
    const scalar fraction
) const
{
    return coVolumePerFraction_*fraction;
}


Foam::scalar Foam::colloid::coVolumeViscosity::uncappedViscosity
(
    const scalar fraction
) const
{
    return coVolumeLaw(coVolumeFraction(fraction));
}


Foam::scalar Foam::colloid::coVolumeViscosity::relativeViscosity
(
    const scalar fraction
) const
{
    const scalar liquid = flocculated_ ? 1 : uncappedViscosity(fraction);

    return gels() ? gelling(liquid, fraction/gelFraction() - 1) : liquid;
}


Foam::scalar Foam::colloid::coVolumeViscosity::gelFraction() const
{
    return flocculated_ ? flocFraction_ : gelCoVolume_/coVolumePerFraction_;
}


// ************************************************************************* //
