/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "saltTransport.H"
#include "checkWords.H"
#include "errorAt.H"
#include "fvm.H"
#include "linear.H"
#include "readInRange.H"
#include "unreadField.H"

Foam::saltTransport::saltTransport
(
    const fvMesh& mesh,
    const dictionary& properties
)
:
    diffusivity_(0)
{
    const dictionary& salt = properties.subOrEmptyDict("salt");
    colloid::checkWords(salt, wordList({"model", "diffusivity"}));

    const word model
    (
        salt.getOrDefault<word>("model", "uniform", keyType::LITERAL)
    );
    if (salt.size())
    {
        colloid::checkChoice
        (
            salt, "model", model, wordList({"uniform", "transported"})
        );
    }
    if (model == "uniform")
    {
        Info<< "Salt uniform: concentration of clayProperties" << endl;
        colloid::sayUnread
        (
            mesh.time(),
            "c",
            "salt uniform, concentration of water (clayProperties) is"
        );
        return;
    }

    diffusivity_ = colloid::readInRange
    (
        salt, "diffusivity", 1.6e-9, 0, 1e-6, "m2/s"
    );
    c_.reset
    (
        new volScalarField
        (
            IOobject
            (
                "c",
                mesh.time().timeName(),
                mesh,
                IOobject::MUST_READ,
                IOobject::AUTO_WRITE
            ),
            mesh
        )
    );

    const dimensionSet mol(0, -3, 0, 0, 1);
    if (c_->dimensions() != mol)
    {
        colloid::errorAt(c_->objectPath(), wordList({"dimensions"}))
            << c_->objectPath() << " has dimensions " << c_->dimensions()
            << nl << "Valid: concentration of the cation in mol/m3, " << mol
            << exit(FatalIOError);
    }
    if (gMin(c_->primitiveField()) < 0)
    {
        colloid::errorAt(c_->objectPath(), wordList({"internalField"}))
            << c_->objectPath() << " has a negative concentration"
            << exit(FatalIOError);
    }
    Info<< "Salt transported: D " << diffusivity_ << " m2/s, c from "
        << gMin(c_->primitiveField()) << " to "
        << gMax(c_->primitiveField()) << " mol/m3" << endl;
}


void Foam::saltTransport::solve
(
    const surfaceScalarField& phi,
    const volScalarField& apertureRatio
)
{
    if (!c_.valid())
    {
        return;
    }

    const surfaceScalarField D
    (
        linearInterpolate(apertureRatio)
       *dimensionedScalar("D", dimViscosity, diffusivity_)
    );
    const int logged = SolverPerformance<scalar>::debug;
    SolverPerformance<scalar>::debug = 0;

    // Limited schemes are of the c before: again, until that is the new one
    for (label corrector = 0; corrector < 3; ++corrector)
    {
        fvScalarMatrix equation
        (
            fvm::ddt(apertureRatio, *c_)
          + fvm::div(phi, *c_, "div(phi,c)")
          - fvm::laplacian(D, *c_, "laplacian(D,c)")
        );
        equation.solve();
    }
    SolverPerformance<scalar>::debug = logged;
}
