/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayInlet.H"
#include "checkWords.H"
#include "countOf.H"
#include "volFields.H"

namespace Foam
{
    defineTypeNameAndDebug(clayInlet, 0);
    defineRunTimeSelectionTable(clayInlet, dictionary);
}

const Foam::wordList Foam::clayInlet::commonWords({"type", "patch", "fraction"});

namespace
{

using namespace Foam;

//- Tries for a hole
constexpr label tries = 40;

//- Time between two calls of supply, in relaxation times
constexpr scalar intervalInRelaxations = 0.5;

//- Share of its fraction that an inlet should hold, and relaxation times without
//  room for more after which that is said
constexpr scalar enough = 0.9;
constexpr scalar longWait = 20;

//- Platelets in a layer, of which every rank knows all
constexpr scalar mostInLayer = 1e7;


label patchNumber(const polyMesh& mesh, const dictionary& dict)
{
    const word patch(dict.get<word>("patch"));
    wordList names;
    for (label i = 0; i < mesh.boundaryMesh().nNonProcessor(); ++i)
    {
        names.append(mesh.boundaryMesh()[i].name());
    }
    colloid::checkChoice(dict, "patch", patch, names);

    const label i = mesh.boundaryMesh().findPatchID(patch);
    if (mesh.boundaryMesh()[i].coupled())
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << patch << " is periodic: no platelet can enter there"
            << exit(FatalIOError);
    }
    return i;
}

} // End anonymous namespace


Foam::autoPtr<Foam::clayInlet> Foam::clayInlet::New
(
    const word& name,
    const dictionary& dict,
    const scene& where
)
{
    const word kind(dict.get<word>("type"));
    colloid::checkChoice
    (
        dict, "type", kind, dictionaryConstructorTablePtr_->sortedToc()
    );
    return dictionaryConstructorTablePtr_->cfind(kind)()(name, dict, where);
}


Foam::clayInlet::clayInlet
(
    const word& name,
    const dictionary& dict,
    const scene& where,
    const layerShape& shape
)
:
    scene_(where),
    name_(name),
    dict_(dict),
    fraction_(dict.get<scalar>("fraction")),
    spacing_(where.interactions.spacingAt(fraction_)),
    shape_(shape),
    layer_
    (
        where.mesh,
        patchNumber(where.mesh, dict),
        shape.thickness*spacing_,
        shape.roughness*spacing_,
        where.axes,
        where.properties,
        dict
    ),
    pieces_(layer_, shape.piece*spacing_),
    random_(where.properties.seed())
{
    checkFraction();
    colloid::countOf
    (
        numberIn(shape_.thickness),
        "platelets or parcels in the layer of inlet " + name,
        dict,
        mostInLayer
    );

    if (numberIn(1) < 4)
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << dict.get<word>("patch") << ", of " << layer_.area()
            << " m2, is too small for a mean spacing of " << spacing_
            << " m: a row behind it has only " << numberIn(1)
            << " platelets or parcels." << nl
            << "    A larger patch, or (with coarseGraining) smaller parcels"
            << exit(FatalIOError);
    }
    for (direction axis = 0; axis < 3; ++axis)
    {
        if
        (
            where.axes.periodic(axis)
         && where.axes.period(axis) < reach()
        )
        {
            FatalIOErrorInFunction(dict)
                << "The mesh is periodic over " << where.axes.period(axis)
                << " m, less than three mean spacings of " << spacing_ << " m"
                << exit(FatalIOError);
        }
    }
}


