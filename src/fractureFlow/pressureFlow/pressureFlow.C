/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pressureFlow.H"
#include "LiuCoVolume.H"
#include "errorAt.H"
#include "readInRange.H"

Foam::fractureFlows::pressureFlow::pressureFlow
(
    fvMesh& mesh,
    const volScalarField& alpha,
    const dictionary& coeffs
)
:
    fractureFlow(mesh, alpha, coeffs, IOobject::MUST_READ),
    p_
    (
        IOobject
        (
            "p",
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    )
{
    if (coeffs.found("pressureGradient"))
    {
        pressureGradient_ =
            colloid::readFunction1<vector>(coeffs, "pressureGradient", "Pa/m");
    }

    if (p_.dimensions() != dimPressure/dimDensity)
    {
        colloid::errorAt(p_.objectPath(), wordList({"dimensions"}))
            << p_.objectPath() << " has dimensions " << p_.dimensions() << nl
            << "The flow models need the kinematic pressure,"
            << " [0 2 -2 0 0 0 0], as OpenFOAM's incompressible solvers do"
            << exit(FatalIOError);
    }
}


Foam::vector Foam::fractureFlows::pressureFlow::drivingForce()
{
    if (!pressureGradient_.valid())
    {
        return Zero;
    }

    return
       -pressureGradient_->value(mesh().time().value())
       /viscosity().water().density;
}


void Foam::fractureFlows::pressureFlow::checkInflow
(
    const scalar tolerance
) const
{
    if (!p_.needReference())
    {
        return;
    }

    scalar net = 0;
    scalar gross = 0;

    for (const fvsPatchScalarField& phip : phi().boundaryField())
    {
        if (!phip.coupled())
        {
            net += sum(phip);
            gross += sumMag(phip);
        }
    }
    reduce(net, sumOp<scalar>());
    reduce(gross, sumOp<scalar>());

    if (mag(net) > tolerance*gross)
    {
        colloid::errorAt(U().objectPath(), wordList({"boundaryField"}))
            << "U is given on all patches, and " << net/gross
            << " of what passes them is left over" << nl
            << "Give p on an outlet (fixedValue, and zeroGradient for U), or"
            << " velocities that balance to the residual, " << tolerance
            << exit(FatalIOError);
    }
}


void Foam::fractureFlows::pressureFlow::setPressureLevel
(
    const dictionary& controls
)
{
    if (!p_.needReference())
    {
        return;
    }

    const label cell = controls.getOrDefault<label>("pRefCell", 0);
    const scalar value = controls.getOrDefault<scalar>("pRefValue", 0);

    // In parallel the cell is the master's, as for other OpenFOAM solvers
    scalar level = 0;
    if (Pstream::master() && cell < p_.size())
    {
        level = value - p_[cell];
    }
    reduce(level, sumOp<scalar>());

    p_ += dimensionedScalar("level", p_.dimensions(), level);
}
