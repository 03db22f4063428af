/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluxSurface.H"
#include "caseFile.H"
#include "checkWords.H"
#include "errorAt.H"
#include "ofAllRanks.H"
#include "periodicAxes.H"
#include "readInRange.H"

#include "cyclicPolyPatch.H"
#include "OSspecific.H"
#include "processorCyclicPolyPatch.H"
#include "SubList.H"
#include "syncTools.H"
#include "triSurface.H"

namespace
{

using namespace Foam;

//- How far a plane reaches beyond sides that are not periodic, in extents of the
//  mesh: none may pass beside it because of rounding
constexpr scalar margin = 1e-3;

//- Rounding of a mesh, in its extents
constexpr scalar roundOff = 1e-9;


const wordList& wordsFor(const word& type)
{
    static const HashTable<wordList> words
    {
        {"patch", {"type", "patch"}},
        {"faceZone", {"type", "zone"}},
        {"plane", {"type", "point", "normal"}},
        {"triSurface", {"type", "file", "scale"}}
    };
    return words[type];
}


//- What of a polygon is on that side (1: above, -1: below) of a coordinate
DynamicList<point> keptOf
(
    const UList<point>& polygon,
    const direction axis,
    const scalar limit,
    const scalar side
)
{
    DynamicList<point> kept(polygon.size() + 1);

    forAll(polygon, i)
    {
        const point& a = polygon[i];
        const point& b = polygon[polygon.fcIndex(i)];
        const scalar insideA = side*(a[axis] - limit);
        const scalar insideB = side*(b[axis] - limit);

        if (insideA >= 0)
        {
            kept.append(a);
        }
        if ((insideA > 0 && insideB < 0) || (insideA < 0 && insideB > 0))
        {
            point between(a + insideA/(insideA - insideB)*(b - a));

            // Lest images of a periodic mesh leave a gap, or overlap
            between[axis] = limit;
            kept.append(between);
        }
    }
    return kept;
}

} // End anonymous namespace


void Foam::fluxSurface::append
(
    const polyMesh& mesh,
    const label facei,
    const bool flip
)
{
    const face& f = mesh.faces()[facei];
    DynamicList<face> parts;

    (flip ? f.reverseFace() : f).triangles(mesh.points(), parts);

    for (const face& part : parts)
    {
        triangles_.append
        (
            triangle
            {
                mesh.points()[part[0]],
                mesh.points()[part[1]],
                mesh.points()[part[2]]
            }
        );
    }
}


void Foam::fluxSurface::gather()
{
    const List<List<triangle>> all(ofAllRanks<List<triangle>>(triangles_));

    triangles_.clear();
    for (const List<triangle>& ofRank : all)
    {
        triangles_.append(ofRank);
    }
}


void Foam::fluxSurface::readPatch
(
    const polyMesh& mesh,
    const dictionary& dict,
    const labelHashSet& passable
)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const word name(dict.get<word>("patch"));

    colloid::checkChoice
    (
        dict,
        "patch",
        name,
        SubList<word>(patches.names(), patches.nNonProcessor())
    );
    description_ = "patch " + name + ", outwards";

    if
    (
        !isA<cyclicPolyPatch>(patches[name])
     && !passable.found(patches.findPatchID(name))
    )
    {
        openPatch_ = name;
        return;
    }

    for (const polyPatch& patch : patches)
    {
        // Also what decomposition has made of it
        const auto* part = isA<processorCyclicPolyPatch>(patch);

        if (part ? part->referPatchName() == name : patch.name() == name)
        {
            forAll(patch, i)
            {
                append(mesh, patch.start() + i, false);
            }
        }
    }
    gather();
}


void Foam::fluxSurface::readZone(const polyMesh& mesh, const dictionary& dict)
{
    const word name(dict.get<word>("zone"));
    colloid::checkChoice(dict, "zone", name, mesh.faceZones().names());
    const faceZone& zone = mesh.faceZones()[name];
    description_ = "faceZone " + name;

    // A face between ranks, or the two halves of a cyclic one, count once
    const label nInternal = mesh.nInternalFaces();
    boolList isInZone;
    isInZone.setSize(mesh.nBoundaryFaces(), false);
    for (const label facei : zone)
    {
        if (facei >= nInternal)
        {
            isInZone[facei - nInternal] = true;
        }
    }
    boolList otherIsInZone(isInZone);
    syncTools::swapBoundaryFaceList(mesh, otherIsInZone);

    forAll(zone, i)
    {
        const label facei = zone[i];

        if (facei >= nInternal && otherIsInZone[facei - nInternal])
        {
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            const auto* coupled =
                isA<coupledPolyPatch>(mesh.boundaryMesh()[patchi]);

            if (coupled && !coupled->owner())
            {
                continue;
            }
        }
        append(mesh, facei, zone.flipMap()[i]);
    }
    gather();

    if (triangles_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The faceZone " << name << " has no faces" << exit(FatalIOError);
    }
}


