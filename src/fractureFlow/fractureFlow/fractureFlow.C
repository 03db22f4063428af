/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fractureFlow.H"
#include "LiuCoVolume.H"
#include "calculatedFvPatchFields.H"
#include "fvcSurfaceIntegrate.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
    defineTypeNameAndDebug(fractureFlow, 0);
    defineRunTimeSelectionTable(fractureFlow, dictionary);
}


Foam::autoPtr<Foam::volVectorField> Foam::fractureFlow::newU
(
    const fvMesh& mesh,
    const IOobject::readOption rOpt
)
{
    const IOobject io
    (
        "U",
        mesh.time().timeName(),
        mesh,
        rOpt,
        IOobject::AUTO_WRITE
    );

    if (rOpt == IOobject::MUST_READ)
    {
        return autoPtr<volVectorField>::New(io, mesh);
    }

    return autoPtr<volVectorField>::New
    (
        io,
        mesh,
        dimensionedVector(dimVelocity, Zero),
        calculatedFvPatchVectorField::typeName
    );
}


Foam::fractureFlow::fractureFlow
(
    fvMesh& mesh,
    const volScalarField& alpha,
    const dictionary& coeffs,
    const IOobject::readOption readU
)
:
    mesh_(mesh),
    alpha_(alpha),
    coeffs_(coeffs),
    U_(newU(mesh, readU)),
    phi_
    (
        IOobject
        (
            "phi",
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimVelocity*dimArea, Zero)
    )
{}


Foam::fractureFlow::~fractureFlow()
{}


Foam::viscosityModels::LiuCoVolume& Foam::fractureFlow::viscosity()
{
    if (!viscosity_.valid())
    {
        viscosity_.reset
        (
            new viscosityModels::LiuCoVolume("nu", *U_, phi_, alpha_)
        );
    }

    return *viscosity_;
}


Foam::tmp<Foam::vectorField> Foam::fractureFlow::velocityOfFlux() const
{
    // As fvc::reconstruct, which puts the product over one of its factors: on a
    // mesh that is not aligned to the last digit, components of U then come out
    // of those that are there already (GCC 12; a thousandth of U wrong)
    const surfaceVectorField normals(mesh_.Sf()/mesh_.magSf());
    const volTensorField shapes(fvc::surfaceSum(normals*mesh_.Sf()));
    const volTensorField inverse(inv(shapes));
    const volVectorField sums(fvc::surfaceSum(normals*phi_));

    return inverse.primitiveField() & sums.primitiveField();
}


const Foam::volScalarField& Foam::fractureFlow::nu()
{
    viscosity().correct();
    return viscosity().nuField();
}


const Foam::volScalarField& Foam::fractureFlow::apertureRatio()
{
    if (!apertureRatio_.valid())
    {
        apertureRatio_.reset
        (
            new volScalarField
            (
                IOobject("apertureRatio", mesh_.time().timeName(), mesh_),
                mesh_,
                dimensionedScalar("one", dimless, 1),
                zeroGradientFvPatchScalarField::typeName
            )
        );
    }

    return *apertureRatio_;
}
