/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayCloud.H"
#include "countOf.H"
#include "ofAllRanks.H"
#include "waterLimits.H"

#include "fvMesh.H"

namespace
{

//- Parts of a flow step beyond which it would never end: each asks all ranks for
//  the platelets near the inlets
constexpr Foam::scalar mostParts = 1e7;

} // End anonymous namespace


void Foam::clayCloud::findInlets()
{
    const dictionary all(properties_.inlets());
    inlets_.setSize(all.size());
    through_.setSize(all.size(), Zero);

    label i = 0;
    for (const entry& inlet : all)
    {
        inlets_.set
        (
            i,
            clayInlet::New
            (
                inlet.keyword(),
                inlet.dict(),
                {mesh_, properties_, interactions_, axes_, i}
            ).ptr()
        );
        ++i;
    }

    // Those of a restart, under their names and types
    wordHashSet names;
    for (const clayInlet& inlet : inlets_)
    {
        names.insert(inlet.stateName());
    }
    for (const word& name : state_.inlets.sortedToc())
    {
        if (!names.found(name))
        {
            FatalIOErrorInFunction(properties_.dict())
                << "There is no inlet " << name << " (its name and type) here,"
                << " but time " << mesh_.time().timeName()
                << " has platelets behind it." << nl
                << "    Inlets stay as long as a run goes on; here are "
                << flatOutput(names.sortedToc()) << exit(FatalIOError);
        }
    }
    for (clayInlet& inlet : inlets_)
    {
        filter_.mirrorAt(inlet.layer().patchPlane());

        if (state_.inlets.found(inlet.stateName()))
        {
            inlet.setState(state_.inlets[inlet.stateName()]);
        }
    }
}


plateletDynamics::boundarySurface Foam::clayCloud::limits() const
{
    const scalar unit = interactions_.units().length();
    plateletDynamics::boundarySurface all
    (
        waterLimits::triangles(mesh_, properties_, unit)
    );
    for (const clayInlet& inlet : inlets_)
    {
        inlet.layer().addLimits(all, unit);
    }
    return all;
}


Foam::label Foam::clayCloud::parts(const scalar deltaT) const
{
    scalar longest = deltaT;
    word whose;
    for (const clayInlet& inlet : inlets_)
    {
        const scalar interval = inlet.interval(mesh_.time().value());
        if (interval < longest)
        {
            longest = interval;
            whose = inlet.name();
        }
    }
    if (whose.empty())
    {
        return 1;
    }
    return max
    (
        label(1),
        colloid::countOf
        (
            std::ceil(deltaT/longest*(1 - 1e-10)),
            "parts that inlet " + whose + " divides a flow step into",
            properties_.inlets(),
            mostParts
        )
    );
}


Foam::clayInlet::neighbours Foam::clayCloud::nearLayer
(
    const clayInlet& inlet
) const
{
    DynamicList<point> x;
    DynamicList<label> id;

    for (const clayPlatelet& platelet : *this)
    {
        if (inlet.layer().depth(platelet.state().x) > -inlet.reach())
        {
            x.append(platelet.state().x);
            id.append(platelet.state().id);
        }
    }

    const List<List<point>> allX(ofAllRanks<List<point>>(x));
    const List<labelList> allId(ofAllRanks<labelList>(id));

    clayInlet::neighbours all;
    forAll(allX, rank)
    {
        all.x.append(allX[rank]);
        all.id.append(allId[rank]);
    }
    return all;
}


void Foam::clayCloud::enter
(
    const label inleti,
    const patchLayer::place& where
)
{
    const patchLayer& layer = inlets_[inleti].layer();

    if (layer.triangles()[where.triangle].rank == Pstream::myProcNo())
    {
        clayPlatelet::properties what;
        what.x = where.x;
        what.id = state_.entered;
        what.inlet = inleti;
        addParticle
        (
            new clayPlatelet
            (
                mesh_,
                layer.tracked(where.x),
                layer.cell(where.triangle),
                what
            )
        );
    }
    ++state_.entered;
}


