/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayTransport.H"
#include "checkWords.H"
#include "readInRange.H"
#include "steadyStateDdtScheme.H"
#include "wallFvPatch.H"

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


void Foam::clayTransport::makeDiffusing(const dictionary& dict)
{
    if (dict.found("withoutDiffusionAlong", keyType::LITERAL))
    {
        const vector direction(dict.get<vector>("withoutDiffusionAlong"));

        if (mag(direction) < VSMALL)
        {
            FatalIOErrorInFunction(dict)
                << "withoutDiffusionAlong " << direction
                << " is no direction" << exit(FatalIOError);
        }
        diffusing_ = 1 - sqr
        (
            (mesh_.Sf()/mesh_.magSf())
          & dimensionedVector("along", dimless, direction/mag(direction))
        );
        Info<< "No diffusion along " << direction << endl;
    }
}


void Foam::clayTransport::updatePotential()
{
    if (salt_)
    {
        potential_.setVarying();
        return;
    }

    concentration_ = matter_.waterAt(mesh_.time().value()).concentration;
    potential_.setUniform(concentration_);
}


bool Foam::clayTransport::settlesThrough(const label patchi) const
{
    const fvPatch& patch = mesh_.boundary()[patchi];

    return
        patch.coupled()
     || (patch.type() == "patch" && !isA<wallFvPatch>(patch));
}


void Foam::clayTransport::decideGravity()
{
    if (gravity_ == "off")
    {
        return;
    }

    IOobject io
    (
        "g",
        mesh_.time().constant(),
        mesh_,
        IOobject::MUST_READ,
        IOobject::NO_WRITE
    );

    if (!io.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        if (gravity_ == "on")
        {
            FatalErrorInFunction
                << "gravity on in erosionProperties needs the file "
                << io.objectPath() << exit(FatalError);
        }
        Info<< "Gravity off: no file constant/g" << endl;
        gravity_ = "off";
        return;
    }

    const vector g(uniformDimensionedVectorField(io).value());
    const colloid::water solution(matter_.waterAt(mesh_.time().value()));
    const colloid::platelet& clay = matter_.clay();

    friction_ = matter_.newFriction("KozenyCarman", solution);
    weight_ = clay.volume()*(clay.density - solution.density)*g;

    const scalar settling = mag(weight_)/friction_->value(0);
    const scalar flow =
        gMax((mag(phi_)/mesh_.magSf())().primitiveField());
    const scalar measure = settling/max(flow, VSMALL);
    const bool on = gravity_ == "on" || measure > tolerance_;

    Info<< "Gravity " << (on ? "on" : "off") << ": a platelet sinks by "
        << settling << " m/s, the water flows by up to " << flow << nl
        << "    m/s: ";
    if (gravity_ == "on")
    {
        Info<< "as erosionProperties says" << endl;
    }
    else
    {
        Info<< measure << " against the tolerance " << tolerance_ << endl;
    }

    if (!on)
    {
        weight_ = Zero;
    }
    gravity_ = on ? "on" : "off";
}


void Foam::clayTransport::checkBounds() const
{
    const scalar least = gMin(alpha_.primitiveField());
    const scalar most = gMax(alpha_.primitiveField());

    if (least < 0 || most > packing_)
    {
        FatalErrorInFunction
            << alpha_.name() << " is from " << least << " to " << most
            << " at the start" << nl
            << "Valid: solid fractions from 0 to packing in"
            << " erosionProperties, " << packing_
            << exit(FatalError);
    }
    forAll(alpha_.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = alpha_.boundaryField()[patchi];

        if (patch.size() && (min(patch) < 0 || max(patch) > packing_))
        {
            FatalErrorInFunction
                << alpha_.name() << " on the patch "
                << patch.patch().name() << " is from " << min(patch)
                << " to " << max(patch) << nl
                << "Valid: solid fractions from 0 to packing in"
                << " erosionProperties, " << packing_
                << exit(FatalError);
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
    matter_(matter),
    alpha_(alpha),
    phi_(phi),
    aperture_(apertureRatio),
    salt_(salt),
    packing_(colloid::readInRange(properties, "packing", 0.65, 1e-3, 0.999, "(-)")),
    potential_(properties.subDict("diffusivity"), matter, packing_),
    concentration_(0),
    diffusing_
    (
        IOobject("diffusing", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("1", dimless, 1)
    ),
    skewed_
    (
        gMax(mag(mesh_.nonOrthCorrectionVectors())().primitiveField()) > 1e-8
    ),
    gravity_
    (
        properties.getOrDefault<word>("gravity", "auto", keyType::LITERAL)
    ),
    weight_(Zero),
    alphaPhi_
    (
        IOobject("alphaPhi", mesh_.time().timeName(), mesh_),
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
    ),
    clayAtStart_(clay())
{
    colloid::checkChoice
    (
        properties, "gravity", gravity_, wordList({"on", "off", "auto"})
    );
    readControls();
    checkBounds();
    makeDiffusing(properties);
    updatePotential();

    if (!salt_)
    {
        const coexistence& phases = potential_.uniform().phases();

        if (phases.kind() == coexistence::state::twoPhases)
        {
            Info<< "Attraction wins between the solid fractions "
                << phases.lower() << " and " << phases.upper()
                << ": clay there is a gel of " << phases.gel() << nl
                << "    beside a sol of " << phases.sol()
                << ", and does not spread between the two" << endl;
        }
    }
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