void Foam::clayInlet::checkFraction() const
{
    const clayInteractions& interactions = scene_.interactions;
    const scalar thickness = interactions.thickness();
    const scalar contactGap =
        interactions.force(scene_.mesh.time().value())->contactGap()
       *interactions.units().length();

    // Faces of stacked platelets touch (phi = thickness/spacing, TR-17-13 eq.
    // 3-17), or, of thick ones, those that are put in at half the spacing
    const scalar most = min
    (
        thickness/(thickness + contactGap),
        interactions.parcelVolume()/pow3(2*(thickness + contactGap))
    );

    if (fraction_ >= most)
    {
        FatalIOErrorInFunction(dict_)
            << "fraction is " << fraction_ << ", which leaves no gap between"
            << " platelets of " << thickness << " m that touch at " << contactGap
            << " m." << nl << "    Take less than " << most
            << exit(FatalIOError);
    }
}


void Foam::clayInlet::noteWaiting
(
    const counts& now,
    const bool full,
    const scalar time,
    const scalar deltaT
)
{
    if (held(now) >= enough)
    {
        waitedFor_ = 0;
    }
    else if (full)
    {
        waitedFor_ += deltaT;
    }

    if (waitedFor_ > longWait*relaxationTime(time) && !warned_)
    {
        warned_ = true;
        WarningInFunction
            << "Inlet " << name_ << " holds " << held(now) << " of its fraction of "
            << fraction_ << ", and there has been no room for more for "
            << waitedFor_ << " s:" << nl
            << "    what is put in must feel no more than the force of a pair at"
            << " half the mean spacing." << nl
            << "    A smaller fraction, a larger patch, or no walls close by"
            << nl << endl;
    }
}


void Foam::clayInlet::checkDue(const scalar time) const
{
    const scalar end = scene_.mesh.time().endTime().value();
    const scalar duration = end - time;
    // stopAt other than endTime sets the end to GREAT
    if (duration <= 0 || end > 0.1*GREAT)
    {
        return;
    }

    const scalar number = due(time, duration);
    if (number < 1)
    {
        WarningInFunction
            << "Inlet " << name_ << " can bring nothing: until the end, in "
            << duration << " s, " << number << " platelets or parcels" << nl
            << "    are due at the patch "
            << scene_.mesh.boundaryMesh()[layer_.patch()].name() << " ("
            << layer_.area() << " m2, fraction " << fraction_ << ')'
            << whyFew().c_str() << nl << endl;
    }
}


Foam::scalar Foam::clayInlet::waterThroughPatch() const
{
    // None before a flow is chosen
    if (!scene_.mesh.foundObject<volVectorField>("U"))
    {
        return 0;
    }

    const vectorField& U = waterAtPatch();
    const vectorField::subField areas
    (
        scene_.mesh.boundaryMesh()[layer_.patch()].faceAreas()
    );

    // OpenFOAM's normals point out of the water
    scalar flow = 0;
    forAll(U, facei)
    {
        flow += max(-(U[facei] & areas[facei]), scalar(0));
    }
    return returnReduce(flow, sumOp<scalar>());
}


Foam::scalar Foam::clayInlet::due
(
    const scalar time,
    const scalar duration
) const
{
    return
        numberIn(1)*Foam::sqrt(duration/relaxationTime(time))
      + density()*waterThroughPatch()*duration;
}


Foam::FixedList<Foam::scalar, 4> Foam::clayInlet::draw()
{
    // Below those of platelets, whose numbers begin at 0
    const auto drawn = random_.uniform
    (
        -1 - scene_.number, std::uint64_t(draws_)
    );
    draws_ += 1;

    return FixedList<scalar, 4>{drawn[0], drawn[1], drawn[2], drawn[3]};
}


const Foam::vectorField& Foam::clayInlet::waterAtPatch() const
{
    return
        scene_.mesh.lookupObject<volVectorField>("U")
       .boundaryField()[layer_.patch()];
}


Foam::scalar Foam::clayInlet::relaxationTime(const scalar time) const
{
    // Asked for several times in a step, and a sum over thousands of neighbours
    // in dilute water
    if (time != relaxationAt_)
    {
        const clayInteractions& interactions = scene_.interactions;
        const scalar nearer = 0.99*spacing_;
        const scalar farther = 1.01*spacing_;
        const scalar stiffness =
            (
                interactions.latticePressure(nearer, time)
              - interactions.latticePressure(farther, time)
            )
           /(1/pow3(nearer) - 1/pow3(farther));

        relaxationAt_ = time;
        relaxation_ =
            sqr(spacing_)*interactions.friction(fraction_)
           /(mag(stiffness) + VSMALL);
    }
    return relaxation_;
}


