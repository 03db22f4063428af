/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayCloud.H"

#include "costReport.H"
#include "fvcGrad.H"
#include "fvMesh.H"
#include "Pstream.H"
#include "uniformDimensionedFields.H"
#include "waterLimits.H"
#include "zeroGradientFvPatchFields.H"

#include <algorithm>

namespace
{

using namespace Foam;

//- Acceleration of gravity from constant/g [m/s2], 0 where there is none
vector readGravity(const Time& runTime)
{
    return uniformDimensionedVectorField
    (
        IOobject
        (
            "g",
            runTime.constant(),
            runTime,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        ),
        dimensionedVector("g", dimAcceleration, Zero)
    ).value();
}


template<class GeoField>
GeoField cloudField
(
    const fvMesh& mesh,
    const word& name,
    const dimensionSet& dimensions
)
{
    return GeoField
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensioned<typename GeoField::value_type>(dimensions, Zero),
        zeroGradientFvPatchField<typename GeoField::value_type>::typeName
    );
}


//- What the engine tells the user ends the run as OpenFOAM's errors do
template<class Action>
auto asFatalError(Action action) -> decltype(action())
{
    try
    {
        return action();
    }
    catch (const plateletDynamics::userError& error)
    {
        FatalErrorInFunction << error.what() << exit(FatalError);
        throw;
    }
}

} // End anonymous namespace


Foam::clayCloud::clayCloud
(
    fvMesh& mesh,
    const colloid::clayProperties& matter
)
:
    Cloud<clayPlatelet>(waterLimits::withCells(mesh), "clay", false),
    mesh_(mesh),
    matter_(matter),
    properties_(mesh.time()),
    axes_(mesh),
    state_(mesh),
    interactions_
    (
        matter,
        properties_,
        state_,
        axes_,
        number(),
        mesh.time().value(),
        readGravity(mesh.time())
    ),
    filter_
    (
        mesh,
        interactions_.filterLength(),
        properties_.filterTimeScale()
    ),
    startTime_(mesh.time().value()),
    alpha_(cloudField<volScalarField>(mesh, "alpha.clay", dimless)),
    Uclay_(cloudField<volVectorField>(mesh, "U.clay", dimVelocity))
{
    checkState();
    clayPlatelet::readFields(*this);
    checkCount(labelList());
    const reducedUnits& units = interactions_.units();

    plateletDynamics::box space;
    for (direction axis = 0; axis < 3; ++axis)
    {
        space.periodic[axis] = axes_.periodic(axis);
        space.lower[axis] = axes_.lower(axis)/units.length();
        space.upper[axis] = axes_.upper(axis)/units.length();
    }

    asFatalError
    (
        [&]
        {
            engine_ = std::make_unique<plateletDynamics::engine>
            (
                space,
                waterLimits::triangles(mesh, properties_, units.length()),
                interactions_.force(mesh.time().value()),
                interactions_.settings(),
                Pstream::parRun() ? MPI_COMM_WORLD : MPI_COMM_SELF
            );
        }
    );
    load();

    interactions_.print(Info);

    // A restart goes on with the fields of its time (the filter in time has a
    // memory); a start makes them
    if (mesh.time().timeIndex() == 0)
    {
        filter(0);
    }
}


void Foam::clayCloud::checkState() const
{
    const scalar asked = properties_.coarseGraining();

    if (asked > 0 && mag(asked - state_.coarseGraining) > SMALL*asked)
    {
        FatalIOErrorInFunction(properties_.dict())
            << "coarseGraining is " << asked << " here, but setClay placed"
            << " the clay with " << state_.coarseGraining << " ("
            << state_.objectPath() << ")." << nl
            << "    Run setClay again or put " << state_.coarseGraining
            << " here" << exit(FatalIOError);
    }
}


void Foam::clayCloud::load()
{
    const reducedUnits& units = interactions_.units();

    plateletDynamics::platelets loaded;
    platelets_.setSize(size());

    label tag = 0;
    for (clayPlatelet& platelet : *this)
    {
        const clayPlatelet::properties& state = platelet.state();

        loaded.append(state.id, reduced(state.x, units.length()));
        loaded.tag.back() = tag;
        loaded.fixed.back() = state.fixed;
        loaded.previousVelocity.back() =
            reduced(state.previousVelocity, units.velocity());
        loaded.previousStep.back() = state.previousStep/units.time();

        platelets_[tag++] = &platelet;
    }

    asFatalError([&]{ engine_->load(std::move(loaded)); });
}


