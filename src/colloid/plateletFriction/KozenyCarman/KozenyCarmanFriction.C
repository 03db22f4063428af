/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "KozenyCarmanFriction.H"
#include "StokesFriction.H"
#include "addToRunTimeSelectionTable.H"
#include "readInRange.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace colloid
{
    defineTypeNameAndDebug(KozenyCarmanFriction, 0);
    addToRunTimeSelectionTable
    (
        plateletFriction,
        KozenyCarmanFriction,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::KozenyCarmanFriction::KozenyCarmanFriction
(
    const platelet& clay,
    const water& solution,
    const scalar Kozeny
)
:
    Stokes_(StokesFriction(clay, solution).value(0)),
    bed_
    (
        clay.volume()*Kozeny*clay.specificSurface()*clay.specificSurface()
       *solution.viscosity
    ),
    fixedFraction_(-1)
{}


Foam::colloid::KozenyCarmanFriction::KozenyCarmanFriction
(
    const dictionary& dict,
    const platelet& clay,
    const water& solution
)
:
    KozenyCarmanFriction
    (
        clay,
        solution,
        readInRange(dict, "Kozeny", 0, 1000, "(-)")
    )
{
    fixedFraction_ =
        numberOrWord(dict, "fraction", "local", 0, 0.999, "(-)").value_or(-1);
}


Foam::autoPtr<Foam::colloid::plateletFriction>
Foam::colloid::KozenyCarmanFriction::clone() const
{
    return autoPtr<plateletFriction>(new KozenyCarmanFriction(*this));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::KozenyCarmanFriction::value
(
    const scalar fraction
) const
{
    const scalar phi = fixedFraction_ < 0 ? fraction : fixedFraction_;

    return Stokes_ + bed_*phi/((1 - phi)*(1 - phi));
}


Foam::scalar Foam::colloid::KozenyCarmanFriction::slope
(
    const scalar fraction
) const
{
    return varies() ? bed_*(1 + fraction)/pow3(1 - fraction) : 0;
}


bool Foam::colloid::KozenyCarmanFriction::varies() const
{
    return fixedFraction_ < 0;
}


// ************************************************************************* //
