/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayCloud.H"
#include "errorAt.H"
#include "asFatalError.H"
#include "countOf.H"
#include "stopwatch.H"

#include "fvcGrad.H"
#include "fvMesh.H"

#include <algorithm>

namespace
{

//- Engine steps in a flow step beyond which a user is warned
constexpr Foam::scalar manySteps = 1e6;

//- Cut-offs, none of which a step can pass, over which water carries platelets in
//  one flow step: beyond which a user is warned, and beyond which it would never end
constexpr Foam::scalar longWay = 10;
constexpr Foam::scalar endlessWay = 1e6;

} // End anonymous namespace


Foam::scalar Foam::clayCloud::meanFraction() const
{
    scalar sum = 0;
    label n = 0;
    for (const clayPlatelet& platelet : *this)
    {
        if (platelet.inWater())
        {
            sum += alpha_[platelet.cell()];
            ++n;
        }
    }
    reduce(sum, sumOp<scalar>());
    reduce(n, sumOp<label>());

    return sum/max(n, label(1));
}


void Foam::clayCloud::updateEngine(const volVectorField& Uwater)
{
    const reducedUnits& units = interactions_.units();
    const scalar now = mesh_.time().value();
    const scalar fraction = meanFraction();

    // Placed on no cell of clay: nothing to compare with
    scalar spacing =
        fraction > 0 && state_.placedFraction > 0
      ? state_.spacing*Foam::cbrt(state_.placedFraction/fraction)
      : state_.decidedSpacing;

    // What enters goes on to be there
    for (const clayInlet& inlet : inlets_)
    {
        spacing = min(spacing, inlet.spacing());
    }

    const bool changed = interactions_.reconsider
    (
        now,
        spacing,
        [&]{ return Foam::sqrt(gMax(magSqr(Uwater.primitiveField())())); }
    );

    if (!changed && !matter_.concentrationVaries())
    {
        return;
    }

    const std::string kernelBefore(engine_->kernelName());
    asFatalError
    (
        units,
        properties_,
        [&]
        {
            engine_->change(interactions_.force(now), interactions_.settings());
        }
    );
    if (engine_->kernelName() != kernelBefore)
    {
        Info<< "Pair kernel: " << engine_->kernelName().c_str() << endl;
    }
}


void Foam::clayCloud::sampleDrag(const volVectorField& Uwater)
{
    plateletDynamics::platelets& local = engine_->local();

    if (!interactions_.drag())
    {
        local.waterVelocity.assign(local.size(), {0, 0, 0});
        return;
    }

    const plateletDynamics::stopwatch timing(dragSeconds_);
    const scalar unit = interactions_.units().velocity();

    // Linear in each cell: other than the interpolation through the points of
    // the mesh, this is the same on any number of ranks
    const tmp<volTensorField> gradU(fvc::grad(Uwater));

    // Not mesh_.C(): from v2306 on it is made by all ranks together, and a rank
    // without platelets would not ask for it
    const vectorField& centres = mesh_.cellCentres();

    for (std::size_t i = 0; i < local.size(); ++i)
    {
        const clayPlatelet& platelet = *platelets_[local.tag[i]];
        const label celli = platelet.cell();
        const vector fromCentre(platelet.position() - centres[celli]);

        local.waterVelocity[i] =
            reduced(Uwater[celli] + (fromCentre & gradU()[celli]), unit);
    }
}


void Foam::clayCloud::sampleFriction()
{
    const reducedUnits& units = interactions_.units();
    plateletDynamics::platelets& local = engine_->local();

    local.mobilitySlope.clear();
    if (!interactions_.frictionIsLocal())
    {
        local.friction.assign
        (
            local.size(), interactions_.friction(0)/units.friction()
        );
        return;
    }

    const plateletDynamics::stopwatch timing(frictionSeconds_);
    const tmp<volVectorField> gradAlpha(fvc::grad(alpha_));
    const vectorField& centres = mesh_.cellCentres();

    for (std::size_t i = 0; i < local.size(); ++i)
    {
        const clayPlatelet& platelet = *platelets_[local.tag[i]];
        const label celli = platelet.cell();
        const vector fromCentre(platelet.position() - centres[celli]);
        const scalar linear =
            alpha_[celli] + (fromCentre & gradAlpha()[celli]);
        const scalar alpha = min(max(linear, scalar(0)), scalar(0.99));

        local.friction[i] = interactions_.friction(alpha)/units.friction();

        if (interactions_.Brownian())
        {
            // None where the friction no longer follows
            local.mobilitySlope.push_back
            (
                alpha == linear
              ? reduced
                (
                    interactions_.mobilitySlope(alpha)*gradAlpha()[celli],
                    1/units.length()
                )
              : plateletDynamics::vector(0, 0, 0)
            );
        }
    }
}