void Foam::clayCloud::sampleWater(const volVectorField& Uwater)
{
    const reducedUnits& units = interactions_.units();
    plateletDynamics::platelets& local = engine_->local();

    // Linear in each cell: other than the interpolation through the points of
    // the mesh, this is the same on any number of ranks
    const tmp<volTensorField> gradU(fvc::grad(Uwater));
    const tmp<volVectorField> gradAlpha(fvc::grad(alpha_));
    const volVectorField& centres = mesh_.C();

    for (std::size_t i = 0; i < local.size(); ++i)
    {
        const clayPlatelet& platelet = *platelets_[local.tag[i]];
        const label celli = platelet.cell();
        const vector fromCentre(platelet.position() - centres[celli]);

        if (interactions_.drag())
        {
            local.waterVelocity[i] = reduced
            (
                Uwater[celli] + (fromCentre & gradU()[celli]),
                units.velocity()
            );
        }

        scalar alpha = 0;
        if (interactions_.frictionIsLocal())
        {
            alpha = alpha_[celli] + (fromCentre & gradAlpha()[celli]);
            alpha = min(max(alpha, scalar(0)), scalar(0.99));
        }
        local.friction[i] = interactions_.friction(alpha)/units.friction();
    }
}


void Foam::clayCloud::takeBack()
{
    const reducedUnits& units = interactions_.units();
    const plateletDynamics::platelets& local = engine_->local();

    for (std::size_t i = 0; i < local.size(); ++i)
    {
        clayPlatelet& platelet = *platelets_[local.tag[i]];
        clayPlatelet::properties& state = platelet.state();

        const point x(inSI(local.position[i], units.length()));
        const vector lag(axes_.nearestImage(state.x - platelet.position()));
        vector way(x - state.x);

        for (direction axis = 0; axis < 3; ++axis)
        {
            if (axes_.periodic(axis))
            {
                way[axis] += axes_.period(axis)*local.crossings[i][axis];
            }
        }

        state.displacement = way + lag;
        state.x = x;
        state.U = inSI(local.velocity[i], units.velocity());
        state.F = inSI(local.force[i], units.force());
        state.previousVelocity =
            inSI(local.previousVelocity[i], units.velocity());
        state.previousStep = local.previousStep[i]*units.time();
    }
    engine_->clearCrossings();

    HashTable<label> left;
    for (const plateletDynamics::departure& gone : engine_->departures())
    {
        ++left(mesh_.boundaryMesh()[gone.patch].name(), 0);
        deleteParticle(*platelets_[gone.tag]);
        platelets_[gone.tag] = nullptr;
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const label number =
            returnReduce(left.lookup(patch.name(), 0), sumOp<label>());

        if (number && !patch.coupled())
        {
            state_.left(patch.name(), 0) += number;
        }
    }
}


void Foam::clayCloud::follow()
{
    transferred_ = 0;
    clayPlatelet::trackingData tracking(*this);
    Cloud<clayPlatelet>::move(*this, tracking, 1);

    // Where the mesh ends but the engine's walls did not hold
    const scalar tolerance = 0.01*state_.spacing;

    for (const clayPlatelet& platelet : *this)
    {
        if (platelet.onBoundaryFace())
        {
            const scalar beyond =
                mag(platelet.state().x - platelet.position());

            if (beyond > tolerance && !mesh_.boundaryMesh()[platelet.patch()].coupled())
            {
                FatalErrorInFunction
                    << "Platelet " << platelet.state().id << " at "
                    << platelet.state().x << " m is " << beyond
                    << " m outside the mesh, beyond patch "
                    << mesh_.boundaryMesh()[platelet.patch()].name() << "." << nl
                    << "    Reduce engineDeltaT in clayCloudProperties"
                    << exit(FatalError);
            }
        }
    }

    const label changes = transferred_ + label(engine_->departures().size());

    if (returnReduce(changes, sumOp<label>()))
    {
        load();
    }
}


