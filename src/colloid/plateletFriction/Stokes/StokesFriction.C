/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "StokesFriction.H"
#include "addToRunTimeSelectionTable.H"
#include "physicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace colloid
{
    defineTypeNameAndDebug(StokesFriction, 0);
    addToRunTimeSelectionTable(plateletFriction, StokesFriction, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::StokesFriction::StokesFriction
(
    const platelet& clay,
    const water& solution
)
:
    value_(6*physicalConstants::pi*solution.viscosity*clay.frictionRadius())
{}


Foam::colloid::StokesFriction::StokesFriction
(
    const dictionary&,
    const platelet& clay,
    const water& solution
)
:
    StokesFriction(clay, solution)
{}


Foam::autoPtr<Foam::colloid::plateletFriction>
Foam::colloid::StokesFriction::clone() const
{
    return autoPtr<plateletFriction>(new StokesFriction(*this));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::StokesFriction::value(const scalar) const
{
    return value_;
}


bool Foam::colloid::StokesFriction::varies() const
{
    return false;
}


// ************************************************************************* //
