/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "water.H"
#include "physicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::water::inverseDebyeLength() const
{
    using namespace physicalConstants;

    return
        Faraday*valence
       *std::sqrt
        (
            2*concentration
           /(vacuumPermittivity*relativePermittivity*gas*temperature)
        );
}


Foam::scalar Foam::colloid::water::reducedSurfaceCharge
(
    const platelet& clay
) const
{
    using namespace physicalConstants;

    return
        valence*Faraday*clay.surfaceCharge
       /(
            2*vacuumPermittivity*relativePermittivity
           *inverseDebyeLength()*gas*temperature
        );
}


Foam::scalar Foam::colloid::water::surfacePotential(const platelet& clay) const
{
    return 2*std::asinh(reducedSurfaceCharge(clay));
}


Foam::scalar Foam::colloid::water::thermalEnergy() const
{
    return physicalConstants::Boltzmann*temperature;
}


Foam::scalar Foam::colloid::water::ionPressure() const
{
    return 2*concentration*physicalConstants::gas*temperature;
}


// ************************************************************************* //
