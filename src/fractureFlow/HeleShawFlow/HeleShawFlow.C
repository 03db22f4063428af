/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "HeleShawFlow.H"
#include "LiuCoVolume.H"
#include "StokesSystem.H"
#include "basicSymmetryFvPatchFields.H"
#include "checkWords.H"
#include "errorAt.H"
#include "emptyFvPatch.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "fixedGradientFvPatchFields.H"
#include "fixedValueFvPatchFields.H"
#include "fvcSnGrad.H"
#include "fvcSurfaceIntegrate.H"
#include "harmonicMean.H"
#include "readInRange.H"
#include "unreadField.H"
#include "scaledLaplacian.H"
#include "zeroGradientFvPatchFields.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fractureFlows
{
    defineTypeNameAndDebug(HeleShawFlow, 0);
    addToRunTimeSelectionTable(fractureFlow, HeleShawFlow, dictionary);
}

//- Does U, and not p, say what passes the patch?
static bool fluxGiven(const fvPatchVectorField& Up)
{
    return StokesSystem::given(Up) || StokesSystem::slips(Up);
}
}


void Foam::fractureFlows::HeleShawFlow::readControls()
{
    const dictionary controls
    (
        mesh().solutionDict().subOrEmptyDict(typeName)
    );

    colloid::checkWords
    (
        controls,
        wordList
        ({
            "residual", "maxIterations", "notConverged", "pRefCell", "pRefValue"
        })
    );

    residual_ =
        colloid::readInRange(controls, "residual", 1e-10, 1e-15, 1, "(-)");
    maxIterations_ =
        colloid::readInRange(controls, "maxIterations", 100, 1, 1e6, "(-)");

    const word notConverged
    (
        controls.getOrDefault<word>("notConverged", "error")
    );
    colloid::checkChoice
    (
        controls,
        "notConverged",
        notConverged,
        wordList({"error", "warning"})
    );
    errorIfNotConverged_ = notConverged == "error";

    const dictionary solvers(mesh().solutionDict().subOrEmptyDict("solvers"));

    if (solvers.found("p", keyType::REGEX))
    {
        linearControls_ = solvers.subDict("p");
    }
    else
    {
        dictionary preconditioner;
        preconditioner.add("preconditioner", "GAMG");
        preconditioner.add("smoother", "DICGaussSeidel");
        preconditioner.add("tolerance", 0);
        preconditioner.add("relTol", 0);
        preconditioner.add("nVcycles", 1);

        linearControls_.clear();
        linearControls_.add("solver", "PCG");
        linearControls_.add("preconditioner", preconditioner);
        linearControls_.add("tolerance", 0);
        linearControls_.add("relTol", 1e-8);
    }

    // One line per solution is enough; from v2112 on this switches it off
    linearControls_.set("log", 0);
}


void Foam::fractureFlows::HeleShawFlow::checkBoundaryConditions() const
{
    forAll(p().boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U().boundaryField()[patchi];
        const fvPatchScalarField& pp = p().boundaryField()[patchi];

        const bool pGiven = isA<fixedValueFvPatchScalarField>(pp);
        const bool pLeft =
            isA<zeroGradientFvPatchScalarField>(pp)
         || isA<fixedFluxPressureFvPatchScalarField>(pp)
         || isA<basicSymmetryFvPatchScalarField>(pp);
        const bool gradientGiven =
            isA<fixedGradientFvPatchScalarField>(pp) && !pLeft;

        const char* wrong =
            pp.coupled() || isA<emptyFvPatch>(pp.patch()) ? nullptr
          : !pGiven && !pLeft && !gradientGiven
          ? "p is of a type that is not understood"
          : !pLeft && fluxGiven(Up)
          ? "both U and p are given, which is one too many"
          : pLeft && !fluxGiven(Up)
          ? "neither U nor p is given"
          : nullptr;

        if (wrong)
        {
            colloid::errorAt
            (
                p().objectPath(), wordList({"boundaryField", pp.patch().name()})
            )
                << "On patch " << pp.patch().name() << " " << wrong << " (U "
                << Up.type() << ", p " << pp.type() << ")" << nl
                << "Model " << typeName << " understands" << nl
                << "    edge                slip, noSlip    zeroGradient" << nl
                << "    inlet, outlet       zeroGradient    fixedValue" << nl
                << "    inlet by velocity   fixedValue      zeroGradient" << nl
                << "    inlet by gradient   zeroGradient    fixedGradient" << nl
                << "for U and p, in this order; symmetryPlane and cyclic"
                << exit(FatalIOError);
        }
    }
}


Foam::fractureFlows::HeleShawFlow::HeleShawFlow
(
    fvMesh& mesh,
    const volScalarField& alpha,
    const dictionary& coeffs
)
:
    pressureFlow(mesh, alpha, coeffs),
    aperture_(mesh, coeffs, viscosity().nuWater().value()),
    conductance_
    (
        IOobject("conductance", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimTime, Zero),
        zeroGradientFvPatchScalarField::typeName
    )
{
    colloid::checkWords
    (
        coeffs,
        wordList
        ({
            "aperture", "transmissivity", "pressureGradient",
            "pressureGradientCoeffs"
        })
    );
    if (gMax(mag(U().primitiveField())()) > 0)
    {
        colloid::sayUnread
        (
            mesh.time(),
            "U",
            "but for its boundary conditions, U follows from p"
        );
    }

    checkBoundaryConditions();
    readControls();
}


