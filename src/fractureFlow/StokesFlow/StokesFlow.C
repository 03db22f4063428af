/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "StokesFlow.H"
#include "StokesIteration.H"
#include "StokesPreconditioner.H"
#include "StokesSystem.H"
#include "LiuCoVolume.H"
#include "checkWords.H"
#include "errorAt.H"
#include "readInRange.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fractureFlows
{
    defineTypeNameAndDebug(StokesFlow, 0);
    addToRunTimeSelectionTable(fractureFlow, StokesFlow, dictionary);
}
}


Foam::dictionary Foam::fractureFlows::StokesFlow::solverControls
(
    const word& fieldName,
    const scalar relTol
) const
{
    const dictionary solvers(mesh().solutionDict().subOrEmptyDict("solvers"));

    dictionary controls;

    if (solvers.found(fieldName, keyType::REGEX))
    {
        controls = solvers.subDict(fieldName);
    }
    else
    {
        controls.add("solver", "PCG");
        controls.add("preconditioner", "DIC");
        controls.add("tolerance", 0);
        controls.add("relTol", relTol);
    }

    // One line per solution is enough; from v2112 on this switches it off
    controls.add("log", 0);

    return controls;
}


void Foam::fractureFlows::StokesFlow::readControls()
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
            "residual", "maxIterations", "directions", "notConverged",
            "pRefCell", "pRefValue"
        })
    );

    residual_ =
        colloid::readInRange(controls, "residual", 1e-8, 1e-14, 1, "(-)");
    maxIterations_ =
        colloid::readInRange(controls, "maxIterations", 500, 1, 1e6, "(-)");
    nDirections_ =
        colloid::readInRange(controls, "directions", 30, 1, 1000, "(-)");

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

    velocityControls_ = solverControls("U", 1e-3);
    pressureControls_ = solverControls("p", 1e-2);
}


void Foam::fractureFlows::StokesFlow::checkBoundaryConditions() const
{
    forAll(p().boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U().boundaryField()[patchi];
        const fvPatchScalarField& pp = p().boundaryField()[patchi];

        if (StokesSystem::given(Up) && pp.fixesValue() && !pp.coupled())
        {
            colloid::errorAt
            (
                p().objectPath(), wordList({"boundaryField", pp.patch().name()})
            )
                << "On patch " << pp.patch().name() << " both U ("
                << Up.type() << ") and p (" << pp.type()
                << ") are given, which is one too many" << nl
                << "Inlet or outlet by pressure: zeroGradient for U;"
                << " by velocity, and wall: zeroGradient for p"
                << exit(FatalIOError);
        }
    }
}


Foam::fractureFlows::StokesFlow::StokesFlow
(
    fvMesh& mesh,
    const volScalarField& alpha,
    const dictionary& coeffs
)
:
    pressureFlow(mesh, alpha, coeffs)
{
    colloid::checkWords
    (
        coeffs, wordList({"pressureGradient", "pressureGradientCoeffs"})
    );
    checkBoundaryConditions();
    readControls();
}


Foam::scalar Foam::fractureFlows::StokesFlow::drivingResidual
(
    const StokesSystem& system
)
{
    const vectorField U0(U().primitiveField());
    const scalarField p0(p().primitiveField());

    URef().primitiveFieldRef() = Zero;
    pRef().primitiveFieldRef() = Zero;

    flowState r(mesh().nCells());
    system.residual(URef(), pRef(), phiRef(), r);

    checkInflow(residual_);

    URef().primitiveFieldRef() = U0;
    pRef().primitiveFieldRef() = p0;

    return Foam::sqrt(system.product(r, r));
}


void Foam::fractureFlows::StokesFlow::iterate
(
    const StokesSystem& system,
    const scalar unit
)
{
    flowState r(mesh().nCells());
    system.residual(URef(), pRef(), phiRef(), r);
    residuals_.append(Foam::sqrt(system.product(r, r))/unit);

    if (residuals_.last() <= residual_)
    {
        return;
    }

    StokesPreconditioner preconditioner
    (
        system,
        U(),
        p(),
        velocityControls_,
        pressureControls_
    );

    StokesIteration iteration
    (
        system,
        preconditioner,
        URef(),
        pRef(),
        phiRef(),
        r,
        nDirections_
    );

    while (residuals_.last() > residual_ && residuals_.size() <= maxIterations_)
    {
        iteration.advance();
        scalar size = iteration.size()/unit;

        // That one was summed up from steps; see what it is
        if (size <= residual_ || residuals_.size() == maxIterations_)
        {
            iteration.evaluate();
            size = iteration.size()/unit;
        }
        residuals_.append(size);
    }
}


void Foam::fractureFlows::StokesFlow::solve()
{
    readControls();

    const StokesSystem system(nu(), U(), drivingForce());
    const scalar unit = drivingResidual(system);

    residuals_.clear();

    if (unit > 0)
    {
        iterate(system, unit);
    }
    else
    {
        // Nothing drives the water; the solution is known
        URef().primitiveFieldRef() = Zero;
        pRef().primitiveFieldRef() = Zero;

        flowState r(mesh().nCells());
        system.residual(URef(), pRef(), phiRef(), r);
        residuals_.append(0);
    }

    setPressureLevel(mesh().solutionDict().subOrEmptyDict(typeName));

    // The first, and those that are harder: a run's log has a line per step
    if (residuals_.size() > mostResiduals_)
    {
        mostResiduals_ = residuals_.size();
        Info<< "Stokes: residual " << residuals_.first() << " -> "
            << residuals_.last() << ", " << residuals_.size() - 1
            << " iterations" << endl;
    }

    if (residuals_.last() > residual_)
    {
        if (errorIfNotConverged_)
        {
            FatalIOErrorInFunction
            (
                mesh().solutionDict().subOrEmptyDict(typeName)
            )
                << "The residual is still " << residuals_.last() << " after "
                << maxIterations_ << " iterations; " << residual_
                << " was asked for" << nl
                << "In system/fvSolution, Stokes { residual; maxIterations;"
                << " notConverged warning; } decide about it"
                << exit(FatalIOError);
        }
        WarningInFunction
            << "Residual " << residual_ << " not reached" << endl;
    }
}
