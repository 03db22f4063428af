/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayFlux.H"
#include "caseFile.H"
#include "checkWords.H"
#include "errorAt.H"
#include "fvcSurfaceIntegrate.H"
#include "linear.H"
#include "syncTools.H"
#include "uniformDimensionedFields.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::clayFlux::makeDiffusing(const dictionary& dict)
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


bool Foam::clayFlux::settlesThrough(const label patchi) const
{
    const fvPatch& patch = mesh_.boundary()[patchi];

    return
        patch.coupled()
     || (patch.type() == "patch" && !isA<wallFvPatch>(patch));
}


void Foam::clayFlux::decideGravity(const scalar tolerance)
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
            colloid::errorAt
            (
                colloid::caseFile(fileName("constant/erosionProperties")),
                wordList({"gravity"})
            )
                << "gravity on in erosionProperties needs the file "
                << io.objectPath() << exit(FatalIOError);
        }
        Info<< "Gravity off: no file constant/g" << endl;
        gravity_ = "off";
        return;
    }

    const vector g(uniformDimensionedVectorField(io).value());
    const colloid::water solution(matter_.waterAt(mesh_.time().value()));
    const colloid::platelet& clay = matter_.clay();

    friction_ = matter_.newFriction(solution);
    weight_ = clay.volume()*(clay.density - solution.density)*g;

    scalar fastest = 0;
    constexpr label parts = 1000;

    for (label i = 1; i <= parts; ++i)
    {
        const scalar a = i*packing_/parts;
        const scalar sinking = a/friction_->value(a);

        if (sinking > fastest)
        {
            fastest = sinking;
            fastestSinking_ = a;
        }
    }

    const scalar settling = mag(weight_)/friction_->value(0);
    // Of all faces, also those between ranks and of the boundary
    const scalar flow = max(mag(phi_)/mesh_.magSf()).value();
    const scalar measure = settling/max(flow, VSMALL);
    const bool on = gravity_ == "on" || measure > tolerance;

    Info<< "Gravity " << (on ? "on" : "off") << ": a platelet sinks by "
        << settling << " m/s, the water flows by up to " << flow << nl
        << "    m/s: ";
    if (gravity_ == "on")
    {
        Info<< "as erosionProperties says" << endl;
    }
    else
    {
        Info<< measure << " against the tolerance " << tolerance << endl;
    }

    if (!on)
    {
        weight_ = Zero;
    }
    gravity_ = on ? "on" : "off";
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::clayFlux::clayFlux
(
    const volScalarField& alpha,
    const surfaceScalarField& phi,
    const volScalarField& apertureRatio,
    const volScalarField* salt,
    const colloid::clayProperties& matter,
    const dictionary& properties,
    const scalar packing
)
:
    mesh_(alpha.mesh()),
    matter_(matter),
    alpha_(alpha),
    phi_(phi),
    aperture_(apertureRatio),
    salt_(salt),
    potential_(properties.subDict("diffusivity"), matter, packing),
    concentration_(0),
    diffusing_
    (
        IOobject("diffusing", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("1", dimless, 1)
    ),
    conductance_(diffusing_*mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()),
    skewed_
    (
        max(mag(mesh_.nonOrthCorrectionVectors())).value() > 1e-8
    ),
    gravity_
    (
        properties.getOrDefault<word>("gravity", "auto", keyType::LITERAL)
    ),
    packing_(packing),
    weight_(Zero),
    fastestSinking_(packing)
{
    colloid::checkChoice
    (
        properties, "gravity", gravity_, wordList({"on", "off", "auto"})
    );
    makeDiffusing(properties);

    if (!salt_)
    {
        concentration_ = matter_.waterAt(mesh_.time().value()).concentration;
        potential_.setUniform(concentration_);

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

void Foam::clayFlux::update(const scalar tolerance)
{
    conductance_ =
        linearInterpolate(aperture_)*diffusing_*mesh_.magSf()
       *mesh_.nonOrthDeltaCoeffs();

    if (salt_)
    {
        potential_.setVarying();
    }
    else
    {
        concentration_ = matter_.waterAt(mesh_.time().value()).concentration;
        potential_.setUniform(concentration_);
    }

    if (gravity_ == "auto" || (gravity_ == "on" && !friction_.valid()))
    {
        decideGravity(tolerance);
    }
}


void Foam::clayFlux::evaluate
(
    surfaceScalarField& F,
    fvScalarMatrix* derivatives
) const
{
    F == dimensionedScalar(F.dimensions(), Zero);

    if (derivatives)
    {
        derivatives->lower() = 0;
        derivatives->upper() = 0;
        derivatives->diag() = 0;
        forAll(derivatives->internalCoeffs(), patchi)
        {
            derivatives->internalCoeffs()[patchi] = 0;
            derivatives->boundaryCoeffs()[patchi] = 0;
        }
    }
    addAdvection(F, derivatives);
    addDiffusion(F, derivatives);
    addSettling(F, derivatives);
    F += held_.valid() ? held_ : correction();

    if (derivatives)
    {
        derivatives->negSumDiag();
    }
}


void Foam::clayFlux::change
(
    scalarField& alpha,
    const scalarField& from,
    const scalarField& linearChange,
    const scalarField& stiffness
) const
{
    // Of all faces through which the potential drives
    scalarField conductance(fvc::surfaceSum(conductance_)().primitiveField());

    forAll(mesh_.boundary(), patchi)
    {
        const fvPatchScalarField& patch = alpha_.boundaryField()[patchi];
        const scalarField& ofPatch = conductance_.boundaryField()[patchi];

        if (!patch.coupled() && !patch.fixesValue())
        {
            forAll(ofPatch, i)
            {
                conductance[patch.patch().faceCells()[i]] -= ofPatch[i];
            }
        }
    }

    forAll(alpha, celli)
    {
        const auto law = lawOf(celli);
        const scalar start = from[celli];
        const potentialInWater::point before(law.at(start));
        const scalar G = conductance[celli];

        // By what does not diffuse; round-off may leave nothing
        const scalar holding = max
        (
            stiffness[celli] - G*before.diffusivity,
            1e-6*stiffness[celli]
        );
        const scalar wanted =
            (holding + G*before.diffusivity)*linearChange[celli];
        const auto excess = [&](const scalar a, const scalar potential)
        {
            return holding*(a - start) + G*(potential - before.potential) - wanted;
        };

        // Newton's method within a bracket, as D >= 0
        scalar low = start + min(wanted/holding, scalar(0));
        scalar high = start + max(wanted/holding, scalar(0));
        scalar a = min(max(start + linearChange[celli], low), high);

        for (label i = 0; i < 50; ++i)
        {
            const potentialInWater::point here(law.at(a));
            const scalar over = excess(a, here.potential);

            // As the change itself is one of many
            if (mag(over) <= 1e-6*mag(wanted))
            {
                break;
            }
            (over > 0 ? high : low) = a;
            const scalar next = a - over/(holding + G*here.diffusivity);
            const scalar last = a;

            a = next > low && next < high ? next : 0.5*(low + high);

            if (a == last || high - low <= 1e-15)
            {
                break;
            }
        }
        alpha[celli] = a;
    }
}


void Foam::clayFlux::holdCorrection(const scalar presentShare)
{
    held_ = correction();

    if (presentShare < 1 && lastHeld_.valid())
    {
        held_.ref() = presentShare*held_() + (1 - presentShare)*lastHeld_();
    }
}


void Foam::clayFlux::withoutCorrection(const boolList& cells)
{
    surfaceScalarField& held = held_.ref();

    forAll(mesh_.owner(), facei)
    {
        if (cells[mesh_.owner()[facei]] || cells[mesh_.neighbour()[facei]])
        {
            held[facei] = 0;
        }
    }

    boolList ofNeighbours;
    syncTools::swapBoundaryCellList(mesh_, cells, ofNeighbours);

    forAll(held.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        scalarField& patchHeld = held.boundaryFieldRef()[patchi];

        forAll(patchHeld, i)
        {
            const label there = patch.start() + i - mesh_.nInternalFaces();

            if
            (
                cells[patch.faceCells()[i]]
             || (patch.coupled() && ofNeighbours[there])
            )
            {
                patchHeld[i] = 0;
            }
        }
    }
}


void Foam::clayFlux::releaseCorrection()
{
    lastHeld_ = held_;
    held_.clear();
}


Foam::scalarField Foam::clayFlux::outflow(const surfaceScalarField& F)
{
    const fvMesh& mesh = F.mesh();
    scalarField sum(mesh.nCells(), Zero);

    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();
    const scalarField& internal = F.primitiveField();

    forAll(internal, facei)
    {
        sum[owner[facei]] += internal[facei];
        sum[neighbour[facei]] -= internal[facei];
    }
    forAll(F.boundaryField(), patchi)
    {
        const scalarField& patch = F.boundaryField()[patchi];
        const labelUList& cells = mesh.boundary()[patchi].faceCells();

        forAll(patch, i)
        {
            sum[cells[i]] += patch[i];
        }
    }
    return sum;
}
