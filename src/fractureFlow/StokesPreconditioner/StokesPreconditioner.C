/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "StokesPreconditioner.H"
#include "fixedValueFvPatchFields.H"
#include "fvcSurfaceIntegrate.H"
#include "gaussLaplacianScheme.H"
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


template<class Type>
Foam::autoPtr<Foam::fvMatrix<Type>> Foam::StokesPreconditioner::makeMatrix
(
    const surfaceScalarField& conductance,
    GeometricField<Type, fvPatchField, volMesh>& field,
    scalar& scale
) const
{
    auto matrix = autoPtr<fvMatrix<Type>>::New
    (
       -fv::gaussLaplacianScheme<Type, scalar>::fvmLaplacianUncorrected
        (
            conductance*mesh_.magSf(),
            mesh_.nonOrthDeltaCoeffs(),
            field
        )
    );

    // Of the interior, since a mesh without walls has no other
    scale = gAverage(matrix().diag());

    matrix() *= dimensionedScalar("scale", dimless, 1/scale);

    return matrix;
}


template<class Type>
void Foam::StokesPreconditioner::solve
(
    fvMatrix<Type>& matrix,
    const scalar scale,
    GeometricField<Type, fvPatchField, volMesh>& field,
    const Field<Type>& source,
    const dictionary& controls
)
{
    field == dimensioned<Type>("zero", field.dimensions(), Zero);

    const scalar size = gAverage(mag(source)());

    if (size > 0)
    {
        matrix.source() = source/size;

        // Without a line in the log
        const int logged = SolverPerformance<Type>::debug;
        SolverPerformance<Type>::debug = 0;
        matrix.solve(controls);
        SolverPerformance<Type>::debug = logged;

        field.primitiveFieldRef() *= size/scale;
        field.correctBoundaryConditions();
    }
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
        FatalErrorInFunction
            << "Nothing holds the water: creeping flow needs a patch with a"
            << " given velocity" << nl
            << "(noSlip on a wall, fixedValue on an inlet) in 0/U"
            << exit(FatalError);
    }

    A_ = makeMatrix(system_.faceViscosity(), dU_, scaleA_);
}


void Foam::StokesPreconditioner::makeL(const volScalarField& p)
{
    vectorField unitForce(mesh_.nCells(), vector::one);
    unitForce *= mesh_.V();

    solve(A_(), scaleA_, dU_, unitForce, velocityControls_);

    // The inner solution need not be positive everywhere
    const scalar floor = 1e-12*gMax(mag(dU_.primitiveField())());
    for (vector& w : dU_.primitiveFieldRef())
    {
        w = max(w, floor*vector::one);
    }
    dU_.correctBoundaryConditions();

    const surfaceVectorField n(mesh_.Sf()/mesh_.magSf());

    L_ = makeMatrix
    (
        (cmptMultiply(linearInterpolate(dU_), n) & n)(),
        dp_,
        scaleL_
    );

    // Any level of p does where none is given
    if (p.needReference())
    {
        L_->setReference(Pstream::master() ? 0 : -1, 0);
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
    ),
    scaleA_(1),
    scaleL_(1)
{
    makeA(U);
    makeL(p);
}


void Foam::StokesPreconditioner::apply(const flowState& r, flowState& z)
{
    solve(L_(), scaleL_, dp_, r.continuity, pressureControls_);

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

    solve
    (
        A_(),
        scaleA_,
        dU_,
        (r.momentum - mesh_.V()*pressureForce)(),
        velocityControls_
    );
    z.momentum = dU_.primitiveField();
}