Foam::scalar Foam::clayInlet::interval(const scalar time) const
{
    return intervalInRelaxations*relaxationTime(time);
}


Foam::List<Foam::clayInlet::counts> Foam::clayInlet::count
(
    const neighbours& near
) const
{
    List<counts> sums(pieces_.size());
    for (const point& x : near.x)
    {
        // Not what is before other patches of the plane, or in other layers
        const label piece = pieces_.of(x);
        if (piece < 0)
        {
            continue;
        }
        counts& sum = sums[piece];
        const scalar depth = layer_.depth(x);
        sum.inLayer += depth > 0;
        sum.before += depth <= 0 && depth > -reach();
        sum.atPatch += max(scalar(0), 1 - mag(depth)/(2*spacing_));
    }
    return sums;
}


Foam::clayInlet::counts Foam::clayInlet::sum(const UList<counts>& pieces)
{
    counts all;
    for (const counts& piece : pieces)
    {
        all.inLayer += piece.inLayer;
        all.before += piece.before;
        all.atPatch += piece.atPatch;
    }
    return all;
}


Foam::patchLayer::place Foam::clayInlet::tryPlace
(
    const label piece,
    const FixedList<scalar, 4>& random,
    const scalar
) const
{
    return layer_.at
    (
        {random[0], random[1], random[2]},
        random[3]*shape_.filled*spacing_,
        pieces_.weightUpTo(piece)
    );
}


Foam::scalar Foam::clayInlet::netForce
(
    const placedPoints& placed,
    const plateletDynamics::gapForce& law,
    const point& x
) const
{
    const scalar unit = scene_.interactions.units().length();
    const scalar thickness = scene_.interactions.settings().thickness;
    vector sum(Zero);

    placed.forNear
    (
        x,
        [&](const vector& away)
        {
            const scalar distance = mag(away);
            sum +=
                away/max(distance, VSMALL)
               *law.force
                (
                    max(distance/unit - thickness, law.contactGap())
                );
        }
    );
    layer_.forWalls
    (
        x,
        [&](const scalar distance, const vector& away)
        {
            sum +=
                away
               *law.force
                (
                    max(distance/unit - 0.5*thickness, law.contactGap())
                );
        }
    );
    return mag(sum);
}


bool Foam::clayInlet::findPlace
(
    const label piece,
    const placedPoints& placed,
    const plateletDynamics::gapForce& law,
    const scalar deltaT,
    patchLayer::place& found
)
{
    scalar largest = -1;
    for (label i = 0; i < tries; ++i)
    {
        const patchLayer::place tried(tryPlace(piece, draw(), deltaT));
        scalar hole = placed.nearest(tried.x, largest);
        layer_.forWalls
        (
            tried.x,
            [&](const scalar distance, const vector&)
            {
                hole = min(hole, distance);
            }
        );
        if (hole > largest)
        {
            largest = hole;
            found = tried;
        }
    }

    const scalar halfSpacing = 0.5*spacing_/scene_.interactions.units().length();
    const scalar most =
        mag(law.force(halfSpacing - scene_.interactions.settings().thickness));

    return netForce(placed, law, found.x) <= most;
}


Foam::label Foam::clayInlet::putIn
(
    const label piece,
    const label number,
    placedPoints& placed,
    const plateletDynamics::gapForce& law,
    const scalar deltaT,
    change& next
)
{
    for (label i = 0; i < number; ++i)
    {
        patchLayer::place found;
        if (!findPlace(piece, placed, law, deltaT, found))
        {
            ++waited_;
            noRoom(number - i);
            return i;
        }
        placed.add(found.x);
        next.enter.append(found);
    }
    return number;
}


