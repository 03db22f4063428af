/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxMesh.H"

#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "wallPolyPatch.H"

#include <algorithm>
#include <map>

using namespace Foam;

namespace
{

const char* const axisNames[] = {"X", "Y", "Z"};

word patchName(const int axis, const int side)
{
    return word(side ? "upper" : "lower") + axisNames[axis];
}


//- Nodes of a face across the axis at the lower side of the cell, its normal
//  along the axis
std::array<indices, 4> corners(const indices& cell, const int axis)
{
    const int b = (axis + 1)%3;
    const int c = (axis + 2)%3;

    std::array<indices, 4> nodes{{cell, cell, cell, cell}};
    ++nodes[1][b];
    ++nodes[2][b];
    ++nodes[2][c];
    ++nodes[3][c];
    return nodes;
}


//- A face of a cell of this rank; turned: the normal points against the axis
struct sideOfCell
{
    label cell;
    face nodes;
};

} // End anonymous namespace


label boxMesh::global(const indices& cell) const
{
    return cell[0] + settings_.n[0]*(cell[1] + settings_.n[1]*cell[2]);
}


bool boxMesh::exists(const indices& cell) const
{
    for (int axis = 0; axis < 3; ++axis)
    {
        if (cell[axis] < 0 || cell[axis] >= settings_.n[axis])
        {
            return false;
        }
    }
    return !settings_.leftOut || !settings_.leftOut(cell);
}


int boxMesh::rankOf(const indices& cell) const
{
    return
        settings_.rank
      ? settings_.rank(cell)
      : int(cell[0]*Pstream::nProcs()/settings_.n[0]);
}


point boxMesh::node(const indices& at) const
{
    const point regular
    (
        settings_.size.x()*at[0]/settings_.n[0],
        settings_.size.y()*at[1]/settings_.n[1],
        settings_.size.z()*at[2]/settings_.n[2]
    );
    return settings_.map ? settings_.map(regular, at) : regular;
}


