/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayCloud.H"
#include "asFatalError.H"
#include "clayWeights.H"
#include "costReport.H"
#include "fvMesh.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "uniformDimensionedFields.H"
#include "unreadField.H"
#include "wallResolution.H"
#include "waterLimits.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

using namespace Foam;

//- Acceleration of gravity from constant/g [m/s2], 0 where there is none and
//  it was not asked for
vector readGravity(const Time& runTime, const cloudProperties& properties)
{
    uniformDimensionedVectorField g
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
    );

    if
    (
        !g.headerOk()
     && properties.effect("gravity") == cloudProperties::choice::on
    )
    {
        FatalIOErrorInFunction(properties.dict().subDict("effects"))
            << "gravity is on, but there is no " << g.objectPath() << nl
            << "    It holds, after its header,   dimensions [0 1 -2 0 0 0 0];"
            << " value (0 -9.81 0);" << exit(FatalIOError);
    }
    return g.value();
}


//- A field of the clay: read by a restart, 0 at a start
template<class GeoField>
GeoField cloudField
(
    const fvMesh& mesh,
    const word& name,
    const dimensionSet& dimensions
)
{
    const bool restart = mesh.time().timeIndex();

    const IOobject io
    (
        name,
        mesh.time().timeName(),
        mesh,
        restart ? IOobject::MUST_READ : IOobject::NO_READ,
        IOobject::AUTO_WRITE
    );

    if (restart)
    {
        return GeoField(io, mesh);
    }
    return GeoField
    (
        io,
        mesh,
        dimensioned<typename GeoField::value_type>(dimensions, Zero),
        zeroGradientFvPatchField<typename GeoField::value_type>::typeName
    );
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
    state_(mesh, matter),
    interactions_
    (
        matter,
        properties_,
        state_,
        axes_,
        readGravity(mesh.time(), properties_)
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
    findInlets();
    checkFilterLength();
    wallResolution::check(mesh, properties_, state_.spacing);
    clayPlatelet::readFields(*this);
    checkCount(labelList());
    state_.identify(*this, matter.clay());
    checkPlaces();
    const reducedUnits& units = interactions_.units();

    plateletDynamics::periodicBox space;
    for (direction axis = 0; axis < 3; ++axis)
    {
        space.periodic[axis] = axes_.periodic(axis);
        space.lower[axis] = axes_.lower(axis)/units.length();
        space.upper[axis] = axes_.upper(axis)/units.length();
    }

    asFatalError
    (
        units,
        properties_,
        [&]
        {
            engine_ = std::make_unique<plateletDynamics::engine>
            (
                space,
                limits(),
                interactions_.force(mesh.time().value()),
                interactions_.settings(),
                Pstream::parRun() ? MPI_COMM_WORLD : MPI_COMM_SELF
            );
        }
    );
    engine_->setSkinUse(state_.skinUse);
    remember();
    // Of another integrator histories mean something else
    if (state_.integrator != engine_->integratorName())
    {
        for (clayPlatelet& platelet : *this)
        {
            platelet.state().previousStep = 0;
        }
    }
    load();

    if (state_.entered == 0 && inlets_.empty())
    {
        WarningInFunction
            << "There is no clay: setClay placed no platelet. Spacing, cut-off"
            << " and effects below mean nothing" << nl << endl;
    }
    interactions_.print(Info, engine_->kernelName());
    waterLimits::print(Info, mesh, properties_);
    printInlets(Info);

    // A restart goes on with the fields of its time (the filter in time has a
    // memory); a start makes them
    if (mesh.time().timeIndex() == 0)
    {
        for (const char* field : {"alpha.clay", "U.clay"})
        {
            colloid::sayUnread
            (
                mesh.time(), field, "it follows from the platelets"
            );
        }
        colloid::sayUnread
        (
            mesh.time(), "c", "concentration of water (clayProperties) is"
        );
        filter(0);
        state_.placedFraction = meanFraction();
    }
    else
    {
        // decomposePar and reconstructPar leave on coupled patches something
        // else than the neighbour's values
        alpha_.correctBoundaryConditions();
        Uclay_.correctBoundaryConditions();
    }
}


void Foam::clayCloud::remember()
{
    const scalar unit = interactions_.units().time();
    const scalar before = state_.timeUnit;

    if (before > 0 && mag(unit - before) > 1e-9*before)
    {
        Info<< "Matter or water are not those of before, and so is the scale of"
            << " time: steps are found anew" << nl << endl;
        return;
    }
    engine_->setIntegratorMemory
    (
        std::vector<double>
        (
            state_.integratorMemory.begin(), state_.integratorMemory.end()
        )
    );
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

    asFatalError
    (
        units, properties_, [&]{ engine_->load(std::move(loaded)); }
    );
}


void Foam::clayCloud::filter(const scalar deltaT)
{
    DynamicList<point> positions(size());
    DynamicList<label> cells(size());
    DynamicList<vector> velocities(size());

    for (const clayPlatelet& platelet : *this)
    {
        if (platelet.inWater())
        {
            positions.append(platelet.state().x);
            cells.append(platelet.cell());
            velocities.append(platelet.state().U);
        }
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
    checkFraction();
}


Foam::scalar Foam::clayCloud::maxDeltaT(const scalar filterLengths) const
{
    const scalar way = filterLengths*interactions_.filterLength();

    if (interactions_.Brownian())
    {
        // The velocity of one platelet changes within the flow step: that of
        // many counts, and the random way
        return min
        (
            way/max(gMax(mag(Uclay_.primitiveField())()), VSMALL),
            sqr(way)/(6*interactions_.diffusivity())
        );
    }

    scalar fastest = 0;
    for (const clayPlatelet& platelet : *this)
    {
        if (platelet.inWater())
        {
            fastest = max(fastest, mag(platelet.state().U));
        }
    }
    reduce(fastest, maxOp<scalar>());

    return way/max(fastest, VSMALL);
}


Foam::label Foam::clayCloud::number() const
{
    return returnReduce(size(), sumOp<label>());
}


Foam::label Foam::clayCloud::inWater() const
{
    return number() - inLayers();
}


Foam::word Foam::clayCloud::counted() const
{
    return state_.coarseGraining == 1 ? "platelets" : "parcels";
}


void Foam::clayCloud::report(Ostream& os, costReport& cost) const
{
    const plateletDynamics::engineCounters& counters = engine_->counters();

    // Effects by name: what each costs. Gravity's is in the forces, which begin
    // with it instead of 0
    cost.add("lists", counters.listSeconds, "platelets");
    cost.add
    (
        interactions_.forcesAre(), counters.forceSeconds, "platelets"
    );
    cost.add("choosing steps", counters.stiffnessSeconds, "platelets");
    cost.add("other ranks", counters.haloSeconds, "platelets");
    // Those that were on at some time, on any rank
    const auto addEffect = [&](const char* name, const double seconds)
    {
        if (returnReduce(scalar(seconds), maxOp<scalar>()) > 0)
        {
            cost.add(name, seconds, "platelets");
        }
    };
    addEffect("Brownian", counters.randomSeconds);
    addEffect("drag", dragSeconds_);
    addEffect("localFraction", frictionSeconds_);

    const scalar contacts =
        returnReduce(scalar(counters.contacts), sumOp<scalar>());

    os  << nl;
    if (state_.coarseGraining == 1)
    {
        os  << "Platelets: ";
    }
    else
    {
        os  << "Parcels of " << parcelNumber() << " platelets: ";
    }
    // What layers hold, or what was taken out of them, has not been in the water
    const label inLayersNow = inLayers();
    label leftLayers = 0;
    for (const clayInlet& inlet : inlets_)
    {
        leftLayers +=
            state_.left.lookup(clayState::layerOf(inlet.name()), 0);
    }

    os  << state_.entered - inLayersNow - leftLayers << " entered, "
        << inWater() << " inside";
    if (inlets_.size())
    {
        os  << ", " << inLayersNow << " in layers of inlets";
    }
    os  << ", " << state_.allLeft() - leftLayers << " left";
    for (const word& patch : state_.left.sortedToc())
    {
        os  << ", " << state_.left[patch] << " through " << patch;
    }
    reportInlets(os);
    os  << nl << "Engine: " << counters.steps << " steps, "
        << counters.evaluations << " evaluations of the forces, "
        << counters.rebuilds << " lists built, "
        << contacts << " times a pair in contact" << nl << endl;

    cost.report(os, counters.particleSteps, mesh_.time().value() - startTime_);
}


void Foam::clayCloud::writeFields() const
{
    // A rank without platelets writes no files: those of an earlier run, whose time
    // is written anew, would stay
    const fileName folder
    (
        mesh_.time().timePath()/cloud::prefix/cloud::name()
    );
    if (isDir(folder))
    {
        rmDir(folder);
    }
    clayPlatelet::writeFields(*this);
    writeClayWeights(mesh_, *this);
}