Foam::scalar Foam::clayCloud::checkWay(const scalar deltaT) const
{
    const reducedUnits& units = interactions_.units();

    scalar fastest = 0;
    for (const plateletDynamics::vector& v : engine_->local().waterVelocity)
    {
        fastest = max(fastest, scalar(v.norm()));
    }
    fastest = returnReduce(fastest, maxOp<scalar>())*units.velocity();

    const scalar way = fastest*deltaT;
    const scalar cutOff = interactions_.settings().cutOff*units.length();

    if (way > endlessWay*cutOff)
    {
        FatalErrorInFunction
            << "Water of " << fastest << " m/s carries platelets over " << way
            << " m in " << deltaT << " s:" << nl
            << "    at least " << way/cutOff << " engine steps, of at most the"
            << " cut-off of " << cutOff << " m." << nl
            << "    Is the velocity in m/s? Else a smaller deltaT, or"
            << " adjustTimeStep yes (controlDict)" << exit(FatalError);
    }
    return way;
}


void Foam::clayCloud::checkEngineStep(const scalar deltaT, const label parts)
{
    const scalar way = checkWay(deltaT);

    if (stepChecked_)
    {
        return;
    }
    stepChecked_ = true;

    const reducedUnits& units = interactions_.units();
    const scalar cutOff = interactions_.settings().cutOff*units.length();
    const bool fixedSteps = !engine_->choosesSteps();
    scalar limit = 0;
    scalar chosen = 0;
    asFatalError
    (
        units,
        properties_,
        [&]
        {
            limit = engine_->stabilityLimit()*units.time();
            chosen = engine_->stableDeltaT()*units.time();
        }
    );

    const scalar asked = properties_.engineDeltaT();
    const scalar step =
        min(asked > 0 ? asked : fixedSteps ? chosen : limit, deltaT);
    const scalar byWay = way/cutOff;
    const scalar steps = max(deltaT/step*(1 - 1e-10), byWay);

    Info<< "Flow step of " << parts*deltaT << " s: ";
    if (inlets_.size())
    {
        Info<< parts << (parts > 1 ? " parts" : " part") << " for inlets, ";
    }
    Info<< (fixedSteps || asked > 0 ? "about " : "at least ")
        << colloid::inDigits(std::ceil(steps)).c_str() << " engine step"
        << (steps > 1 ? "s" : "") << (parts > 1 ? " each" : "");
    if (steps > 1)
    {
        Info<< nl << "    limited by ";
        if (byWay >= steps)
        {
            Info<< "the way of the water, " << way << " m, over the cut-off";
        }
        else if (asked > 0)
        {
            Info<< "engineDeltaT, " << asked << " s";
        }
        else
        {
            Info<< (step < 0.2*limit ? "speed or random motion" : "stiff forces")
                << ", to " << step << " s";
        }
    }
    Info<< nl << endl;

    if (way > longWay*cutOff)
    {
        WarningInFunction
            << "Water carries platelets over " << way << " m in " << deltaT
            << " s, " << byWay << " times the cut-off:" << nl
            << "    is the velocity in m/s? A smaller deltaT, or adjustTimeStep"
            << " yes (controlDict)" << nl << endl;
    }
    if (!fixedSteps)
    {
        return;
    }

    if (step > limit)
    {
        WarningInFunction
            << "Engine steps of " << step << " s are longer than "
            << engine_->integratorName().c_str() << " is sure to bear here, "
            << limit << " s:" << nl
            << "    platelets may jump to and fro, ever farther. A smaller"
            << " engineDeltaT, or integrator auto (clayCloudProperties)" << nl
            << endl;
    }
    if (deltaT > manySteps*step)
    {
        WarningInFunction
            << "A flow step of " << deltaT << " s takes about " << deltaT/step
            << " engine steps of " << step << " s." << nl
            << "    Where platelets overlap or stick together: place them apart,"
            << " or enlarge contactGap (clayProperties)." << nl
            << "    Where they move at random in salty water: steps are short"
            << " against the Debye length;" << nl
            << "    doubleLayer auto (clayCloudProperties) leaves that out where"
            << " it does not count" << nl << endl;
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
        const point before(tracked(state));
        const vector lag(axes_.nearestImage(before - platelet.position()));
        vector way(x - state.x);

        for (direction axis = 0; axis < 3; ++axis)
        {
            if (axes_.periodic(axis))
            {
                way[axis] += axes_.period(axis)*local.crossings[i][axis];
            }
        }

        // The way in the water; of one in a layer, that of its place at the patch
        state.x += way;
        noteLayer(state, x);
        state.displacement = tracked(state) - before + lag;
        state.x = x;
        state.U = inSI(local.velocity[i], units.velocity());
        state.F = inSI(local.force[i], units.force());
        state.previousVelocity =
            inSI(local.previousVelocity[i], units.velocity());
        state.previousStep = local.previousStep[i]*units.time();
    }
    engine_->clearCrossings();

    // Processor patches, of which ranks have different numbers, come last; after
    // all patches those that leave from the layers of inlets
    const label nPatches = mesh_.boundaryMesh().nNonProcessor();
    labelList left(nPatches + inlets_.size(), Zero);
    for (const plateletDynamics::departure& gone : engine_->departures())
    {
        clayPlatelet& platelet = *platelets_[gone.tag];
        clayPlatelet::properties& state = platelet.state();
        state.x = inSI(gone.position, units.length());
        noteLayer(state, state.x);
        ++left[platelet.inWater() ? gone.patch : nPatches + state.inlet];

        deleteParticle(platelet);
        platelets_[gone.tag] = nullptr;
    }
    Pstream::listCombineGather(left, plusEqOp<label>());
    Pstream::listCombineScatter(left);

    forAll(left, i)
    {
        if (left[i])
        {
            const word from
            (
                i < nPatches
              ? mesh_.boundaryMesh()[i].name()
              : clayState::layerOf(inlets_[i - nPatches].name())
            );
            countLeft(from, left[i]);
        }
    }
    sumThrough();
    addPassages();
}


