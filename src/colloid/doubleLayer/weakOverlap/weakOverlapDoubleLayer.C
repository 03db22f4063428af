/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "weakOverlapDoubleLayer.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace colloid
{
    defineTypeNameAndDebug(weakOverlapDoubleLayer, 0);
    addToRunTimeSelectionTable
    (
        doubleLayer,
        weakOverlapDoubleLayer,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::weakOverlapDoubleLayer::weakOverlapDoubleLayer
(
    const platelet& clay,
    const water& solution
)
:
    inverseDebyeLength_(solution.inverseDebyeLength())
{
    // tanh(y0/4) = a/(1 + sqrt(1 + a^2)) with y0 = 2 asinh(a)
    const scalar a = solution.reducedSurfaceCharge(clay);
    const scalar g = a/(1 + std::sqrt(1 + a*a));

    scale_ = 32*solution.ionPressure()*clay.faceArea()*g*g;
}


Foam::colloid::weakOverlapDoubleLayer::weakOverlapDoubleLayer
(
    const dictionary& dict,
    const platelet& clay,
    const water& solution
)
:
    weakOverlapDoubleLayer(clay, solution)
{
    checkWords(dict, wordList({"model"}));
}


Foam::autoPtr<Foam::colloid::doubleLayer>
Foam::colloid::weakOverlapDoubleLayer::clone() const
{
    return autoPtr<doubleLayer>(new weakOverlapDoubleLayer(*this));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::weakOverlapDoubleLayer::force
(
    const scalar gap
) const
{
    return scale_*std::exp(-inverseDebyeLength_*gap);
}


Foam::scalar Foam::colloid::weakOverlapDoubleLayer::slope
(
    const scalar gap
) const
{
    return -inverseDebyeLength_*force(gap);
}


Foam::scalar Foam::colloid::weakOverlapDoubleLayer::energy
(
    const scalar gap
) const
{
    return force(gap)/inverseDebyeLength_;
}


Foam::scalar Foam::colloid::weakOverlapDoubleLayer::decayLength() const
{
    return 1/inverseDebyeLength_;
}


// ************************************************************************* //