Foam::tmp<Foam::surfaceScalarField>
Foam::fractureFlows::HeleShawFlow::faceConductance()
{
    conductance_.primitiveFieldRef() =
        aperture_.ratio().primitiveField()
       *sqr(aperture_.aperture().primitiveField())
       /(12*nu().primitiveField());
    conductance_.correctBoundaryConditions();

    return harmonicMean(conductance_);
}


void Foam::fractureFlows::HeleShawFlow::updateBoundaries
(
    const surfaceScalarField& conductance,
    const surfaceScalarField& drive
)
{
    URef().correctBoundaryConditions();

    volScalarField::Boundary& pBoundary = pRef().boundaryFieldRef();
    surfaceScalarField::Boundary& phiBoundary = phiRef().boundaryFieldRef();

    forAll(pBoundary, patchi)
    {
        const fvPatchVectorField& Up = U().boundaryField()[patchi];
        const fvPatch& patch = Up.patch();
        scalarField& phip = phiBoundary[patchi];

        if (StokesSystem::slips(Up))
        {
            // Not even round-off
            phip = Zero;
        }
        else if (StokesSystem::given(Up))
        {
            phip =
                (Up & patch.Sf())
               *aperture_.ratio().boundaryField()[patchi];
        }

        if (isA<fixedFluxPressureFvPatchScalarField>(pBoundary[patchi]))
        {
            refCast<fixedFluxPressureFvPatchScalarField>
            (
                pBoundary[patchi]
            ).updateSnGrad
            (
                drive.boundaryField()[patchi]
              - phip/(conductance.boundaryField()[patchi]*patch.magSf())
            );
        }
    }

    pRef().correctBoundaryConditions();
}


void Foam::fractureFlows::HeleShawFlow::updateFlux
(
    const surfaceScalarField& conductance,
    const surfaceScalarField& drive
)
{
    const surfaceScalarField flux
    (
        conductance*mesh().magSf()*(drive - fvc::snGrad(p()))
    );

    phiRef().primitiveFieldRef() = flux.primitiveField();

    forAll(flux.boundaryField(), patchi)
    {
        if (!fluxGiven(U().boundaryField()[patchi]))
        {
            phiRef().boundaryFieldRef()[patchi] = flux.boundaryField()[patchi];
        }
    }
}


Foam::scalar Foam::fractureFlows::HeleShawFlow::roundOff
(
    const surfaceScalarField& conductance
) const
{
    return
        SMALL*gMax(mag(p().primitiveField())())
       *gMax
        (
            (conductance*mesh().magSf()*mesh().nonOrthDeltaCoeffs())()
           .primitiveField()
        );
}


Foam::scalar Foam::fractureFlows::HeleShawFlow::iterate
(
    const surfaceScalarField& conductance,
    const surfaceScalarField& drive
)
{
    wordList types
    (
        p().boundaryField().size(),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(types, patchi)
    {
        if (p().boundaryField()[patchi].fixesValue())
        {
            types[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }

    volScalarField dp
    (
        IOobject
        (
            "dp",
            mesh().time().timeName(),
            mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh(),
        dimensionedScalar(p().dimensions(), Zero),
        types
    );

    scaledLaplacian<scalar> laplacian(conductance, dp);

    // Any level of p does where none is given
    if (p().needReference())
    {
        laplacian.hold();
    }

    scalarField gain(mesh().nCells());

    for (iterations_ = 0; ; ++iterations_)
    {
        updateFlux(conductance, drive);

        gain = Zero;
        fvc::surfaceIntegrate(gain, phi());
        gain *= -mesh().V();

        const scalar largestFlux = max(mag(phi())).value();
        const scalar largestGain = gMax(mag(gain)());

        if
        (
            largestGain <= residual_*largestFlux
         || largestGain <= 10*roundOff(conductance)
         || iterations_ == maxIterations_
        )
        {
            return largestGain/max(largestFlux, VSMALL);
        }

        laplacian.solve(dp, gain, linearControls_);
        pRef().primitiveFieldRef() += dp.primitiveField();
        pRef().correctBoundaryConditions();
    }
}


void Foam::fractureFlows::HeleShawFlow::solve()
{
    readControls();

    const surfaceScalarField conductance(faceConductance());
    const surfaceScalarField drive
    (
        dimensionedVector("drivingForce", dimAcceleration, drivingForce())
      & (mesh().Sf()/mesh().magSf())
    );

    updateBoundaries(conductance, drive);
    checkInflow(residual_);

    const scalar residual = iterate(conductance, drive);

    setPressureLevel(mesh().solutionDict().subOrEmptyDict(typeName));

    URef().primitiveFieldRef() =
        velocityOfFlux()/aperture_.ratio().primitiveField();
    URef().correctBoundaryConditions();

    // The first, and those that are harder: a run's log has a line per step
    if (iterations_ > mostIterations_)
    {
        mostIterations_ = iterations_;
        Info<< "HeleShaw: a cell gains at most " << residual
            << " of the largest flux through a face, " << iterations_
            << " linear solutions" << endl;
    }

    if (iterations_ == maxIterations_ && residual > residual_)
    {
        if (errorIfNotConverged_)
        {
            FatalIOErrorInFunction
            (
                mesh().solutionDict().subOrEmptyDict(typeName)
            )
                << "A cell still gains " << residual << " of the largest flux"
                << " after " << maxIterations_ << " linear solutions; "
                << residual_ << " was asked for" << nl
                << "In system/fvSolution, HeleShaw { residual; maxIterations;"
                << " notConverged warning; } decide about it"
                << exit(FatalIOError);
        }
        WarningInFunction
            << "Residual " << residual_ << " not reached" << endl;
    }
}
