/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchLayer.H"
#include "ofAllRanks.H"
#include "periodicAxes.H"

#include "polyMesh.H"

#include <algorithm>

namespace
{

using namespace Foam;

//- How far points of a flat patch may be from its plane, in widths of the mesh
constexpr scalar flatWithin = 1e-6;


//- Coordinates in the order in which points are compared
std::array<scalar, 3> coordinates(const point& p)
{
    return {p.x(), p.y(), p.z()};
}

} // End anonymous namespace


Foam::patchLayer::patchLayer
(
    const polyMesh& mesh,
    const label patch,
    const scalar thickness,
    const scalar roughness,
    const periodicAxes& axes,
    const cloudProperties& properties,
    const dictionary& dict
)
:
    mesh_(mesh),
    patch_(patch),
    thickness_(thickness),
    roughness_(roughness),
    centre_(Zero),
    inward_(Zero)
{
    gatherTriangles();

    if (triangles_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << mesh.boundaryMesh()[patch].name() << " has no faces"
            << exit(FatalIOError);
    }

    vector sum(Zero);
    for (const triangle& t : triangles_)
    {
        const vector area
        (
            0.5*(t.corners[1] - t.corners[0])^(t.corners[2] - t.corners[0])
        );
        sum += area;
        centre_ += (t.corners[0] + t.corners[1] + t.corners[2])/3;
        areaUpTo_.append
        (
            (areaUpTo_.empty() ? 0 : areaUpTo_.last()) + t.area
        );
    }
    centre_ /= triangles_.size();
    inward_ = sum/mag(sum);

    checkFlat(axes, dict);
    findSides(axes, properties, dict);
    findWalls();

    std::vector<FixedList<point, 3>> corners;
    for (const triangle& t : triangles_)
    {
        corners.push_back(t.corners);
    }
    cover_ = std::make_unique<triangleCover>
    (
        corners, inward_, sideGives*thickness_
    );
}


void Foam::patchLayer::gatherTriangles()
{
    const polyPatch& patch = mesh_.boundaryMesh()[patch_];
    const pointField& points = mesh_.points();

    // Corners, and face, of this rank's
    DynamicList<FixedList<point, 3>> corners;
    DynamicList<label> faces;

    // Fans from the corner with the least coordinates: OpenFOAM's own triangles of
    // a face are not the same after decomposePar
    forAll(patch, i)
    {
        const face& f = patch[i];
        label first = 0;
        for (label j = 1; j < f.size(); ++j)
        {
            if (coordinates(points[f[j]]) < coordinates(points[f[first]]))
            {
                first = j;
            }
        }
        for (label j = 1; j < f.size() - 1; ++j)
        {
            // OpenFOAM's normals point out of the water
            corners.append
            (
                FixedList<point, 3>
                {
                    points[f[first]],
                    points[f[(first + j + 1) % f.size()]],
                    points[f[(first + j) % f.size()]]
                }
            );
            faces.append(i);
        }
    }

    const auto allCorners
    (
        ofAllRanks<List<FixedList<point, 3>>>(corners)
    );
    const List<labelList> allFaces(ofAllRanks<labelList>(faces));

    forAll(allCorners, rank)
    {
        forAll(allCorners[rank], i)
        {
            const FixedList<point, 3>& c = allCorners[rank][i];
            triangles_.append
            (
                triangle
                {
                    c, rank, allFaces[rank][i],
                    0.5*mag((c[1] - c[0])^(c[2] - c[0]))
                }
            );
        }
    }

    std::sort
    (
        triangles_.begin(), triangles_.end(),
        [](const triangle& s, const triangle& t)
        {
            return
                coordinates(s.corners[0] + s.corners[1] + s.corners[2])
              < coordinates(t.corners[0] + t.corners[1] + t.corners[2]);
        }
    );
}


void Foam::patchLayer::checkFlat
(
    const periodicAxes& axes,
    const dictionary& dict
) const
{
    const word& name = mesh_.boundaryMesh()[patch_].name();
    const scalar tolerance = flatWithin*mesh_.bounds().mag();

    scalar farthest = 0;
    for (const triangle& t : triangles_)
    {
        for (const point& p : t.corners)
        {
            farthest = max(farthest, mag(depth(p)));
        }
    }
    if (farthest > tolerance)
    {
        FatalIOErrorInFunction(dict)
            << "Patch " << name << " is not flat: points are up to "
            << farthest << " m from its plane." << nl
            << "    An inlet needs a flat patch: divide it (in blockMeshDict,"
            << " or with topoSet and createPatch)" << exit(FatalIOError);
    }

    scalar behind = 0;
    for (const point& p : mesh_.points())
    {
        behind = max(behind, depth(p));
    }
    reduce(behind, maxOp<scalar>());

    if (behind > tolerance)
    {
        FatalIOErrorInFunction(dict)
            << "The mesh reaches " << behind << " m behind the plane of patch "
            << name << ", where its inlet keeps platelets." << nl
            << "    The inlet's patch must bound the mesh on one side"
            << exit(FatalIOError);
    }

    // Each image of the mesh is farther behind a plane that is oblique
    for (direction axis = 0; axis < 3; ++axis)
    {
        if (axes.period(axis)*mag(inward_[axis]) > tolerance)
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << name << ", into the mesh along " << inward_
                << ", is not parallel to the axis " << "xyz"[axis]
                << " along which the mesh is periodic:" << nl
                << "    what follows across the periodic boundary reaches behind"
                << " its plane, where its inlet keeps platelets." << nl
                << "    Turn the patch, or close the mesh there (symmetryPlane)"
                << exit(FatalIOError);
        }
    }
}


Foam::patchLayer::place Foam::patchLayer::at
(
    const FixedList<scalar, 3>& random,
    const scalar depth
) const
{
    return at(random, depth, areaUpTo_);
}


Foam::patchLayer::place Foam::patchLayer::at
(
    const FixedList<scalar, 3>& random,
    const scalar depth,
    const scalarList& weightUpTo
) const
{
    const label i = min
    (
        label
        (
            std::upper_bound
            (
                weightUpTo.begin(), weightUpTo.end(),
                random[0]*weightUpTo.last()
            )
          - weightUpTo.begin()
        ),
        triangles_.size() - 1
    );
    const FixedList<point, 3>& corners = triangles_[i].corners;

    // Uniform in the triangle
    const scalar root = Foam::sqrt(random[1]);
    return
    {
        (1 - root)*corners[0]
      + root*(1 - random[2])*corners[1]
      + root*random[2]*corners[2]
      - depth*inward_,
        i
    };
}


Foam::label Foam::patchLayer::cell(const label triangle) const
{
    return mesh_.boundaryMesh()[patch_].faceCells()[triangles_[triangle].face];
}
