/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchLayer.H"
#include "patchRim.H"
#include "philox.H"
#include "reducedUnits.H"
#include "waterLimits.H"

#include "polyMesh.H"

namespace
{

using namespace Foam;

//- Cosine of the angle between the normals of two walls that are one
constexpr scalar inOnePlane = 0.99;


//- Distance of bumps over their height
constexpr scalar bumpHeights = 1.25;


//- Add a triangle whose normal points into the layer
void addTriangle
(
    plateletDynamics::boundarySurface& limits,
    const FixedList<point, 3>& c,
    const vector& into,
    const label patch,
    const patchLayer::action does,
    const scalar lengthUnit,
    const bool opaque = true
)
{
    const bool turn = (((c[1] - c[0])^(c[2] - c[0])) & into) < 0;
    limits.triangles.push_back
    ({
        {
            reduced(c[0], lengthUnit),
            reduced(c[turn ? 2 : 1], lengthUnit),
            reduced(c[turn ? 1 : 2], lengthUnit)
        },
        does,
        int(patch),
        opaque
    });
}

} // End anonymous namespace


void Foam::patchLayer::findSides
(
    const periodicAxes& axes,
    const cloudProperties& properties,
    const dictionary& dict
)
{
    const patchRim rim(mesh_, patch_, inward_, axes, dict);

    for (const patchRim::edge& e : rim.edges())
    {
        side s{e.a, e.b, e.inwards, -1, action::reflect};
        if (e.inPlane)
        {
            checkBeside(e, properties, dict);
        }
        else
        {
            s.beyond = e.beyond;
            // Clay is on both sides of the edge between two inlets
            s.does =
                properties.isInlet(mesh_.boundaryMesh()[e.beyond].name())
              ? action::reflect
              : waterLimits::asAction(mesh_, e.beyond, properties);
        }
        sides_.append(s);
    }
}


void Foam::patchLayer::checkBeside
(
    const patchRim::edge& edge,
    const cloudProperties& properties,
    const dictionary& dict
) const
{
    const polyPatch& patch = mesh_.boundaryMesh()[edge.beyond];

    if
    (
        !properties.isInlet(patch.name())
     && waterLimits::asAction(mesh_, edge.beyond, properties) == action::platelet
    )
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << patch.name() << ", which acts as a platelet, goes on"
            << " in the plane of the inlet's, " << mesh_.boundaryMesh()[patch_].name()
            << ", at its edge " << edge.a << ' ' << edge.b << nl
            << "    It would push at the layer behind: say reflect for it"
            << " ('patches'), or give the inlet the whole side"
            << exit(FatalIOError);
    }
}


void Foam::patchLayer::findWalls()
{
    const auto add = [this](const point& on, const vector& normal)
    {
        for (const wall& w : walls_)
        {
            if
            (
                (w.normal & normal) > inOnePlane
             && mag((on - w.on) & normal) < 0.01*thickness_
            )
            {
                return;
            }
        }
        walls_.append(wall{on, normal});
    };

    for (const side& s : sides_)
    {
        if (s.does == action::platelet)
        {
            add(s.a, s.intoLayer);
        }
    }
}


void Foam::patchLayer::addRoughBack
(
    plateletDynamics::boundarySurface& limits,
    const scalar lengthUnit
) const
{
    // A rectangle around the patch, along the axes where the patch is
    const vector& along = cover_->along();
    const vector& across = cover_->across();

    scalar low[2] = {GREAT, GREAT};
    scalar high[2] = {-GREAT, -GREAT};
    for (const triangle& t : triangles_)
    {
        for (const point& p : t.corners)
        {
            const scalar at[2] = {p & along, p & across};
            for (label i = 0; i < 2; ++i)
            {
                low[i] = min(low[i], at[i]);
                high[i] = max(high[i], at[i]);
            }
        }
    }
    label n[2];
    for (label i = 0; i < 2; ++i)
    {
        n[i] = max
        (
            label(2),
            label(std::round((high[i] - low[i])/(2*bumpHeights*roughness_)))
        );
    }

    // The same bumps in every run; across periodic sides they go on
    const plateletDynamics::philox random(0);
    const auto corner = [&](const label i, const label j) -> point
    {
        const label number = (i % n[0]) + n[0]*(j % n[1]);
        const scalar height = 2*random.uniform(number, 0)[0] - 1;
        return
            (low[0] + i*(high[0] - low[0])/n[0])*along
          + (low[1] + j*(high[1] - low[1])/n[1])*across
          + ((centre_ & inward_) - thickness_ + roughness_*height)*inward_;
    };

    for (label i = 0; i < n[0]; ++i)
    {
        for (label j = 0; j < n[1]; ++j)
        {
            const point a(corner(i, j));
            const point b(corner(i + 1, j));
            const point c(corner(i + 1, j + 1));
            const point d(corner(i, j + 1));
            addTriangle
            (
                limits,
                {a, b, c}, inward_, patch_, action::platelet, lengthUnit, false
            );
            addTriangle
            (
                limits,
                {a, c, d}, inward_, patch_, action::platelet, lengthUnit, false
            );
        }
    }
}


void Foam::patchLayer::addLimits
(
    plateletDynamics::boundarySurface& limits,
    const scalar lengthUnit
) const
{
    const vector way(-(thickness_ + roughness_)*inward_);

    for (const side& s : sides_)
    {
        const label patch = s.beyond < 0 ? patch_ : s.beyond;
        addTriangle
        (
            limits, {s.a, s.b, s.b + way}, s.intoLayer, patch, s.does, lengthUnit
        );
        addTriangle
        (
            limits,
            {s.a, s.b + way, s.a + way}, s.intoLayer, patch, s.does, lengthUnit
        );
    }

    if (roughness_ > 0)
    {
        addRoughBack(limits, lengthUnit);
        return;
    }
    for (const triangle& t : triangles_)
    {
        const auto& c = t.corners;
        addTriangle
        (
            limits,
            {c[0] + way, c[1] + way, c[2] + way},
            inward_, patch_, action::absorb, lengthUnit
        );
    }
}
