/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "NavierStokesFlow.H"
#include "StokesSystem.H"
#include "adjustPhi.H"
#include "checkWords.H"
#include "errorAt.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "findRefCell.H"
#include "fvcDdt.H"
#include "fvcDiv.H"
#include "fvcSurfaceIntegrate.H"
#include "fvmDdt.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "harmonicMean.H"
#include "linear.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fractureFlows
{
    defineTypeNameAndDebug(NavierStokesFlow, 0);
    addToRunTimeSelectionTable(fractureFlow, NavierStokesFlow, dictionary);
}
}


Foam::fractureFlows::NavierStokesFlow::NavierStokesFlow
(
    fvMesh& mesh,
    const volScalarField& alpha,
    const dictionary& coeffs
)
:
    pressureFlow(mesh, alpha, coeffs),
    pimple_(mesh, "PIMPLE", false)
{
    colloid::checkWords
    (
        coeffs, wordList({"pressureGradient", "pressureGradientCoeffs"})
    );

    setRefCell(p(), pimple_.dict(), pRefCell_, pRefValue_);
    mesh.setFluxRequired(p().name());

    IOobject phiFile(phi().name(), mesh.time().timeName(), mesh);

    if (!phiFile.typeHeaderOk<surfaceScalarField>(true))
    {
        phiRef() = linearInterpolate(U()) & mesh.Sf();
    }
}


template<class Type>
Foam::scalar Foam::fractureFlows::NavierStokesFlow::solveScaled
(
    fvMatrix<Type>& matrix,
    const dictionary& controls
)
{
    const scalar scale = gAverage(mag(matrix.diag())());

    matrix *= dimensionedScalar("scale", dimless, 1/scale);

    const int logged = SolverPerformance<Type>::debug;
    SolverPerformance<Type>::debug = 0;
    matrix.solve(controls);
    SolverPerformance<Type>::debug = logged;

    return scale;
}


void Foam::fractureFlows::NavierStokesFlow::predict
(
    fvVectorMatrix& UEqn,
    const StokesSystem& system
)
{
    fvVectorMatrix predictor(UEqn == -system.pressureGradient(p()));

    solveScaled
    (
        predictor,
        mesh().solver(U().select(pimple_.finalIter()))
    );
}


void Foam::fractureFlows::NavierStokesFlow::correct
(
    fvVectorMatrix& UEqn,
    const StokesSystem& system
)
{
    volVectorField& U = URef();
    volScalarField& p = pRef();
    surfaceScalarField& phi = phiRef();

    const volScalarField rAU("rAU", 1/UEqn.A());
    const surfaceScalarField rAUf("rAUf", harmonicMean(rAU));
    const volVectorField HbyA(constrainHbyA(rAU*UEqn.H(), U, p));

    surfaceScalarField phiHbyA
    (
        "phiHbyA",
        (system.faceVelocity(HbyA) & mesh().Sf())
      + rAUf*fvc::ddtCorr(U, phi)
    );

    if (p.needReference())
    {
        adjustPhi(phiHbyA, U, p);
    }
    constrainPressure(p, U, phiHbyA, rAUf);

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(rAUf, p, "laplacian(rAU,p)") == fvc::div(phiHbyA)
        );
        pEqn.setReference(pRefCell_, pRefValue_);

        const scalar scale = solveScaled
        (
            pEqn,
            mesh().solver(p.select(pimple_.finalInnerIter()))
        );

        if (pimple_.finalNonOrthogonalIter())
        {
            phi =
                phiHbyA - dimensionedScalar("scale", dimless, scale)*pEqn.flux();
        }
    }

    p.relax();

    U = HbyA - rAU*system.pressureGradient(p);
    U.correctBoundaryConditions();
}


void Foam::fractureFlows::NavierStokesFlow::reportContinuity()
{
    const scalarField gain
    (
        mesh().V()*fvc::surfaceIntegrate(phi())().primitiveField()
    );
    const scalar relative =
        gMax(mag(gain)())/max(max(mag(phi())).value(), VSMALL);

    if (relative > 10*mostGained_)
    {
        mostGained_ = relative;
        Info<< "NavierStokes: a cell gains at most " << relative
            << " of the largest flux through a face" << endl;
    }
}


void Foam::fractureFlows::NavierStokesFlow::refuseDivergence() const
{
    constexpr scalar farTooMany = 1000;

    const scalarField Courant
    (
        0.5*mesh().time().deltaTValue()
       *fvc::surfaceSum(mag(phi()))().primitiveField()/mesh().V()
    );

    // Not a number is not less either
    label nTooFast = 0;
    for (const scalar Co : Courant)
    {
        nTooFast += !(Co < farTooMany);
    }
    reduce(nTooFast, sumOp<label>());

    if (nTooFast)
    {
        colloid::errorAt(mesh().time().controlDict(), "deltaT")
            << "NavierStokes diverges: in a step of "
            << mesh().time().deltaTValue() << " s water passes more than "
            << farTooMany << " cells" << nl
            << "    (the Courant number), in " << nTooFast << " of the mesh" << nl
            << "    It is as stable as PIMPLE. Of gel that is free to move, and"
            << " of creeping flow in long steps," << nl
            << "    model Stokes or HeleShaw is the one; of flow with inertia,"
            << " take a shorter deltaT" << exit(FatalIOError);
    }
}


void Foam::fractureFlows::NavierStokesFlow::solve()
{
    const StokesSystem system(nu(), U(), Zero);
    const dimensionedVector force
    (
        "drivingForce", dimAcceleration, drivingForce()
    );

    while (pimple_.loop())
    {
        volVectorField& U = URef();

        fvVectorMatrix UEqn
        (
            fvm::ddt(U) + fvm::div(phi(), U)
          - fvm::laplacian(system.faceViscosity(), U, "laplacian(nu,U)")
         ==
            system.transposedForce(U) + force
        );
        UEqn.relax();

        if (pimple_.momentumPredictor())
        {
            predict(UEqn, system);
        }

        while (pimple_.correct())
        {
            correct(UEqn, system);
        }
    }

    refuseDivergence();
    reportContinuity();
}
