/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "compressionDoubleLayer.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "faceGap.H"
#include "quadrature.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace colloid
{
    defineTypeNameAndDebug(compressionDoubleLayer, 0);
    addToRunTimeSelectionTable
    (
        doubleLayer,
        compressionDoubleLayer,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// -ln(tanh(asinh(a)/2)), exact for weak and for strong charge
Foam::scalar minusLogTanhQuarter(const Foam::scalar a)
{
    const Foam::scalar root = std::sqrt(1 + a*a);
    const Foam::scalar q = 1/(a + root);            // exp(-y0/2)

    return q < 0.5 ? 2*std::atanh(q) : -std::log(a/(1 + root));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::colloid::compressionDoubleLayer::sinhMidPotential
(
    const scalar gap
) const
{
    requireGap(gap);

    const scalar x = inverseDebyeLength_*gap;
    const scalar a = minusLogCharge_ + 0.5*x;       // t = exp(-a)
    const scalar b = minusLogCharge_ + x;           // s = exp(-b)

    const scalar t = std::exp(-a);
    const scalar s = std::exp(-b);
    const scalar oneMinusT2 = -std::expm1(-2*a);
    const scalar oneMinusS2 = -std::expm1(-2*b);

    return
        8*t*(1 + t*t)/(oneMinusT2*oneMinusT2)
      + 8*s/(x*oneMinusS2);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::compressionDoubleLayer::compressionDoubleLayer
(
    const platelet& clay,
    const water& solution
)
:
    inverseDebyeLength_(solution.inverseDebyeLength()),
    minusLogCharge_(minusLogTanhQuarter(solution.reducedSurfaceCharge(clay))),
    scale_(solution.ionPressure()*clay.faceArea())
{}


Foam::colloid::compressionDoubleLayer::compressionDoubleLayer
(
    const dictionary& dict,
    const platelet& clay,
    const water& solution
)
:
    compressionDoubleLayer(clay, solution)
{
    checkWords(dict, wordList({"model"}));
}


Foam::autoPtr<Foam::colloid::doubleLayer>
Foam::colloid::compressionDoubleLayer::clone() const
{
    return autoPtr<doubleLayer>(new compressionDoubleLayer(*this));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::compressionDoubleLayer::force
(
    const scalar gap
) const
{
    const scalar S = sinhMidPotential(gap);

    // cosh(y_m) - 1 without cancellation
    return scale_*S*S/(1 + std::sqrt(1 + S*S));
}


Foam::scalar Foam::colloid::compressionDoubleLayer::slope
(
    const scalar gap
) const
{
    requireGap(gap);

    const scalar x = inverseDebyeLength_*gap;
    const scalar a = minusLogCharge_ + 0.5*x;
    const scalar b = minusLogCharge_ + x;

    const scalar t = std::exp(-a);
    const scalar s = std::exp(-b);
    const scalar t2 = t*t;
    const scalar oneMinusT2 = -std::expm1(-2*a);
    const scalar oneMinusS2 = -std::expm1(-2*b);

    const scalar S =
        8*t*(1 + t2)/(oneMinusT2*oneMinusT2)
      + 8*s/(x*oneMinusS2);

    const scalar dSdx =
      - 4*t*(1 + 6*t2 + t2*t2)/(oneMinusT2*oneMinusT2*oneMinusT2)
      - 8*s/(x*oneMinusS2)/x
      - 8*s*(1 + s*s)/(x*oneMinusS2*oneMinusS2);

    return scale_*inverseDebyeLength_*dSdx*S/std::sqrt(1 + S*S);
}


Foam::scalar Foam::colloid::compressionDoubleLayer::energy
(
    const scalar gap
) const
{
    requireGap(gap);

    // No closed form: S is a sum of two kinds of terms under the root
    return integralToInfinity
    (
        [this](const scalar h) { return force(h); },
        gap,
        decayLength()
    );
}


Foam::scalar Foam::colloid::compressionDoubleLayer::decayLength() const
{
    return 1/inverseDebyeLength_;
}


Foam::scalar Foam::colloid::compressionDoubleLayer::midPotential
(
    const scalar gap
) const
{
    return std::asinh(sinhMidPotential(gap));
}


// ************************************************************************* //
