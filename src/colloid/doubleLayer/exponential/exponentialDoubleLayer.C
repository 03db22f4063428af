/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exponentialDoubleLayer.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "readInRange.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace colloid
{
    defineTypeNameAndDebug(exponentialDoubleLayer, 0);
    addToRunTimeSelectionTable
    (
        doubleLayer,
        exponentialDoubleLayer,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::exponentialDoubleLayer::exponentialDoubleLayer
(
    const dictionary& dict,
    const platelet& clay,
    const water&
)
:
    inverseDecayLength_(readInRange(dict, "kappa", 1, 1e12, "1/m")),
    scale_(readInRange(dict, "P0", 0, 1e12, "Pa")*clay.faceArea())
{
    checkWords(dict, wordList({"model", "P0", "kappa", "distance"}));

    const word distance
    (
        dict.getOrDefault<word>("distance", "gap", keyType::LITERAL)
    );

    checkChoice(dict, "distance", distance, wordList({"gap", "centres"}));

    if (distance == "centres")
    {
        scale_ *= std::exp(-inverseDecayLength_*clay.thickness);
    }
}


Foam::autoPtr<Foam::colloid::doubleLayer>
Foam::colloid::exponentialDoubleLayer::clone() const
{
    return autoPtr<doubleLayer>(new exponentialDoubleLayer(*this));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::exponentialDoubleLayer::force
(
    const scalar gap
) const
{
    return scale_*std::exp(-inverseDecayLength_*gap);
}


Foam::scalar Foam::colloid::exponentialDoubleLayer::slope
(
    const scalar gap
) const
{
    return -inverseDecayLength_*force(gap);
}


Foam::scalar Foam::colloid::exponentialDoubleLayer::energy
(
    const scalar gap
) const
{
    return force(gap)/inverseDecayLength_;
}


Foam::scalar Foam::colloid::exponentialDoubleLayer::decayLength() const
{
    return 1/inverseDecayLength_;
}


// ************************************************************************* //
