/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocityInlet.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "ofAllRanks.H"
#include "readInRange.H"

namespace Foam
{
    defineTypeNameAndDebug(velocityInlet, 0);
    addToRunTimeSelectionTable(clayInlet, velocityInlet, dictionary);
}

namespace
{

//- Part of a spacing that the layer moves between two calls of supply
constexpr Foam::scalar wayPerCall = 0.25;

//- Beyond what water does in a fracture [m/s]
constexpr Foam::scalar fastest = 0.1;

//- Friction of a platelet that moves whatever pushes it, over its own
constexpr Foam::scalar unmoved = 1e9;

} // End anonymous namespace


Foam::vector Foam::velocityInlet::readU() const
{
    if (dict_.found("flux") == dict_.found("U"))
    {
        FatalIOErrorInFunction(dict_)
            << "Give U, or flux, which is the fraction times U: one of them"
            << exit(FatalIOError);
    }
    if (dict_.found("flux"))
    {
        return
            colloid::readInRange(dict_, "flux", VSMALL, 1, "m/s")/fraction_
           *layer_.inward();
    }

    ITstream& is = dict_.lookup("U");
    const token first(is[0]);
    if (first.isWord())
    {
        colloid::checkChoice
        (
            dict_, "U", first.wordToken(), wordList({"water"})
        );
        return Zero;
    }
    return colloid::readWithUnit<vector>(dict_, "U", is, "m/s");
}


Foam::velocityInlet::velocityInlet
(
    const word& name,
    const dictionary& dict,
    const scene& where
)
:
    clayInlet
    (
        name, dict, where, {2, 0, 2, GREAT}
    ),
    withWater_(dict.found("U") && dict.lookup("U")[0].isWord()),
    U_(readU())
{
    wordList words(commonWords);
    words.append(wordList({"U", "flux"}));
    colloid::checkWords(dict, words);

    if (!withWater_ && (U_ & layer_.inward()) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "U is " << U_ << ", but " << layer_.inward()
            << " is the way into the mesh" << exit(FatalIOError);
    }
    if (mag(U_) > fastest)
    {
        FatalIOErrorInFunction(dict)
            << "Inlet " << name << " moves with " << mag(U_) << " m/s"
            << (dict.found("flux") ? " (flux/fraction)" : "")
            << ", faster than the " << fastest << " m/s that are possible." << nl
            << "    Is it in m/s? A unit may follow it, such as mm/s"
            << exit(FatalIOError);
    }
}


void Foam::velocityInlet::update()
{
    List<vectorField> U;
    if (withWater_)
    {
        U = ofAllRanks(waterAtPatch());
    }

    const List<patchLayer::triangle>& triangles = layer_.triangles();
    speed_.setSize(triangles.size());
    fluxUpTo_.setSize(triangles.size());
    scalar flux = 0;

    forAll(triangles, i)
    {
        const patchLayer::triangle& t = triangles[i];
        const vector& velocity = withWater_ ? U[t.rank][t.face] : U_;

        speed_[i] = max(velocity & layer_.inward(), scalar(0));
        flux += speed_[i]*t.area;
        fluxUpTo_[i] = flux;
    }
}


Foam::scalar Foam::velocityInlet::interval(const scalar) const
{
    scalar fastest = U_ & layer_.inward();
    if (withWater_)
    {
        for (const vector& velocity : waterAtPatch())
        {
            fastest = max(fastest, velocity & layer_.inward());
        }
        reduce(fastest, maxOp<scalar>());
    }
    return wayPerCall*spacing_/max(fastest, VSMALL);
}


Foam::scalar Foam::velocityInlet::wanted
(
    const label,
    const counts&,
    const scalar deltaT
)
{
    update();
    owed_ += density()*fluxUpTo_.last()*deltaT;

    const scalar whole = std::floor(owed_);
    owed_ -= whole;
    return whole;
}


Foam::scalar Foam::velocityInlet::due
(
    const scalar,
    const scalar duration
) const
{
    const scalar flow =
        withWater_
      ? waterThroughPatch() : (U_ & layer_.inward())*layer_.area();
    return density()*flow*duration;
}


std::string Foam::velocityInlet::whyFew() const
{
    return
        withWater_ && waterThroughPatch() <= 0
      ? ":\n    no water enters there (fractureFlowProperties)"
      : ". A longer run, another fraction, or faster?";
}


void Foam::velocityInlet::noRoom(const label number)
{
    owed_ += number;
}


Foam::patchLayer::place Foam::velocityInlet::tryPlace
(
    const label piece,
    const FixedList<scalar, 4>& random,
    const scalar deltaT
) const
{
    // At a start anywhere; then in the part that the layer has left free
    if (speed_.empty())
    {
        return clayInlet::tryPlace(piece, random, deltaT);
    }

    patchLayer::place tried
    (
        layer_.at({random[0], random[1], random[2]}, 0, fluxUpTo_)
    );
    const scalar way =
        min(speed_[tried.triangle]*deltaT, layer_.thickness());
    tried.x -= (layer_.thickness() - random[3]*way)*layer_.inward();
    return tried;
}


void Foam::velocityInlet::drive(vector& velocity, scalar& friction) const
{
    // Straight on: along the patch it would leave one end of the layer empty
    const vector& n = layer_.inward();
    velocity = ((withWater_ ? velocity : U_) & n)*n;
    friction *= unmoved;
}


void Foam::velocityInlet::printKind(Ostream& os) const
{
    os  << ", entering with ";
    if (withWater_)
    {
        os  << "the water";
    }
    else
    {
        os  << U_ << " m/s";
    }
}
