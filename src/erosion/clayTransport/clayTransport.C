/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayTransport.H"
#include "checkWords.H"
#include "errorAt.H"
#include "readInRange.H"
#include "steadyStateDdtScheme.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::clayTransport::readControls()
{
    const dictionary& controls =
        mesh_.solutionDict().subOrEmptyDict("erosion");

    colloid::checkWords
    (
        controls,
        wordList({"tolerance", "residual", "maxIterations"})
    );
    tolerance_ = colloid::readInRange
    (
        controls, "tolerance", 1e-3, 1e-9, 1, "(-)"
    );
    residual_ = colloid::readInRange
    (
        controls, "residual", 1e-10, 1e-16, 1e-2, "(-)"
    );
    maxIterations_ = label
    (
        colloid::readInRange(controls, "maxIterations", 25, 1, 1e4, "(-)")
    );
}


void Foam::clayTransport::checkBounds() const
{
    // A run may leave what the residual allows
    const scalar slack = 10*residual_;
    const scalar least = gMin(alpha_.primitiveField());
    const scalar most = gMax(alpha_.primitiveField());

    if (least < -slack || most > packing_ + slack)
    {
        colloid::errorAt(alpha_.objectPath(), wordList({"internalField"}))
            << alpha_.name() << " is from " << least << " to " << most
            << " at the start" << nl
            << "Valid: solid fractions from 0 to packing in"
            << " erosionProperties, " << packing_
            << exit(FatalIOError);
    }
    forAll(alpha_.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = alpha_.boundaryField()[patchi];

        if (patch.size() && (min(patch) < -slack || max(patch) > packing_ + slack))
        {
            colloid::errorAt
            (
                alpha_.objectPath(),
                wordList({"boundaryField", patch.patch().name()})
            )
                << alpha_.name() << " on the patch "
                << patch.patch().name() << " is from " << min(patch)
                << " to " << max(patch) << nl
                << "Valid: solid fractions from 0 to packing in"
                << " erosionProperties, " << packing_
                << exit(FatalIOError);
        }
    }
}


void Foam::clayTransport::reportWater
(
    const volScalarField* salt,
    const colloid::clayProperties& matter
) const
{
    colloid::water solution(matter.waterAt(mesh_.time().value()));
    const auto inWater = [&](const scalar concentration)
    {
        solution.concentration = concentration;
        const auto viscosity = matter.viscosity(solution);

        Info<< "Water of " << concentration << " mol/m3"
            << (salt ? " at the start" : "") << ": clay ";
        if (viscosity.gels())
        {
            Info<< "stops flowing at a solid fraction of "
                << viscosity.gelFraction() << endl;
        }
        else
        {
            Info<< "flows at any solid fraction" << endl;
        }
    };

    if (salt)
    {
        // With what comes in, as it is now
        const scalar least = min(*salt).value();
        const scalar most = max(*salt).value();

        inWater(least);
        if (most > least)
        {
            inWater(most);
        }
    }
    else
    {
        inWater(solution.concentration);
    }

    for (const fvPatchScalarField& patch : alpha_.boundaryField())
    {
        if (patch.fixesValue())
        {
            const scalar least = returnReduce(min(patch), minOp<scalar>());
            const scalar most = returnReduce(max(patch), maxOp<scalar>());

            // Not of a patch without faces
            if (most >= least)
            {
                Info<< "    held at patch " << patch.patch().name() << ": "
                    << least;
                if (most > least)
                {
                    Info<< " to " << most;
                }
                Info<< endl;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::clayTransport::clayTransport
(
    volScalarField& alpha,
    const surfaceScalarField& phi,
    const volScalarField& apertureRatio,
    const volScalarField* salt,
    const colloid::clayProperties& matter,
    const dictionary& properties
)
:
    mesh_(alpha.mesh()),
    alpha_(alpha),
    content_(alpha),
    aperture_(apertureRatio),
    packing_
    (
        colloid::readInRange(properties, "packing", 0.65, 1e-3, 0.999, "(-)")
    ),
    flux_
    (
        alpha, phi, apertureRatio, salt, matter, properties, packing_
    ),
    alphaPhi_
    (
        IOobject
        (
            "alphaPhi",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedScalar(dimVolume/dimTime, Zero)
    ),
    rate_
    (
        IOobject
        (
            "alphaRate",
            mesh_.time().timeName(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            steady() ? IOobject::NO_WRITE : IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedScalar(dimless/dimTime, Zero)
    ),
    continued_(rate_.headerOk()),
    nextDeltaT_
    (
        IOobject
        (
            "nextDeltaT",
            mesh_.time().timeName(),
            "uniform",
            mesh_,
            IOobject::READ_IF_PRESENT,
            steady() ? IOobject::NO_WRITE : IOobject::AUTO_WRITE
        ),
        dimensionedScalar("nextDeltaT", dimTime, mesh_.time().deltaTValue())
    )
{
    readControls();
    checkBounds();

    Info<< "Clay: packing " << packing_ << ", ";
    if (!steady())
    {
        Info<< "tolerance of a step " << tolerance_ << ", ";
    }
    Info<< "residual " << residual_ << ", at most " << maxIterations_
        << " iterations of Newton's method" << endl;

    reportWater(salt, matter);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::clayTransport::steady() const
{
    ITstream& scheme = mesh_.ddtScheme("ddt(alpha.clay)");
    const word name(scheme);

    if (name != "steadyState" && name != "Euler")
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("ddtSchemes"))
            << "ddt(alpha.clay) by " << name << nl
            << "Valid: Euler, or steadyState for iterations to the steady"
            << " state" << exit(FatalIOError);
    }
    return name == "steadyState";
}


Foam::scalar Foam::clayTransport::clay() const
{
    return gSum
    (
        scalarField
        (
            aperture_.primitiveField()*alpha_.primitiveField()*mesh_.V()
        )
    );
}


void Foam::clayTransport::report(Ostream& os) const
{
    os  << "Clay: " << nSteps_ << " steps, "
        << (nSteps_ ? scalar(nIterations_)/nSteps_ : 0)
        << " Newton iterations each, " << nFailed_ << " failed, "
        << nRepeated_ << " repeated for the tolerance " << tolerance_ << nl
        << "    alpha.clay from " << gMin(alpha_.primitiveField()) << " to "
        << gMax(alpha_.primitiveField()) << nl << endl;
}
