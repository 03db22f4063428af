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

Foam::colloid::compressionDoubleLayer::overlap
Foam::colloid::compressionDoubleLayer::overlapAt(const scalar gap) const
{
    requireGap(gap);

    overlap o;
    o.x = inverseDebyeLength_*gap;

    const scalar a = minusLogCharge_ + 0.5*o.x;     // t = exp(-a)

    o.t = std::exp(-a);
    o.t2 = o.t*o.t;
    o.s = o.t2*inverseCharge_;

    const scalar s2 = o.s*o.s;

    o.oneMinusT2 = o.t2 < 0.5 ? 1 - o.t2 : -std::expm1(-2*a);
    o.oneMinusS2 =
        s2 < 0.5 ? 1 - s2 : -std::expm1(-2*(minusLogCharge_ + o.x));

    return o;
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
    inverseCharge_(std::exp(minusLogCharge_)),
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
    const scalar S = overlapAt(gap).S();

    // cosh(y_m) - 1 without cancellation
    return scale_*S*S/(1 + std::sqrt(1 + S*S));
}


Foam::scalar Foam::colloid::compressionDoubleLayer::slope
(
    const scalar gap
) const
{
    const overlap o(overlapAt(gap));
    const scalar S = o.S();

    const scalar dSdx =
      - 4*o.t*(1 + o.t2*(6 + o.t2))
       /(o.oneMinusT2*o.oneMinusT2*o.oneMinusT2)
      - 8*o.s
       *(1/o.x + (1 + o.s*o.s)/o.oneMinusS2)
       /(o.x*o.oneMinusS2);

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
    return std::asinh(overlapAt(gap).S());
}


// ************************************************************************* //
