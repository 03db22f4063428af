/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchRim.H"
#include "ofAllRanks.H"
#include "periodicAxes.H"

#include "DynamicList.H"
#include "polyMesh.H"
#include "processorCyclicPolyPatch.H"
#include "SubField.H"

#include <algorithm>
#include <array>
#include <map>

namespace
{

using namespace Foam;

//- Cosine of the angle between normals from which two faces are in one plane
constexpr scalar inOnePlane = 0.99;

//- How far the two sides of periodic boundaries may differ, in edges
constexpr scalar periodicWithin = 1e-3;


//- An edge by the coordinates of its ends, whichever comes first
using edgeKey = std::array<scalar, 6>;

edgeKey key(const point& a, const point& b)
{
    const edgeKey forward{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
    const edgeKey backward{b.x(), b.y(), b.z(), a.x(), a.y(), a.z()};
    return std::min(forward, backward);
}


//- Whether two edges are images of each other, not the same one
bool areImages
(
    const periodicAxes& axes,
    const patchRim::edge& e,
    const point& a,
    const point& b
)
{
    const scalar tolerance = periodicWithin*mag(e.b - e.a);
    const vector way(0.5*(a + b) - 0.5*(e.a + e.b));

    return mag(way) > tolerance && mag(axes.nearestImage(way)) < tolerance;
}

} // End anonymous namespace


bool Foam::patchRim::coupled(const label following) const
{
    return mesh_.boundaryMesh()[mag(following) - 1].coupled();
}


void Foam::patchRim::findEdges()
{
    const polyPatch& patch = mesh_.boundaryMesh()[patch_];

    // Ends of the edges of this rank's faces, and the centres of the faces
    DynamicList<point> ownEnds;
    DynamicList<point> ownCentres;
    forAll(patch, i)
    {
        const face& f = patch[i];
        forAll(f, j)
        {
            ownEnds.append(patch.points()[f[j]]);
            ownEnds.append(patch.points()[f.nextLabel(j)]);
            ownCentres.append(patch.faceCentres()[i]);
        }
    }
    const List<List<point>> ends(ofAllRanks<List<point>>(ownEnds));
    const List<List<point>> centres(ofAllRanks<List<point>>(ownCentres));

    std::map<edgeKey, edge> rim;
    std::map<edgeKey, label> faces;
    forAll(ends, rank)
    {
        forAll(centres[rank], i)
        {
            const point& a = ends[rank][2*i];
            const point& b = ends[rank][2*i + 1];
            const edgeKey k(key(a, b));

            ++faces[k];
            vector inwards(centres[rank][i] - a);
            const vector along((b - a)/mag(b - a));
            inwards -= (inwards & along)*along;
            rim[k] = {a, b, inwards/mag(inwards), -1, false};
        }
    }
    for (const auto& found : rim)
    {
        if (faces[found.first] == 1)
        {
            edges_.append(found.second);
        }
    }
}


template<class NumberOf>
Foam::labelList Foam::patchRim::follow(const NumberOf& numberOf) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    labelList following(edges_.size(), Zero);

    // A periodic boundary only where nothing else follows
    const auto put = [&](label& x, const label y)
    {
        if (y && (x == 0 || coupled(x)))
        {
            x = y;
        }
    };

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
                const label edgei = numberOf
                (
                    patch.points()[f[j]], patch.points()[f.nextLabel(j)]
                );
                if (edgei >= 0)
                {
                    const bool flat =
                        mag(patch.faceNormals()[i] & normal_) > inOnePlane;
                    put(following[edgei], flat ? -1 - number : number + 1);
                }
            }
        }
    }

    Pstream::listCombineGather(following, put);
    Pstream::listCombineScatter(following);
    return following;
}


Foam::labelList Foam::patchRim::followAcross
(
    const labelUList& onBoundary,
    const periodicAxes& axes,
    const dictionary& dict
) const
{
    // Those that are no image of another
    DynamicList<label> ending;
    for (const label i : onBoundary)
    {
        const bool goesOn = std::any_of
        (
            onBoundary.begin(), onBoundary.end(),
            [&](const label j)
            {
                return areImages(axes, edges_[i], edges_[j].a, edges_[j].b);
            }
        );
        if (!goesOn)
        {
            ending.append(i);
        }
    }
    if (ending.empty())
    {
        return labelList(edges_.size(), Zero);
    }

    const labelList following
    (
        follow
        (
            [&](const point& a, const point& b)
            {
                for (const label i : ending)
                {
                    if (areImages(axes, edges_[i], a, b))
                    {
                        return i;
                    }
                }
                return label(-1);
            }
        )
    );
    for (const label i : ending)
    {
        checkFollowed(i, following[i] && !coupled(following[i]), dict);
    }
    return following;
}


void Foam::patchRim::checkFollowed
(
    const label edgei,
    const bool followed,
    const dictionary& dict
) const
{
    if (!followed)
    {
        FatalIOErrorInFunction(dict)
            << "No patch follows that of the inlet, "
            << mesh_.boundaryMesh()[patch_].name() << ", at its edge "
            << edges_[edgei].a << ' ' << edges_[edgei].b << exit(FatalIOError);
    }
}


Foam::patchRim::patchRim
(
    const polyMesh& mesh,
    const label patch,
    const vector& normal,
    const periodicAxes& axes,
    const dictionary& dict
)
:
    mesh_(mesh),
    patch_(patch),
    normal_(normal)
{
    findEdges();

    std::map<edgeKey, label> numbers;
    forAll(edges_, i)
    {
        numbers[key(edges_[i].a, edges_[i].b)] = i;
    }
    labelList following
    (
        follow
        (
            [&](const point& a, const point& b)
            {
                const auto found = numbers.find(key(a, b));
                return found == numbers.end() ? label(-1) : found->second;
            }
        )
    );

    DynamicList<label> onBoundary;
    forAll(following, i)
    {
        checkFollowed(i, following[i], dict);
        if (coupled(following[i]))
        {
            onBoundary.append(i);
        }
    }

    const labelList across(followAcross(onBoundary, axes, dict));
    for (const label i : onBoundary)
    {
        following[i] = across[i];
    }

    List<edge> ends;
    forAll(edges_, i)
    {
        if (following[i] != 0)
        {
            ends.append(edges_[i]);
            ends.last().beyond = mag(following[i]) - 1;
            ends.last().inPlane = following[i] < 0;
        }
    }
    edges_ = ends;
}
