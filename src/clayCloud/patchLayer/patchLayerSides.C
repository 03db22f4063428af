/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchLayer.H"
#include "philox.H"
#include "reducedUnits.H"
#include "waterLimits.H"

#include "polyMesh.H"
#include "processorCyclicPolyPatch.H"
#include "SubField.H"

#include <map>

namespace
{

using namespace Foam;

//- Cosine of the angle between normals from which two faces are in one plane
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
    const scalar lengthUnit
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
        int(patch)
    });
}


//- An edge by the coordinates of its ends, whichever comes first
using edgeKey = std::array<scalar, 6>;

edgeKey key(const point& a, const point& b)
{
    const edgeKey forward{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
    const edgeKey backward{b.x(), b.y(), b.z(), a.x(), a.y(), a.z()};
    return std::min(forward, backward);
}


//- Ends of the edges of a rank's faces of the patch, and the centres of the faces
struct ranksEdges
{
    DynamicList<point> ends;
    DynamicList<point> centres;

    explicit ranksEdges(const polyPatch& patch)
    {
        forAll(patch, i)
        {
            const face& f = patch[i];
            forAll(f, j)
            {
                ends.append(patch.points()[f[j]]);
                ends.append(patch.points()[f.nextLabel(j)]);
                centres.append(patch.faceCentres()[i]);
            }
        }
    }
};

} // End anonymous namespace


void Foam::patchLayer::findSides
(
    const cloudProperties& properties,
    const dictionary& dict
)
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const ranksEdges own(patches[patch_]);

    List<pointField> ends(Pstream::nProcs());
    List<pointField> centres(Pstream::nProcs());
    ends[Pstream::myProcNo()] = pointField(own.ends);
    centres[Pstream::myProcNo()] = pointField(own.centres);
    Pstream::gatherList(ends);
    Pstream::scatterList(ends);
    Pstream::gatherList(centres);
    Pstream::scatterList(centres);

    // Edges of one face alone are the patch's rim
    std::map<edgeKey, side> rim;
    std::map<edgeKey, label> faces;
    forAll(ends, rank)
    {
        forAll(centres[rank], i)
        {
            const point& a = ends[rank][2*i];
            const point& b = ends[rank][2*i + 1];
            const edgeKey k(key(a, b));

            ++faces[k];
            vector into(centres[rank][i] - a);
            const vector along((b - a)/mag(b - a));
            into -= (into & along)*along;
            rim[k] = {a, b, into/mag(into), -1, action::reflect};
        }
    }
    for (const auto& edge : faces)
    {
        if (edge.second > 1)
        {
            rim.erase(edge.first);
        }
    }

    // What is beyond the rim: on some rank there is a face that has the edge.
    // 0: none; else a number above that of the patch, negative in this plane
    labelList beyond(label(rim.size()), Zero);
    forAll(patches, patchi)
    {
        const polyPatch& patch = patches[patchi];

        // A periodic side between ranks is a periodic side
        label number = patchi;
        if (isA<processorCyclicPolyPatch>(patch))
        {
            number = refCast<const processorCyclicPolyPatch>(patch)
               .referPatchID();
        }
        else if (patchi == patch_ || isA<processorPolyPatch>(patch))
        {
            continue;
        }

        forAll(patch, i)
        {
            const face& f = patch[i];
            forAll(f, j)
            {
                const auto found = rim.find
                (
                    key
                    (
                        patch.points()[f[j]],
                        patch.points()[f.nextLabel(j)]
                    )
                );
                if (found != rim.end())
                {
                    const vector normal(patch.faceNormals()[i]);
                    const bool flat = mag(normal & inward_) > inOnePlane;
                    beyond[label(std::distance(rim.begin(), found))] =
                        flat ? -1 - number : number + 1;
                }
            }
        }
    }
    Pstream::listCombineGather
    (
        beyond,
        [](label& x, const label y) { x = x ? x : y; }
    );
    Pstream::listCombineScatter(beyond);

    label i = 0;
    for (auto& edge : rim)
    {
        side& s = edge.second;
        const label what = beyond[i++];

        if (what == 0)
        {
            FatalIOErrorInFunction(dict)
                << "No patch follows that of the inlet, "
                << patches[patch_].name() << ", at its edge " << s.a << ' '
                << s.b << exit(FatalIOError);
        }
        if (what < 0)
        {
            checkBeside(s, -what - 1, properties, dict);
        }
        else
        {
            s.beyond = what - 1;
            if (patches[s.beyond].coupled())
            {
                continue;
            }
            // Clay is on both sides of the edge between two inlets
            s.does =
                properties.isInlet(patches[s.beyond].name())
              ? action::reflect
              : waterLimits::asAction(mesh_, s.beyond, properties);
        }
        sides_.append(s);
    }
}


void Foam::patchLayer::checkBeside
(
    const side& edge,
    const label beside,
    const cloudProperties& properties,
    const dictionary& dict
) const
{
    const polyPatch& patch = mesh_.boundaryMesh()[beside];

    if
    (
        !properties.isInlet(patch.name())
     && waterLimits::asAction(mesh_, beside, properties) == action::platelet
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
    vector along(Zero);
    const vector size(cmptMag(inward_));
    along[size.x() <= size.y() && size.x() <= size.z() ? 0
        : size.y() <= size.z() ? 1 : 2] = 1;
    along -= (along & inward_)*inward_;
    along /= mag(along);
    const vector across(inward_ ^ along);

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
                limits, {a, b, c}, inward_, patch_, action::platelet, lengthUnit
            );
            addTriangle
            (
                limits, {a, c, d}, inward_, patch_, action::platelet, lengthUnit
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
