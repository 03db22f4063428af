/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localViscosityFlow.H"
#include "LiuCoVolume.H"
#include "checkWords.H"
#include "unreadField.H"
#include "readInRange.H"
#include "linear.H"
#include "fvcSurfaceIntegrate.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fractureFlows
{
    defineTypeNameAndDebug(localViscosityFlow, 0);
    addToRunTimeSelectionTable(fractureFlow, localViscosityFlow, dictionary);
}
}


void Foam::fractureFlows::localViscosityFlow::checkDivergence()
{
    const scalarField outflow
    (
        fvc::surfaceIntegrate(phi())().primitiveField()
    );
    const scalar divergence = gMax(mag(outflow));

    // Round-off of the sum over a cell's faces, in units of its largest flux
    const scalar largestFlux = gMax(mag(phi())().primitiveField());
    const scalar relative =
        gMax(mag(outflow*mesh().V()))/max(largestFlux, VSMALL);

    // Of the first flow, and where it becomes worse; not its round-off
    if (divergence > 10*maxDivergence_ || maxDivergence_ < 0)
    {
        maxDivergence_ = divergence;
        Info<< "localViscosity: max |div(U)| " << divergence << " 1/s, "
            << relative << " of the largest flux through a face" << endl;
    }

    if (relative > 1e-9)
    {
        FatalErrorInFunction
            << "The completed flow is not divergence-free: a cell gains "
            << relative << " of the largest flux through a face"
            << exit(FatalError);
    }
}


void Foam::fractureFlows::localViscosityFlow::checkAlongGel
(
    const vector& u0
)
{
    if (u0 == checked_)
    {
        return;
    }
    checked_ = u0;

    scalar across = 0;
    scalar all = 0;
    for (const label patchi : columns_->patches().sortedToc())
    {
        const vectorField& areas = mesh().Sf().boundaryField()[patchi];
        across += gSum(mag(u0 & areas));
        all += mag(u0)*gSum(mag(areas));
    }

    // That is dropped. A slightly bent gel can do without it
    if (across > 0.5*all)
    {
        FatalIOErrorInFunction(coeffs())
            << "U is " << u0 << " m/s at " << mesh().time().timeName()
            << " s, and " << across/all << " of it points"
            << " across the gel patch, through which nothing flows." << nl
            << "    Give a velocity along the patch; around a curved gel the"
            << " model Stokes finds the flow" << exit(FatalIOError);
    }
    if (across > 0.01*all && !saidAcross_)
    {
        saidAcross_ = true;
        WarningInFunction
            << across/all << " of U points across the gel patch, where it is"
            << " left out" << nl << endl;
    }
}


void Foam::fractureFlows::localViscosityFlow::reconstructU()
{
    URef().primitiveFieldRef() = velocityOfFlux();

    // The cell's value on the boundary, but for the flux
    forAll(U().boundaryField(), patchi)
    {
        if (!U().boundaryField()[patchi].coupled())
        {
            URef().boundaryFieldRef()[patchi] ==
                U().boundaryField()[patchi].patchInternalField()();
        }
    }
    URef().correctBoundaryConditions();
    volVectorField::Boundary& Ub = URef().boundaryFieldRef();

    forAll(Ub, patchi)
    {
        if (!Ub[patchi].coupled())
        {
            const fvPatch& patch = mesh().boundary()[patchi];
            const vectorField normal(patch.nf());

            Ub[patchi] == Ub[patchi]
              + normal
               *(
                    phi().boundaryField()[patchi]/patch.magSf()
                  - (normal & Ub[patchi])
                );
        }
    }
}


Foam::fractureFlows::localViscosityFlow::localViscosityFlow
(
    fvMesh& mesh,
    const volScalarField& alpha,
    const dictionary& coeffs
)
:
    fractureFlow(mesh, alpha, coeffs, IOobject::NO_READ),
    asPrinted_(false),
    maxDivergence_(-1),
    checked_(Zero),
    saidAcross_(false)
{
    colloid::checkWords
    (
        coeffs, wordList({"U", "UCoeffs", "gelPatch", "asPrinted"})
    );
    colloid::sayUnread
    (
        mesh.time(),
        "U",
        "it follows from U of localViscosityCoeffs (fractureFlowProperties)"
    );
    colloid::sayUnread(mesh.time(), "p", "model localViscosity has no pressure");

    velocity_ = colloid::readFunction1<vector>(coeffs, "U", "m/s");
    coeffs.readIfPresent("asPrinted", asPrinted_);

    if (!asPrinted_)
    {
        columns_.reset
        (
            new layeredColumns
            (
                mesh,
                coeffs.get<wordRe>("gelPatch"),
                this->coeffs()
            )
        );
        checkAlongGel(velocity_->value(mesh.time().value()));
    }
}


void Foam::fractureFlows::localViscosityFlow::solve()
{
    const dimensionedVector u0
    (
        "u0",
        dimVelocity,
        velocity_->value(mesh().time().value())
    );

    const volScalarField mobility("mobility", viscosity().nuWater()/nu());

    URef() == u0*mobility;
    phiRef() = linearInterpolate(U()) & mesh().Sf();

    if (!asPrinted_)
    {
        checkAlongGel(u0.value());
        columns_->completeFlux(phiRef());
        checkDivergence();
        reconstructU();
    }
}
