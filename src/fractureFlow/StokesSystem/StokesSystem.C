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
#include "harmonicMean.H"
#include "linear.H"
#include "partialSlipFvPatchFields.H"
#include "wallFvPatch.H"

namespace Foam
{

//- Sum over the faces of a cell over its volume, on boundaries the cell's
template<class Type>
static tmp<GeometricField<Type, fvPatchField, volMesh>> cellDivergence
(
    const GeometricField<Type, fvsPatchField, surfaceMesh>& outward
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> volField;

    const fvMesh& mesh = outward.mesh();

    tmp<volField> tresult
    (
        new volField
        (
            IOobject("cellDivergence", mesh.time().timeName(), mesh),
            mesh,
            dimensioned<Type>("zero", outward.dimensions()/dimVolume, Zero),
            extrapolatedCalculatedFvPatchField<Type>::typeName
        )
    );
    fvc::surfaceIntegrate(tresult.ref().primitiveFieldRef(), outward);
    tresult.ref().correctBoundaryConditions();

    return tresult;
}

} // End namespace Foam


bool Foam::StokesSystem::given(const fvPatchVectorField& Up)
{
    return isA<fixedValueFvPatchVectorField>(Up);
}


bool Foam::StokesSystem::slips(const fvPatchVectorField& Up)
{
    return
        isA<basicSymmetryFvPatchVectorField>(Up)
     || isA<partialSlipFvPatchVectorField>(Up);
}


void Foam::StokesSystem::makeMobility(const volVectorField& U)
{
    const surfaceScalarField conductance
    (
        faceViscosity_*mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()
    );

    scalarField diagonal(mesh_.nCells(), Zero);

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


Foam::tmp<Foam::surfaceVectorField> Foam::StokesSystem::faceVelocity
(
    const volVectorField& U
) const
{
    // The linear weight of P is d_N/(d_P + d_N)
    return linearInterpolate(nu_*U)/meanViscosity_;
}


Foam::tmp<Foam::surfaceVectorField> Foam::StokesSystem::pressureForce
(
    const volScalarField& p
) const
{
    return linearInterpolate(p/nu_)/meanFluidity_*mesh_.Sf();
}


Foam::tmp<Foam::volVectorField> Foam::StokesSystem::pressureGradient
(
    const volScalarField& p
) const
{
    return cellDivergence<vector>(pressureForce(p)());
}


Foam::tmp<Foam::volVectorField> Foam::StokesSystem::transposedForce
(
    const volVectorField& U
) const
{
    return cellDivergence<vector>
    (
        (
            faceViscosity_*mesh_.magSf()
           *transposedGradient(U, fvc::snGrad(U)())
        )()
    );
}


Foam::tmp<Foam::surfaceVectorField> Foam::StokesSystem::transposedGradient
(
    const volVectorField& U,
    const surfaceVectorField& normalGradient
) const
{
    const volTensorField cellGradient
    (
        cellDivergence<tensor>(mesh_.Sf()*faceVelocity(U))
    );

    const surfaceVectorField n(mesh_.Sf()/mesh_.magSf());

    // Component i is the derivative of U_n along i. Along n it is compact
    tmp<surfaceVectorField> tresult(linearInterpolate(cellGradient) & n);
    surfaceVectorField& result = tresult.ref();
    result += n*((normalGradient & n) - (result & n));

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];

        if (slips(Up))
        {
            const vectorField np(Up.patch().nf());

            result.boundaryFieldRef()[patchi] =
                np*(np & normalGradient.boundaryField()[patchi]);
        }
    }

    return tresult;
}


Foam::tmp<Foam::surfaceScalarField> Foam::StokesSystem::flux
(
    const volVectorField& U,
    const volScalarField& p,
    const surfaceVectorField& pressureForce
) const
{
    tmp<surfaceScalarField> tphi(faceVelocity(U) & mesh_.Sf());
    surfaceScalarField& phi = tphi.ref();

    const volVectorField gradP(cellDivergence<vector>(pressureForce));

    const surfaceScalarField pressureFlux
    (
        faceMobility_
       *(
            fvc::snGrad(p)*mesh_.magSf()
          - (linearInterpolate(gradP) & mesh_.Sf())
        )
    );

    phi.primitiveFieldRef() -= pressureFlux.primitiveField();

    forAll(phi.boundaryField(), patchi)
    {
        fvsPatchScalarField& phip = phi.boundaryFieldRef()[patchi];
        const fvPatchVectorField& Up = U.boundaryField()[patchi];

        if (Up.coupled() || p.boundaryField()[patchi].fixesValue())
        {
            phip -= pressureFlux.boundaryField()[patchi];
        }
        else if (slips(Up))
        {
            // Not even round-off
            phip = 0;
        }
    }

    return tphi;
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
    meanViscosity_(linearInterpolate(nu)),
    meanFluidity_(linearInterpolate(1/nu)),
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
    makeMobility(U);
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
        // The flux there is that of U as it is, so p has no gradient
        if (isA<fixedFluxPressureFvPatchScalarField>(pp))
        {
            refCast<fixedFluxPressureFvPatchScalarField>(pp).updateSnGrad
            (
                scalarField(pp.size(), Zero)
            );
        }
    }
    p.correctBoundaryConditions();

    const surfaceVectorField pressureForce(this->pressureForce(p));
    const surfaceVectorField normalGradient(fvc::snGrad(U));

    const surfaceVectorField force
    (
        faceViscosity_*mesh_.magSf()
       *(normalGradient + transposedGradient(U, normalGradient))
      - pressureForce
    );

    const scalarField& V = mesh_.V();

    // surfaceIntegrate adds to what is there, and divides by the volume
    r.momentum = Zero;
    fvc::surfaceIntegrate(r.momentum, force);
    r.momentum = V*(r.momentum + g_);

    phi = flux(U, p, pressureForce);

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


Foam::scalar Foam::StokesSystem::stepLength(const flowState& step) const
{
    const scalarField& V = mesh_.V();
    scalar sum = 0;

    forAll(V, i)
    {
        sum +=
            V[i]
           *(
                magSqr(step.momentum[i])/mobility_[i]
              + sqr(step.continuity[i])/nu_[i]
            );
    }

    return returnReduce(sum, sumOp<scalar>());
}