void Foam::clayCloud::follow()
{
    transferred_ = 0;
    clayPlatelet::trackingData tracking(*this);
    Cloud<clayPlatelet>::move(*this, tracking, 1);

    // Where the mesh ends but the engine's walls did not hold
    const scalar tolerance = lagAtWalls*state_.spacing;

    for (clayPlatelet& platelet : *this)
    {
        const point x(tracked(platelet.state()));

        if
        (
            !platelet.onBoundaryFace()
         || mag(axes_.nearestImage(x - platelet.position())) < tolerance
        )
        {
            continue;
        }

        // The straight way may lead through rock that the platelet went round
        const label celli = mesh_.findCell(x);

        if (celli < 0)
        {
            colloid::errorAt(mesh_.time().controlDict(), "deltaT")
                << "Platelet " << platelet.state().id << " went from "
                << x - platelet.state().displacement << " m to " << x
                << " m, which is outside the mesh beyond patch "
                << mesh_.boundaryMesh()[platelet.patch()].name()
                << (Pstream::parRun() ? " (or round it to another rank)" : "")
                << "." << nl
                << "    Reduce deltaT (in controlDict); if it went through a"
                << " wall, engineDeltaT in clayCloudProperties"
                << exit(FatalIOError);
        }
        platelet.relocate(x, celli);
    }

    const label changes = transferred_ + label(engine_->departures().size());

    if (returnReduce(changes, sumOp<label>()))
    {
        load();
    }
}


void Foam::clayCloud::movePart
(
    const volVectorField& Uwater,
    const scalar deltaT,
    const label parts
)
{
    const reducedUnits& units = interactions_.units();

    labelList idsBefore(size());
    std::copy
    (
        engine_->local().id.begin(), engine_->local().id.end(),
        idsBefore.begin()
    );

    sampleDrag(Uwater);
    sampleFriction();
    driveLayers();
    checkEngineStep(deltaT, parts);
    asFatalError
    (
        units, properties_, [&]{ engine_->advance(deltaT/units.time()); }
    );
    takeBack();
    follow();
    checkCount(idsBefore);
}


void Foam::clayCloud::move(const volVectorField& Uwater, const scalar deltaT)
{
    updateEngine(Uwater);

    const label n = parts(deltaT);
    for (label part = 0; part < n; ++part)
    {
        supply(deltaT/n);
        movePart(Uwater, deltaT/n, n);
    }

    // A restart sorts and lists anew: so does the run that goes on
    if (mesh_.time().writeTime())
    {
        engine_->listsExpire();
        state_.skinUse = engine_->skinUse();
        state_.integrator = engine_->integratorName();
        state_.timeUnit = interactions_.units().time();

        // Of surfaces that are no longer counted the sum would be of a part only
        state_.passages.retain(wordHashSet(countedNames_));
        state_.surfaces.retain(wordHashSet(countedNames_));

        const std::vector<double> memory(engine_->integratorMemory());
        state_.integratorMemory.setSize(label(memory.size()));
        std::copy
        (
            memory.begin(), memory.end(), state_.integratorMemory.begin()
        );
        for (const clayInlet& inlet : inlets_)
        {
            state_.inlets.set(inlet.stateName(), inlet.state());
        }
    }
}
