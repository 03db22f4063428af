/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "constantFriction.H"
#include "addToRunTimeSelectionTable.H"
#include "readInRange.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace colloid
{
    defineTypeNameAndDebug(constantFriction, 0);
    addToRunTimeSelectionTable(plateletFriction, constantFriction, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::constantFriction::constantFriction(const scalar value)
:
    value_(value)
{}


Foam::colloid::constantFriction::constantFriction
(
    const dictionary& dict,
    const platelet&,
    const water&
)
:
    value_(readInRange(dict, "value", 1e-15, 1, "N s/m"))
{}


Foam::autoPtr<Foam::colloid::plateletFriction>
Foam::colloid::constantFriction::clone() const
{
    return autoPtr<plateletFriction>(new constantFriction(*this));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::constantFriction::value(const scalar) const
{
    return value_;
}


bool Foam::colloid::constantFriction::varies() const
{
    return false;
}


// ************************************************************************* //