void Foam::clayCloud::move(const volVectorField& Uwater, const scalar deltaT)
{
    const reducedUnits& units = interactions_.units();
    const scalar now = mesh_.time().value();

    if (matter_.concentrationVaries())
    {
        asFatalError
        (
            [&]
            {
                engine_->changeForce
                (
                    interactions_.force(now),
                    interactions_.settings().cutOff
                );
            }
        );
    }

    labelList idsBefore(size());
    std::copy
    (
        engine_->local().id.begin(), engine_->local().id.end(),
        idsBefore.begin()
    );

    sampleWater(Uwater);
    asFatalError([&]{ engine_->advance(deltaT/units.time()); });
    takeBack();
    follow();
    checkCount(idsBefore);

    // A restart sorts and lists anew: so does the run that goes on
    if (mesh_.time().writeTime())
    {
        engine_->listsExpire();
    }
}


void Foam::clayCloud::filter(const scalar deltaT)
{
    const label n = size();
    pointField positions(n);
    labelList cells(n);
    vectorField velocities(n);

    label i = 0;
    for (const clayPlatelet& platelet : *this)
    {
        positions[i] = platelet.state().x;
        cells[i] = platelet.cell();
        velocities[i] = platelet.state().U;
        ++i;
    }

    filter_.update
    (
        positions,
        cells,
        velocities,
        interactions_.parcelVolume(),
        deltaT,
        alpha_,
        Uclay_
    );
}


Foam::scalar Foam::clayCloud::maxDeltaT(const scalar filterLengths) const
{
    scalar fastest = 0;
    for (const clayPlatelet& platelet : *this)
    {
        fastest = max(fastest, mag(platelet.state().U));
    }
    reduce(fastest, maxOp<scalar>());

    return filterLengths*interactions_.filterLength()/max(fastest, VSMALL);
}


Foam::label Foam::clayCloud::number() const
{
    return returnReduce(size(), sumOp<label>());
}


void Foam::clayCloud::checkCount(const labelUList& idsBefore) const
{
    const label inside = number();

    if (inside + state_.allLeft() == state_.entered)
    {
        return;
    }

    // All ids before the step, less those that left and those that are inside
    List<labelList> before(Pstream::nProcs());
    List<labelList> after(Pstream::nProcs());
    before[Pstream::myProcNo()] = idsBefore;

    DynamicList<label> accounted(size());
    for (const clayPlatelet& platelet : *this)
    {
        accounted.append(platelet.state().id);
    }
    for (const plateletDynamics::departure& gone : engine_->departures())
    {
        accounted.append(gone.id);
    }
    after[Pstream::myProcNo()] = accounted;
    Pstream::gatherList(before);
    Pstream::gatherList(after);

    labelHashSet missing;
    for (const labelList& ids : before)
    {
        missing.insert(ids);
    }
    for (const labelList& ids : after)
    {
        missing.unset(ids);
    }

    FatalErrorInFunction
        << "Platelets do not add up: " << state_.entered << " entered, "
        << inside << " are inside and " << state_.allLeft() << " left." << nl
        << "    Missing ids: " << missing.sortedToc() << exit(FatalError);
}


void Foam::clayCloud::report(Ostream& os, costReport& cost) const
{
    const plateletDynamics::engineCounters& counters = engine_->counters();

    cost.add("platelets: lists", counters.listSeconds, true);
    cost.add("platelets: forces", counters.forceSeconds, true);
    cost.add("platelets: other ranks", counters.haloSeconds, true);

    const label contacts = returnReduce(label(counters.contacts), sumOp<label>());

    os  << nl << "Platelets: " << state_.entered << " entered, "
        << number() << " inside";
    forAllConstIters(state_.left, iter)
    {
        os  << ", " << iter.val() << " left through " << iter.key();
    }
    os  << nl << "Engine: " << label(counters.steps) << " steps, "
        << label(counters.evaluations) << " evaluations of the forces, "
        << label(counters.rebuilds) << " lists built, "
        << contacts << " pairs in contact" << nl << endl;

    cost.report(os, counters.particleSteps, mesh_.time().value() - startTime_);
}


void Foam::clayCloud::writeFields() const
{
    clayPlatelet::writeFields(*this);
}