void Foam::fluxSurface::readPlane(const polyMesh& mesh, const dictionary& dict)
{
    const point origin(dict.get<point>("point"));
    vector normal(dict.get<vector>("normal"));

    if (mag(normal) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "normal is " << normal << "; it should not be zero"
            << exit(FatalIOError);
    }
    normal.normalise();

    const periodicAxes axes(mesh);
    const boundBox& bounds = mesh.bounds();
    const scalar extent = bounds.mag();
    const scalarField height((mesh.points() - origin) & normal);
    const scalar lowest = gMin(height);
    const scalar highest = gMax(height);

    if (lowest > roundOff*extent || highest < -roundOff*extent)
    {
        FatalIOErrorInFunction(dict)
            << "The plane through " << origin << " does not meet the mesh: along"
            << " its normal that is from " << lowest << " m to " << highest
            << " m away." << nl << "    The mesh spans " << bounds.min() << ' '
            << bounds.max() << " m" << exit(FatalIOError);
    }

    OStringStream text;
    text<< "plane through " << origin << " m along " << normal;
    description_ = text.str();

    // A square around what is to be kept of it, at the middle of the mesh
    vector aside(Zero);
    direction least = 0;
    for (direction axis = 1; axis < 3; ++axis)
    {
        if (mag(normal[axis]) < mag(normal[least]))
        {
            least = axis;
        }
    }
    aside[least] = 1;

    const vector toMiddle(bounds.centre() - origin);
    const point middle(origin + (toMiddle - (toMiddle & normal)*normal));
    const vector a(4*extent*normalised(normal ^ aside));
    const vector b(normal ^ a);

    DynamicList<point> polygon;
    polygon.append(middle - a - b);
    polygon.append(middle + a - b);
    polygon.append(middle + a + b);
    polygon.append(middle - a + b);

    for (direction axis = 0; axis < 3; ++axis)
    {
        const scalar beyond = axes.periodic(axis) ? 0 : margin*extent;

        polygon = keptOf(polygon, axis, axes.lower(axis) - beyond, 1);
        polygon = keptOf(polygon, axis, axes.upper(axis) + beyond, -1);
    }
    for (label i = 2; i < polygon.size(); ++i)
    {
        triangles_.append(triangle{polygon[0], polygon[i - 1], polygon[i]});
    }
}


void Foam::fluxSurface::readFile(const polyMesh& mesh, const dictionary& dict)
{
    const fileName name(dict.get<fileName>("file"));
    const fileName path(colloid::caseFile(name, "constant/triSurface"));
    const scalar scale =
        colloid::readInRange(dict, "scale", 1, VSMALL, GREAT, "");

    // Other ranks need not see the file
    if (Pstream::master())
    {
        if (!isFile(path))
        {
            colloid::errorAt(dict, "file")
                << "There is no file " << path << nl
                << "    The folder holds: "
                << flatOutput(readDir(path.path(), fileName::FILE, false))
                << exit(FatalIOError);
        }

        const triSurface surface(path);
        for (const labelledTri& tri : surface)
        {
            triangles_.append
            (
                triangle
                {
                    scale*surface.points()[tri[0]],
                    scale*surface.points()[tri[1]],
                    scale*surface.points()[tri[2]]
                }
            );
        }
    }
    gather();
    description_ = "triSurface " + name;
    Info<< "Reading " << path << endl;

    const boundBox& bounds = mesh.bounds();
    boundBox around;
    bool meets = false;
    for (const triangle& corners : triangles_)
    {
        boundBox ofOne;
        for (const point& corner : corners)
        {
            ofOne.add(corner);
        }
        around.add(ofOne);
        meets = meets || ofOne.overlaps(bounds);
    }

    if (!meets)
    {
        FatalIOErrorInFunction(dict)
            << "The surface " << name << " is outside the mesh: it spans "
            << around.min() << ' ' << around.max() << " m, the mesh "
            << bounds.min() << ' ' << bounds.max() << " m." << nl
            << "    Is it in other units than metres? Then   scale 1e-6;   for"
            << " instance" << exit(FatalIOError);
    }
}


Foam::fluxSurface::fluxSurface
(
    const polyMesh& mesh,
    const dictionary& dict,
    const labelHashSet& passable
)
{
    const word type(dict.get<word>("type"));
    colloid::checkChoice
    (
        dict, "type", type, wordList({"patch", "faceZone", "plane", "triSurface"})
    );
    colloid::checkWords(dict, wordsFor(type));

    if (type == "patch")
    {
        readPatch(mesh, dict, passable);
    }
    else if (type == "faceZone")
    {
        readZone(mesh, dict);
    }
    else if (type == "plane")
    {
        readPlane(mesh, dict);
    }
    else
    {
        readFile(mesh, dict);
    }
}
