/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "StokesPreconditioner.H"
#include "errorAt.H"
#include "fixedValueFvPatchFields.H"
#include "fvcSurfaceIntegrate.H"
#include "linear.H"
#include "slipFvPatchFields.H"
#include "zeroGradientFvPatchFields.H"

Foam::wordList Foam::StokesPreconditioner::correctionTypes
(
    const volVectorField& U
)
{
    wordList types
    (
        U.boundaryField().size(),
        zeroGradientFvPatchVectorField::typeName
    );

    forAll(types, patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];

        if (StokesSystem::given(Up))
        {
            types[patchi] = fixedValueFvPatchVectorField::typeName;
        }
        else if (StokesSystem::slips(Up))
        {
            types[patchi] = slipFvPatchVectorField::typeName;
        }
    }

    return types;
}


Foam::wordList Foam::StokesPreconditioner::correctionTypes
(
    const volScalarField& p
)
{
    wordList types
    (
        p.boundaryField().size(),
        zeroGradientFvPatchScalarField::typeName
    );

    forAll(types, patchi)
    {
        if (p.boundaryField()[patchi].fixesValue())
        {
            types[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }

    return types;
}


void Foam::StokesPreconditioner::makeA(const volVectorField& U)
{
    bool held = false;
    for (const fvPatchVectorField& Up : U.boundaryField())
    {
        held = held || (StokesSystem::given(Up) && Up.size());
    }

    if (!returnReduce(held, orOp<bool>()))
    {
        colloid::errorAt(U.objectPath(), wordList({"boundaryField"}))
            << "Nothing holds the water: creeping flow needs a patch with a"
            << " given velocity" << nl
            << "(noSlip on a wall, fixedValue on an inlet) in 0/U"
            << exit(FatalIOError);
    }

    A_.reset(new scaledLaplacian<vector>(system_.faceViscosity(), dU_));
}


void Foam::StokesPreconditioner::makeL(const volScalarField& p)
{
    vectorField unitForce(mesh_.nCells(), vector::one);
    unitForce *= mesh_.V();

    A_->solve(dU_, unitForce, velocityControls_);

    // The inner solution need not be positive everywhere
    const scalar floor = 1e-12*gMax(mag(dU_.primitiveField())());
    for (vector& w : dU_.primitiveFieldRef())
    {
        w = max(w, floor*vector::one);
    }
    dU_.correctBoundaryConditions();

    const surfaceVectorField n(mesh_.Sf()/mesh_.magSf());

    L_.reset
    (
        new scaledLaplacian<scalar>
        (
            (cmptMultiply(linearInterpolate(dU_), n) & n)(),
            dp_
        )
    );

    // Any level of p does where none is given
    if (p.needReference())
    {
        L_->hold();
    }
}


Foam::StokesPreconditioner::StokesPreconditioner
(
    const StokesSystem& system,
    const volVectorField& U,
    const volScalarField& p,
    const dictionary& velocityControls,
    const dictionary& pressureControls
)
:
    system_(system),
    mesh_(U.mesh()),
    velocityControls_(velocityControls),
    pressureControls_(pressureControls),
    dU_
    (
        IOobject
        (
            "dU",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedVector(U.dimensions(), Zero),
        correctionTypes(U)
    ),
    dp_
    (
        IOobject
        (
            "dp",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar(p.dimensions(), Zero),
        correctionTypes(p)
    )
{
    makeA(U);
    makeL(p);
}


void Foam::StokesPreconditioner::apply(const flowState& r, flowState& z)
{
    L_->solve(dp_, r.continuity, pressureControls_);

    z.continuity =
        dp_.primitiveField()
      + system_.nu().primitiveField()*r.continuity/mesh_.V();

    dp_.primitiveFieldRef() = z.continuity;
    dp_.correctBoundaryConditions();

    vectorField pressureForce(mesh_.nCells(), Zero);
    fvc::surfaceIntegrate
    (
        pressureForce,
        system_.pressureForce(dp_)()
    );

    A_->solve
    (
        dU_,
        (r.momentum - mesh_.V()*pressureForce)(),
        velocityControls_
    );
    z.momentum = dU_.primitiveField();
}