Foam::label Foam::clayInlet::takeOut
(
    const label piece,
    const label number,
    const neighbours& near,
    change& next
)
{
    DynamicList<label> inLayer;
    forAll(near.x, i)
    {
        if (layer_.depth(near.x[i]) > 0 && pieces_.of(near.x[i]) == piece)
        {
            inLayer.append(near.id[i]);
        }
    }
    // Any of them, whatever rank told of it first
    Foam::sort(inLayer);

    const label out = min(number, inLayer.size());
    for (label i = 0; i < out; ++i)
    {
        const label which =
            min(label(draw()[0]*inLayer.size()), inLayer.size() - 1);
        next.leave.append(inLayer[which]);
        inLayer.remove(which);
    }
    return out;
}


Foam::clayInlet::change Foam::clayInlet::supply
(
    const neighbours& near,
    const scalar time,
    const scalar deltaT
)
{
    if (!dueChecked_)
    {
        dueChecked_ = true;
        checkDue(time);
    }

    const List<counts> now(count(near));
    change next;
    bool full = false;
    scalar due = 0;

    placedPoints placed(scene_.axes, reach());
    for (const point& x : near.x)
    {
        placed.add(x);
    }
    const auto law = scene_.interactions.force(time);

    forAll(now, piece)
    {
        label number;
        if (started_)
        {
            // Rounded up as often as down, so that the mean is kept
            const scalar whole =
                std::floor(wanted(piece, now[piece], deltaT) + draw()[0]);
            const label size = colloid::countOf
            (
                mag(whole), "platelets or parcels due at inlet " + name_, dict_
            );
            number = whole < 0 ? -size : size;
        }
        else
        {
            // All at once; what rounding leaves over, in the next piece
            due +=
                numberIn(shape_.filled)*pieces_.share(piece)
              - now[piece].inLayer;
            number = label(std::floor(due + 1e-9));
            due -= number;
        }
        label inLayer = now[piece].inLayer;

        if (number >= 1)
        {
            const label entered =
                putIn(piece, number, placed, *law, deltaT, next);
            full = full || entered < number;
            inLayer += entered;
        }
        else if (number <= -1)
        {
            inLayer -= takeOut(piece, -number, near, next);
        }
        supplied(piece, inLayer, deltaT);
    }

    if (started_)
    {
        noteWaiting(sum(now), full, time, deltaT);
    }
    started_ = true;
    return next;
}


Foam::scalarList Foam::clayInlet::state() const
{
    scalarList all(memory());
    all.append(draws_);
    all.append(started_);
    all.append(waited_);
    all.append(waitedFor_);
    all.append(scene_.number);
    return all;
}


void Foam::clayInlet::setState(const scalarList& state)
{
    const label n = state.size() - 5;
    draws_ = state[n];
    started_ = state[n + 1] > 0;
    waited_ = label(state[n + 2]);
    waitedFor_ = state[n + 3];

    // By which platelets know it, and its random numbers
    if (label(state[n + 4]) != scene_.number)
    {
        FatalIOErrorInFunction(dict_)
            << "Inlet " << name_ << " is number " << scene_.number
            << " of the inlets here, but was number " << label(state[n + 4])
            << " when this time was written." << nl
            << "    Keep their order; new ones come last" << exit(FatalIOError);
    }
    remember(SubList<scalar>(state, n));
}


void Foam::clayInlet::print(Ostream& os) const
{
    os  << "    " << name_ << ": " << type() << " on patch "
        << scene_.mesh.boundaryMesh()[layer_.patch()].name()
        << ", solid fraction " << fraction_ << nl
        << "        spacing " << spacing_ << " m, layer of "
        << layer_.thickness() << " m behind the patch," << nl
        << "        evens out in "
        << relaxationTime(scene_.mesh.time().value()) << " s";
    printKind(os);
    os  << nl;
}
