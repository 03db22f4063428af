/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "StokesSystem.H"
#include "basicSymmetryFvPatchFields.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "fixedValueFvPatchFields.H"
#include "fvcSnGrad.H"
#include "fvcSurfaceIntegrate.H"
#include "linear.H"
#include "partialSlipFvPatchFields.H"
#include "reverseLinear.H"
#include "wallFvPatch.H"

namespace Foam
{

//- 1/(the values' reciprocals weighted with the distances to the face)
static tmp<surfaceScalarField> harmonicMean(const volScalarField& values)
{
    return 1/reverseLinear<scalar>(values.mesh()).interpolate(1/values);
}

//- Cell gradient or value of a face quantity, with boundary values
template<class Type>
static tmp<GeometricField<Type, fvPatchField, volMesh>> cellAverage
(
    const GeometricField<Type, fvsPatchField, surfaceMesh>& faceIntegral
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> volField;

    const fvMesh& mesh = faceIntegral.mesh();

    tmp<volField> tresult
    (
        new volField
        (
            IOobject("gradient", mesh.time().timeName(), mesh),
            mesh,
            dimensioned<Type>(faceIntegral.dimensions()/dimVolume, Zero),
            extrapolatedCalculatedFvPatchField<Type>::typeName
        )
    );
    fvc::surfaceIntegrate(tresult.ref().primitiveFieldRef(), faceIntegral);
    tresult.ref().correctBoundaryConditions();

    return tresult;
}

} // End namespace Foam


bool Foam::StokesSystem::given(const fvPatchVectorField& Up)
{
    return isA<fixedValueFvPatchVectorField>(Up);
}


bool Foam::StokesSystem::impermeable(const fvPatchVectorField& Up)
{
    return
        isA<wallFvPatch>(Up.patch())
     || isA<basicSymmetryFvPatchVectorField>(Up)
     || isA<partialSlipFvPatchVectorField>(Up);
}


Foam::tmp<Foam::surfaceVectorField> Foam::StokesSystem::transposedGradient
(
    const volVectorField& U,
    const surfaceVectorField& normalGradient
) const
{
    // = U_f of the class description, d_P/(d_P + d_N) = 1 - linear weight
    const surfaceVectorField faceU(linearInterpolate(nu_*U)/linearViscosity_);

    const volTensorField cellGradient(cellAverage<tensor>(mesh_.Sf()*faceU));

    const surfaceVectorField n(mesh_.Sf()/mesh_.magSf());

    // Component i: d_i U_n. Across the face it is the compact gradient
    surfaceVectorField result(linearInterpolate(cellGradient) & n);
    result += n*((normalGradient & n) - (result & n));

    // Along walls and planes of symmetry U_n does not vary
    surfaceVectorField::Boundary& resultb = result.boundaryFieldRef();

    forAll(resultb, patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];

        if (impermeable(Up))
        {
            const vectorField np(Up.patch().nf());
            resultb[patchi] = np*(np & normalGradient.boundaryField()[patchi]);
        }
    }

    return tmp<surfaceVectorField>(new surfaceVectorField(result));
}


Foam::StokesSystem::StokesSystem
(
    const volScalarField& nu,
    const volVectorField& U,
    const vector g
)
:
    mesh_(nu.mesh()),
    nu_(nu),
    g_(g),
    faceViscosity_(harmonicMean(nu)),
    linearViscosity_(linearInterpolate(nu)),
    mobility_
    (
        IOobject("mobility", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimTime, Zero),
        extrapolatedCalculatedFvPatchScalarField::typeName
    ),
    faceMobility_
    (
        IOobject("faceMobility", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimTime, Zero)
    )
{
    // Distance-weighted conductance of the faces, boundary ones where U is
    // given
    scalarField diagonal(mesh_.nCells(), Zero);

    const surfaceScalarField conductance
    (
        faceViscosity_*mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()
    );

    forAll(mesh_.neighbour(), facei)
    {
        diagonal[mesh_.owner()[facei]] += conductance[facei];
        diagonal[mesh_.neighbour()[facei]] += conductance[facei];
    }

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];

        if (Up.coupled() || given(Up))
        {
            forAll(Up, i)
            {
                diagonal[Up.patch().faceCells()[i]] +=
                    conductance.boundaryField()[patchi][i];
            }
        }
    }

    mobility_.primitiveFieldRef() = mesh_.V()/diagonal;
    mobility_.correctBoundaryConditions();
    faceMobility_ = harmonicMean(mobility_);
}


void Foam::StokesSystem::residual
(
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    flowState& r
) const
{
    U.correctBoundaryConditions();

    for (fvPatchScalarField& pp : p.boundaryFieldRef())
    {
        // The flux through it is that of U as it is, so p does not vary
        if (isA<fixedFluxPressureFvPatchScalarField>(pp))
        {
            refCast<fixedFluxPressureFvPatchScalarField>(pp).updateSnGrad
            (
                scalarField(pp.size(), Zero)
            );
        }
    }
    p.correctBoundaryConditions();

    const surfaceVectorField faceP(linearInterpolate(p)*mesh_.Sf());
    const surfaceVectorField normalGradient(fvc::snGrad(U));

    const surfaceVectorField force
    (
        faceViscosity_*mesh_.magSf()
       *(normalGradient + transposedGradient(U, normalGradient))
      - faceP
    );

    const scalarField& V = mesh_.V();

    // It adds to what is there
    r.momentum = Zero;
    fvc::surfaceIntegrate(r.momentum, force);
    r.momentum = V*(r.momentum + g_);

    const volVectorField gradP(cellAverage<vector>(faceP));

    phi = linearInterpolate(U) & mesh_.Sf();

    const surfaceScalarField pressureFlux
    (
        faceMobility_
       *(
            fvc::snGrad(p)*mesh_.magSf()
          - (linearInterpolate(gradP) & mesh_.Sf())
        )
    );

    phi.primitiveFieldRef() -= pressureFlux.primitiveField();

    surfaceScalarField::Boundary& phib = phi.boundaryFieldRef();

    forAll(phib, patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];

        if (Up.coupled() || p.boundaryField()[patchi].fixesValue())
        {
            phib[patchi] -= pressureFlux.boundaryField()[patchi];
        }
        else if (impermeable(Up))
        {
            phib[patchi] = 0;
        }
    }

    r.continuity = Zero;
    fvc::surfaceIntegrate(r.continuity, phi);
    r.continuity *= -V;
}


Foam::scalar Foam::StokesSystem::product
(
    const flowState& a,
    const flowState& b
) const
{
    const scalarField& V = mesh_.V();
    scalar sum = 0;

    forAll(V, i)
    {
        sum +=
            (a.momentum[i] & b.momentum[i])*mobility_[i]/V[i]
          + a.continuity[i]*b.continuity[i]*nu_[i]/V[i];
    }

    return returnReduce(sum, sumOp<scalar>());
}
