/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "waterLimits.H"
#include "errorAt.H"
#include "ofAllRanks.H"
#include "reducedUnits.H"

#include "emptyPolyPatch.H"
#include "ListOps.H"
#include "polyMesh.H"
#include "polyMeshTetDecomposition.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPolyPatch.H"
#include "wedgePolyPatch.H"

#include <iomanip>
#include <sstream>
#include <vector>

const Foam::polyMesh& Foam::waterLimits::withCells(const polyMesh& mesh)
{
    if (returnReduce(mesh.nCells(), sumOp<label>()) == 0)
    {
        FatalErrorInFunction
            << "The mesh has no cells: run blockMesh (or another mesher) first"
            << exit(FatalError);
    }
    return mesh;
}


Foam::cloudProperties::patchAction Foam::waterLimits::actionOf
(
    const polyMesh& mesh,
    const label patchi,
    const cloudProperties& properties
)
{
    using action = cloudProperties::patchAction;

    const polyPatch& patch = mesh.boundaryMesh()[patchi];
    const action said = properties.actionOf(patch.name());

    if (isA<emptyPolyPatch>(patch) || isA<wedgePolyPatch>(patch))
    {
        colloid::errorAt
        (
            mesh.boundaryMesh().objectPath(), wordList({patch.name()})
        )
            << "Patch " << patch.name() << " is of type " << patch.type()
            << ": platelets move in three dimensions." << nl
            << "    Use a pair of cyclic patches instead (periodic), or"
            << " symmetryPlane. Flow model HeleShaw, which needs empty patches,"
            << nl << "    is for clay as a continuum (erosionFoam)"
            << exit(FatalIOError);
    }

    if (said != action::automatic)
    {
        return said;
    }
    if (isA<wallPolyPatch>(patch))
    {
        return action::platelet;
    }
    if (isA<symmetryPlanePolyPatch>(patch) || isA<symmetryPolyPatch>(patch))
    {
        return action::reflect;
    }
    return action::absorb;
}


plateletDynamics::boundarySurface::action Foam::waterLimits::asAction
(
    const polyMesh& mesh,
    const label patchi,
    const cloudProperties& properties
)
{
    using action = cloudProperties::patchAction;
    using plateletDynamics::boundarySurface;

    switch (actionOf(mesh, patchi, properties))
    {
        case action::platelet:
            return boundarySurface::action::platelet;
        case action::reflect:
            return boundarySurface::action::reflect;
        default:
            return boundarySurface::action::absorb;
    }
}


plateletDynamics::boundarySurface Foam::waterLimits::triangles
(
    const polyMesh& mesh,
    const cloudProperties& properties,
    const scalar lengthUnit
)
{
    using plateletDynamics::boundarySurface;

    properties.checkPatches(mesh.boundaryMesh().names());

    // Corners and patch number of each triangle of this rank
    DynamicList<FixedList<point, 3>> corners;
    DynamicList<label> patchOf;

    // Made by all ranks together; some may have no face here
    mesh.tetBasePtIs();

    forAll(mesh.boundaryMesh(), patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];

        if (patch.coupled() || properties.isInlet(patch.name()))
        {
            continue;
        }

        forAll(patch, i)
        {
            const label facei = patch.start() + i;

            // The triangles that OpenFOAM tracks platelets through
            for
            (
                const tetIndices& tet
              : polyMeshTetDecomposition::faceTetIndices
                (
                    mesh, facei, mesh.faceOwner()[facei]
                )
            )
            {
                // OpenFOAM's normals point out of the water
                const triFace tri(tet.faceTriIs(mesh));
                const pointField& points = mesh.points();
                corners.append
                (
                    FixedList<point, 3>
                    {
                        points[tri[0]], points[tri[2]], points[tri[1]]
                    }
                );
                patchOf.append(patchi);
            }
        }
    }

    const auto allCorners
    (
        ofAllRanks<List<FixedList<point, 3>>>(corners)
    );
    const List<labelList> allPatches(ofAllRanks<labelList>(patchOf));

    // Actions once per patch (global patches have the same number everywhere)
    std::vector<boundarySurface::action> does
    (
        mesh.boundaryMesh().size(),
        boundarySurface::action::absorb
    );
    forAll(mesh.boundaryMesh(), patchi)
    {
        if (!mesh.boundaryMesh()[patchi].coupled())
        {
            does[patchi] = asAction(mesh, patchi, properties);
        }
    }

    boundarySurface surface;
    forAll(allCorners, proci)
    {
        forAll(allCorners[proci], i)
        {
            boundarySurface::triangle triangle;
            for (label j = 0; j < 3; ++j)
            {
                triangle.corners[j] =
                    reduced(allCorners[proci][i][j], lengthUnit);
            }
            triangle.patch = allPatches[proci][i];
            triangle.does = does[triangle.patch];
            surface.triangles.push_back(triangle);
        }
    }
    return surface;
}


void Foam::waterLimits::print
(
    Ostream& os,
    const polyMesh& mesh,
    const cloudProperties& properties
)
{
    using action = cloudProperties::patchAction;

    os  << "Patches" << nl;
    for (label i = 0; i < mesh.boundaryMesh().nNonProcessor(); ++i)
    {
        const polyPatch& patch = mesh.boundaryMesh()[i];
        const bool said =
            properties.actionOf(patch.name()) != action::automatic
         || properties.isInlet(patch.name());

        std::ostringstream text;
        text
            << "    " << std::left << std::setw(16) << patch.name() << ' '
            << std::setw(10)
            << (
                   patch.coupled() ? "periodic"
                 : properties.isInlet(patch.name()) ? "inlet"
                 : cloudProperties::patchActionNames
                   [
                       actionOf(mesh, i, properties)
                   ].c_str()
               )
            << (said && !patch.coupled() ? "user" : patch.type().c_str());
        os  << text.str().c_str() << nl;
    }
    os  << endl;
}