boxMesh::boxMesh(const boxSettings& settings)
:
    settings_(settings),
    localCell_(settings.n[0]*settings.n[1]*settings.n[2], -1)
{
    const int me = Pstream::myProcNo();
    const indices& n = settings_.n;

    const auto forBox = [](const indices& last, const auto& visit)
    {
        for (label k = 0; k < last[2]; ++k)
        {
            for (label j = 0; j < last[1]; ++j)
            {
                for (label i = 0; i < last[0]; ++i)
                {
                    visit(indices{{i, j, k}});
                }
            }
        }
    };

    DynamicList<label> mine;
    forBox(n, [&](const indices& cell)
    {
        if (exists(cell) && rankOf(cell) == me)
        {
            localCell_[global(cell)] = mine.size();
            mine.append(global(cell));
        }
    });
    globalCell_ = mine;

    // Nodes in use get their number when they are first met
    std::map<indices, label> numbers;
    DynamicList<point> points;
    const auto number = [&](const indices& at)
    {
        const auto found = numbers.emplace(at, points.size());
        if (found.second)
        {
            points.append(node(at));
        }
        return found.first->second;
    };
    const auto faceOf = [&](const indices& cell, const int axis, bool turned)
    {
        face nodes(4);
        label i = 0;
        for (const indices& at : corners(cell, axis))
        {
            nodes[i++] = number(at);
        }
        return turned ? nodes.reverseFace() : nodes;
    };

    std::map<std::pair<label, label>, face> internal;
    std::map<word, std::vector<sideOfCell>> ends;
    std::map<int, std::vector<sideOfCell>> toRank;

    // By rank, axis and side, the side as the lower of the two ranks sees it:
    // so both have the patches between them in the same order
    std::map<std::array<int, 3>, std::vector<sideOfCell>> toRankThrough;

    for (int axis = 0; axis < 3; ++axis)
    {
        indices last(n);
        ++last[axis];

        forBox(last, [&](const indices& above)
        {
            indices below(above);
            --below[axis];

            const bool hasBelow = exists(below);
            const bool hasAbove = exists(above);

            if (hasBelow && hasAbove)
            {
                const int rankBelow = rankOf(below);
                const int rankAbove = rankOf(above);

                if (rankBelow == me && rankAbove == me)
                {
                    internal[{localCell_[global(below)],
                        localCell_[global(above)]}] =
                        faceOf(above, axis, false);
                }
                else if (rankBelow == me)
                {
                    toRank[rankAbove].push_back
                    ({
                        localCell_[global(below)],
                        faceOf(above, axis, false)
                    });
                }
                else if (rankAbove == me)
                {
                    toRank[rankBelow].push_back
                    ({
                        localCell_[global(above)],
                        faceOf(above, axis, true)
                    });
                }
                return;
            }

            // An end of a run of cells: the cell, its side, the other end
            for (const int side : {0, 1})
            {
                if (side == 0 ? !hasAbove : !hasBelow)
                {
                    continue;
                }
                const indices& cell = side == 0 ? above : below;

                indices other(cell);
                indices next(cell);
                while (exists(next))
                {
                    other = next;
                    next[axis] += side == 0 ? 1 : -1;
                }

                if (rankOf(cell) != me)
                {
                    continue;
                }
                const word name(patchName(axis, side));
                const sideOfCell end
                {
                    localCell_[global(cell)],
                    faceOf(above, axis, side == 0)
                };
                const int otherRank = rankOf(other);

                if (settings_.periodic[axis] && otherRank != me)
                {
                    toRankThrough
                        [{{otherRank, axis, me < otherRank ? side : 1 - side}}]
                        .push_back(end);
                }
                else
                {
                    ends[name].push_back(end);
                }
            }
        });
    }

    // OpenFOAM's order: internal faces by owner, then neighbour; then patches
    DynamicList<face> faces;
    DynamicList<label> owner;
    DynamicList<label> neighbour;
    for (const auto& [cells, nodes] : internal)
    {
        faces.append(nodes);
        owner.append(cells.first);
        neighbour.append(cells.second);
    }

    struct patchFaces
    {
        label start;
        label size;
    };
    const auto addPatch = [&](const std::vector<sideOfCell>& sides)
    {
        const patchFaces range{faces.size(), label(sides.size())};
        for (const sideOfCell& side : sides)
        {
            faces.append(side.nodes);
            owner.append(side.cell);
        }
        return range;
    };

    std::map<word, patchFaces> endRanges;
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const int side : {0, 1})
        {
            // The two ends of cyclics were met in the same order: by rows
            // across the axis, except that rows whose runs end later come
            // later at this side
            auto& sides = ends[patchName(axis, side)];
            std::stable_sort
            (
                sides.begin(),
                sides.end(),
                [&](const sideOfCell& a, const sideOfCell& b)
                {
                    const auto row = [&](const sideOfCell& s)
                    {
                        const label g = globalCell_[s.cell];
                        indices at
                        {{g%n[0], g/n[0]%n[1], g/(n[0]*n[1])}};
                        at[axis] = 0;
                        return global(at);
                    };
                    return row(a) < row(b);
                }
            );
            endRanges[patchName(axis, side)] = addPatch(sides);
        }
    }
    std::map<int, patchFaces> rankRanges;
    for (const auto& [rank, sides] : toRank)
    {
        rankRanges[rank] = addPatch(sides);
    }
    std::map<std::array<int, 3>, patchFaces> throughRanges;
    for (const auto& [key, sides] : toRankThrough)
    {
        throughRanges[key] = addPatch(sides);
    }

    dictionary control;
    control.add("startFrom", "startTime");
    control.add("startTime", 0);
    control.add("deltaT", 1);
    control.add("writeInterval", 1);
    control.add("endTime", 10);
    time_.reset
    (
        new Time(control, ".", "boxMesh", "system", "constant", false, false)
    );

    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                fvMesh::defaultRegion,
                time_->timeName(),
                *time_,
                IOobject::NO_READ,
                IOobject::NO_WRITE
            ),
            pointField(points),
            faceList(faces),
            labelList(owner),
            labelList(neighbour),
            false
        )
    );

    PtrList<polyPatch> patches;
    const polyBoundaryMesh& boundary = mesh_->boundaryMesh();

    for (int axis = 0; axis < 3; ++axis)
    {
        for (const int side : {0, 1})
        {
            const word name(patchName(axis, side));
            const patchFaces& range = endRanges.at(name);
            const label index = patches.size();

            if (settings_.periodic[axis])
            {
                patches.append
                (
                    new cyclicPolyPatch
                    (
                        name,
                        range.size,
                        range.start,
                        index,
                        boundary,
                        patchName(axis, 1 - side),
                        cyclicPolyPatch::UNKNOWN,
                        vector(Zero),
                        point(Zero),
                        vector(Zero)
                    )
                );
            }
            else
            {
                patches.append
                (
                    polyPatch::New
                    (
                        settings_.empty[axis] ? "empty" : "wall",
                        name,
                        range.size,
                        range.start,
                        index,
                        boundary
                    ).ptr()
                );
            }
        }
    }
    for (const auto& [rank, range] : rankRanges)
    {
        patches.append
        (
            new processorPolyPatch
            (
                range.size,
                range.start,
                patches.size(),
                boundary,
                me,
                rank
            )
        );
    }
    for (const auto& [key, range] : throughRanges)
    {
        patches.append
        (
            new processorCyclicPolyPatch
            (
                range.size,
                range.start,
                patches.size(),
                boundary,
                me,
                key[0],
                patchName(key[1], me < key[0] ? key[2] : 1 - key[2])
            )
        );
    }

    mesh_->addFvPatches(patches);
}


label boxMesh::cellAt(const point& p) const
{
    indices cell;
    for (int axis = 0; axis < 3; ++axis)
    {
        const label i = label
        (
            std::floor(p[axis]/settings_.size[axis]*settings_.n[axis])
        );
        cell[axis] = min(max(i, label(0)), settings_.n[axis] - 1);
    }
    return localCell_[global(cell)];
}
