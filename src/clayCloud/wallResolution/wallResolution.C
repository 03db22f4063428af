/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallResolution.H"
#include "errorAt.H"
#include "boundarySurface.H"
#include "ofAllRanks.H"
#include "waterLimits.H"

#include "DynamicList.H"
#include "ListOps.H"
#include "pointField.H"
#include "polyMesh.H"
#include "SubField.H"
#include "unitConversion.H"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace
{

using namespace Foam;

//- Largest deviation from the smooth surface, in mean spacings
constexpr scalar share = 0.1;


//- A face as seen from one of its edges
struct flank
{
    point centre;
    vector normal;

    //- Distance of the centre from the edge, and how far the face reaches to
    //  either side of the centre across the edge [m]
    scalar across;
    scalar reach;

    label patch;

    //- It and another face are one smooth surface
    bool continued;
};


//- An edge by the coordinates of its ends, whichever comes first
using edgeKey = std::array<scalar, 6>;

using edgeFlanks = std::map<edgeKey, std::vector<flank>>;

//- Numbers of a flank with its edge
constexpr label nNumbers = 15;


edgeKey key(const point& a, const point& b)
{
    const edgeKey forward{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
    const edgeKey backward{b.x(), b.y(), b.z(), a.x(), a.y(), a.z()};
    return std::min(forward, backward);
}


//- Where faces are farthest from the smooth surface
struct worstPlace
{
    scalar deviation = 0;

    //- Angle [rad], width of the narrower face [m], its patch and centre
    scalar bend = 0;
    scalar width = 0;
    label patch = -1;
    point centre = Zero;

    void take(const flank& a, const flank& b, const scalar cosine)
    {
        const scalar angle = Foam::acos(min(cosine, scalar(1)));
        const flank& narrow = a.reach < b.reach ? a : b;
        const scalar here =
            0.5*angle/(a.across + b.across)*sqr(narrow.reach);

        if (here > deviation)
        {
            *this = {here, angle, 2*narrow.reach, narrow.patch, narrow.centre};
        }
    }
};


//- The faces of this rank's walls by their edges
edgeFlanks ownFlanks(const polyMesh& mesh, const labelUList& walls)
{
    edgeFlanks all;
    for (const label patchi : walls)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        forAll(patch, i)
        {
            const face& f = patch[i];
            const point& centre = patch.faceCentres()[i];
            const vector& normal = patch.faceNormals()[i];
            const scalar size = Foam::sqrt(mag(patch.faceAreas()[i]));

            forAll(f, j)
            {
                const point& a = mesh.points()[f[j]];
                const point& b = mesh.points()[f.nextLabel(j)];
                const scalar length = mag(b - a);

                // An edge drawn together to a point has no direction
                if (length < 1e-6*size)
                {
                    continue;
                }
                const vector across(((b - a)/length)^normal);
                scalar reach = 0;
                for (const label pointi : f)
                {
                    const vector d(mesh.points()[pointi] - centre);
                    reach = max(reach, mag(d & across));
                }
                all[key(a, b)].push_back
                ({
                    centre, normal, mag((centre - a) & across), reach, patchi,
                    false
                });
            }
        }
    }
    return all;
}


//- Compare the faces at each edge
void compare(edgeFlanks& all, const scalar smooth, worstPlace& worst)
{
    for (auto& edge : all)
    {
        std::vector<flank>& at = edge.second;
        for (std::size_t i = 0; i < at.size(); ++i)
        {
            for (std::size_t j = i + 1; j < at.size(); ++j)
            {
                const scalar cosine = at[i].normal & at[j].normal;
                if (cosine > smooth)
                {
                    at[i].continued = at[j].continued = true;
                    worst.take(at[i], at[j], cosine);
                }
            }
        }
    }
}


//- Of all ranks those that nothing of their own rank continues
edgeFlanks rims(const edgeFlanks& own)
{
    DynamicList<scalar> numbers;
    for (const auto& edge : own)
    {
        for (const flank& f : edge.second)
        {
            if (!f.continued)
            {
                for (const scalar x : edge.first)
                {
                    numbers.append(x);
                }
                for (direction axis = 0; axis < 3; ++axis)
                {
                    numbers.append(f.centre[axis]);
                }
                for (direction axis = 0; axis < 3; ++axis)
                {
                    numbers.append(f.normal[axis]);
                }
                numbers.append(f.across);
                numbers.append(f.reach);
                numbers.append(f.patch);
            }
        }
    }

    edgeFlanks sum;
    for (const scalarList& n : ofAllRanks<scalarList>(numbers))
    {
        for (label i = 0; i < n.size(); i += nNumbers)
        {
            sum[{n[i], n[i + 1], n[i + 2], n[i + 3], n[i + 4], n[i + 5]}]
           .push_back
            ({
                point(n[i + 6], n[i + 7], n[i + 8]),
                vector(n[i + 9], n[i + 10], n[i + 11]),
                n[i + 12], n[i + 13], label(n[i + 14]), false
            });
        }
    }
    return sum;
}


//- The worst of all ranks
worstPlace worstOf(const worstPlace& own)
{
    const scalarList numbers
    ({
        own.deviation, own.bend, own.width, scalar(own.patch),
        own.centre.x(), own.centre.y(), own.centre.z()
    });

    worstPlace worst;
    for (const scalarList& n : ofAllRanks(numbers))
    {
        if (n[0] > worst.deviation)
        {
            worst = {n[0], n[1], n[2], label(n[3]), point(n[4], n[5], n[6])};
        }
    }
    return worst;
}

} // End anonymous namespace


void Foam::wallResolution::check
(
    const polyMesh& mesh,
    const cloudProperties& properties,
    const scalar spacing
)
{
    labelList walls;
    for (label i = 0; i < mesh.boundaryMesh().nNonProcessor(); ++i)
    {
        const polyPatch& patch = mesh.boundaryMesh()[i];
        if
        (
            !patch.coupled()
         && !properties.isInlet(patch.name())
         && waterLimits::actionOf(mesh, i, properties)
         == cloudProperties::patchAction::platelet
        )
        {
            walls.append(i);
        }
    }

    const scalar featureAngle =
        plateletDynamics::boundarySurface().featureAngle;
    const scalar smooth = Foam::cos(degToRad(featureAngle));

    worstPlace own;
    edgeFlanks flanks(ownFlanks(mesh, walls));
    compare(flanks, smooth, own);
    flanks = rims(flanks);
    compare(flanks, smooth, own);
    const worstPlace worst(worstOf(own));

    if (worst.deviation > share*spacing)
    {
        // The chord error falls with the square of the width
        const scalar width =
            worst.width*Foam::sqrt(share*spacing/worst.deviation);

        colloid::errorAt
        (
            mesh.boundaryMesh().objectPath(),
            wordList({mesh.boundaryMesh()[worst.patch].name()})
        )
            << "Wall " << mesh.boundaryMesh()[worst.patch].name()
            << " is not resolved: at " << worst.centre << " m its faces are "
            << worst.width << " m wide and bend by " << radToDeg(worst.bend)
            << " degrees," << nl
            << "    so they are " << worst.deviation
            << " m from the smooth surface that they stand for, more than "
            << share << " of the mean spacing of " << spacing << " m." << nl
            << "    Take faces of at most " << width << " m along that wall (in"
            << " blockMeshDict or snappyHexMeshDict)," << nl
            << "    or, if it is an edge, a bend of more than " << featureAngle
            << " degrees" << exit(FatalIOError);
    }
}