void Foam::clayCloud::takeOut(const label inleti, const labelUList& ids)
{
    const labelHashSet out(ids);

    forAllIters(*this, iter)
    {
        clayPlatelet& platelet = iter();
        if (out.found(platelet.state().id))
        {
            deleteParticle(platelet);
        }
    }
    countLeft(clayState::layerOf(inlets_[inleti].name()), ids.size());
}


void Foam::clayCloud::supply(const scalar deltaT)
{
    bool changed = false;
    forAll(inlets_, i)
    {
        const clayInlet::change next
        (
            inlets_[i].supply
            (
                nearLayer(inlets_[i]), mesh_.time().value(), deltaT
            )
        );
        for (const patchLayer::place& where : next.enter)
        {
            enter(i, where);
        }
        if (next.leave.size())
        {
            takeOut(i, next.leave);
        }
        changed = changed || next.enter.size() || next.leave.size();
    }

    if (changed)
    {
        load();
    }
}


void Foam::clayCloud::driveLayers()
{
    const reducedUnits& units = interactions_.units();
    plateletDynamics::platelets& local = engine_->local();

    if (inlets_.empty())
    {
        return;
    }
    for (std::size_t k = 0; k < local.size(); ++k)
    {
        const label inleti = platelets_[local.tag[k]]->state().inlet;
        if (inleti < 0)
        {
            continue;
        }

        vector velocity(inSI(local.waterVelocity[k], units.velocity()));
        scalar friction = local.friction[k]*units.friction();
        inlets_[inleti].drive(velocity, friction);
        local.waterVelocity[k] = reduced(velocity, units.velocity());
        local.friction[k] = friction/units.friction();
    }
}


Foam::point Foam::clayCloud::tracked
(
    const clayPlatelet::properties& state
) const
{
    return
        state.inlet < 0
      ? state.x : inlets_[state.inlet].layer().tracked(state.x);
}


Foam::label Foam::clayCloud::layerAt(const point& x, const label before) const
{
    // Out of a layer only through its patch
    label found =
        before >= 0 && inlets_[before].layer().depth(x) > 0 ? before : -1;

    forAll(inlets_, i)
    {
        // Into one only behind the patch itself, since walls beside it in its plane
        // give way a little; where another ends close by, into the one that it is in
        const patchLayer& layer = inlets_[i].layer();
        if (layer.holds(x))
        {
            if (layer.covers(x))
            {
                return i;
            }
            found = found < 0 ? i : found;
        }
    }
    return found;
}


void Foam::clayCloud::noteLayer
(
    clayPlatelet::properties& state,
    const point& x
)
{
    const label now = layerAt(x, state.inlet);
    if (now != state.inlet)
    {
        if (state.inlet >= 0)
        {
            ++through_[state.inlet];
        }
        if (now >= 0)
        {
            --through_[now];
        }
        state.inlet = now;
    }
}


void Foam::clayCloud::sumThrough()
{
    Pstream::listCombineGather(through_, plusEqOp<label>());
    Pstream::listCombineScatter(through_);

    forAll(inlets_, i)
    {
        state_.through(inlets_[i].name(), 0) += through_[i];
    }
    through_ = Zero;
}


Foam::label Foam::clayCloud::inLayers() const
{
    label n = 0;
    for (const clayPlatelet& platelet : *this)
    {
        n += !platelet.inWater();
    }
    return returnReduce(n, sumOp<label>());
}


Foam::labelHashSet Foam::clayCloud::inletPatches() const
{
    labelHashSet patches;
    for (const clayInlet& inlet : inlets_)
    {
        patches.insert(inlet.layer().patch());
    }
    return patches;
}


void Foam::clayCloud::printInlets(Ostream& os) const
{
    if (inlets_.empty())
    {
        return;
    }
    os  << "Inlets" << nl;
    for (const clayInlet& inlet : inlets_)
    {
        inlet.print(os);
    }
    os  << endl;
}


void Foam::clayCloud::reportInlets(Ostream& os) const
{
    for (const clayInlet& inlet : inlets_)
    {
        os  << nl << "    inlet " << inlet.name() << ": "
            << state_.through.lookup(inlet.name(), 0)
            << " went through the patch into the water";
        if (inlet.waited())
        {
            os  << "; " << inlet.waited() << " times there was no room";
        }
        inlet.printKind(os);
    }
}
