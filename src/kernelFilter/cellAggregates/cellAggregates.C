/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellAggregates.H"

#include "ListOps.H"
#include "PstreamBuffers.H"
#include "SortableList.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

//- The part of a cube by which the cubes begin before the mesh does: no
//  simple fraction, so that cell centres of a regular mesh don't lie on the
//  cubes' faces, where round-off would decide (and differ between ranks)
constexpr scalar anchor = 0.3819660112501051;


//- Order of cubes: by z, y, x
bool precedes(const vector& a, const vector& b)
{
    return
        a.z() != b.z() ? a.z() < b.z()
      : a.y() != b.y() ? a.y() < b.y()
      : a.x() < b.x();
}


vector directionsThatCount(const polyMesh& mesh)
{
    vector counts;
    for (direction axis = 0; axis < 3; ++axis)
    {
        counts[axis] = mesh.geometricD()[axis] > 0;
    }
    return counts;
}

} // End anonymous namespace

} // End namespace Foam


struct Foam::cellAggregates::share
{
    //- Position of the cube among cubes (whole numbers, too large for label)
    vector cube = Zero;

    label nCells = 0;
    scalar volume = 0;
    vector moment = Zero;
    vector least = vector::uniform(GREAT);
    vector most = vector::uniform(-GREAT);

    //- False where another rank counts the volume
    bool own = true;

    //- OpenFOAM writes lists of equals in short
    bool operator!=(const share& s) const
    {
        return
            cube != s.cube || nCells != s.nCells || volume != s.volume
         || moment != s.moment || least != s.least || most != s.most;
    }

    friend Ostream& operator<<(Ostream& os, const share& s)
    {
        return os
            << s.cube << s.nCells << s.volume << s.moment << s.least << s.most;
    }

    friend Istream& operator>>(Istream& is, share& s)
    {
        return is
            >> s.cube >> s.nCells >> s.volume >> s.moment >> s.least >> s.most;
    }
};


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

void Foam::cellAggregates::add(share& sum, const share& part)
{
    sum.nCells += part.nCells;
    sum.volume += part.volume;
    sum.moment += part.moment;
    sum.least = min(sum.least, part.least);
    sum.most = max(sum.most, part.most);
}


void Foam::cellAggregates::join(DynamicList<share>& shares)
{
    if (!Pstream::parRun())
    {
        return;
    }

    // What cubes the ranks have, roughly
    List<Pair<vector>> reach(Pstream::nProcs());
    {
        Pair<vector>& mine = reach[Pstream::myProcNo()];
        mine.first() = vector::uniform(GREAT);
        mine.second() = vector::uniform(-GREAT);
        for (const share& s : shares)
        {
            mine.first() = min(mine.first(), s.cube);
            mine.second() = max(mine.second(), s.cube);
        }
    }
    Pstream::gatherList(reach);
    Pstream::scatterList(reach);

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);

    for (label proci = 0; proci < Pstream::nProcs(); ++proci)
    {
        if (proci == Pstream::myProcNo())
        {
            continue;
        }

        DynamicList<share> common;
        for (const share& s : shares)
        {
            if
            (
                s.cube == max(s.cube, reach[proci].first())
             && s.cube == min(s.cube, reach[proci].second())
            )
            {
                common.append(s);
            }
        }
        if (common.size())
        {
            UOPstream toRank(proci, buffers);
            toRank << static_cast<const List<share>&>(common);
        }
    }

    labelList received;
    buffers.finishedSends(received);

    // In the order of ranks, so that all who share an aggregate get the same
    List<share> mine(shares);
    for (share& s : shares)
    {
        const vector cube(s.cube);
        s = share();
        s.cube = cube;
    }

    for (label proci = 0; proci < Pstream::nProcs(); ++proci)
    {
        List<share> theirs;
        if (proci == Pstream::myProcNo())
        {
            theirs = mine;
        }
        else if (received[proci])
        {
            UIPstream fromRank(proci, buffers);
            fromRank >> theirs;
        }

        for (const share& s : theirs)
        {
            share* found = std::lower_bound
            (
                shares.begin(),
                shares.end(),
                s,
                [](const share& a, const share& b)
                {
                    return precedes(a.cube, b.cube);
                }
            );
            if (found != shares.end() && found->cube == s.cube)
            {
                // The first rank that has cells of it counts its volume
                if (found->nCells == 0)
                {
                    found->own = proci == Pstream::myProcNo();
                }
                add(*found, s);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

Foam::cellAggregates::cellAggregates
(
    const fvMesh& mesh,
    const periodicAxes& axes,
    const scalar cube
)
:
    counts_(directionsThatCount(mesh)),
    aggregateOf_(mesh.nCells()),
    offsets_(mesh.nCells()),
    gathered_(false)
{
    const vectorField& cellCentres = mesh.cellCentres();
    const scalarField& cellVolumes = mesh.cellVolumes();

    const vector origin
    (
        axes.lower(0) - anchor*cube,
        axes.lower(1) - anchor*cube,
        axes.lower(2) - anchor*cube
    );

    vectorField cubes(mesh.nCells());
    forAll(cubes, celli)
    {
        const vector where((cellCentres[celli] - origin)/cube);
        cubes[celli] = counting
        (
            vector
            (
                std::floor(where.x()),
                std::floor(where.y()),
                std::floor(where.z())
            )
        );

        // From the middle of the cube, where digits are not lost
        offsets_[celli] = counting
        (
            (cellCentres[celli] - origin)
          - (cubes[celli] + vector::uniform(0.5))*cube
        );
    }

    labelList order(identity(mesh.nCells()));
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            return precedes(cubes[a], cubes[b]);
        }
    );

    DynamicList<share> shares;
    for (const label celli : order)
    {
        if (shares.empty() || shares.last().cube != cubes[celli])
        {
            shares.append(share());
            shares.last().cube = cubes[celli];
        }
        aggregateOf_[celli] = shares.size() - 1;

        share part;
        part.nCells = 1;
        part.volume = cellVolumes[celli];
        part.moment = cellVolumes[celli]*offsets_[celli];
        part.least = offsets_[celli];
        part.most = offsets_[celli];
        add(shares.last(), part);
    }

    join(shares);

    centres_.setSize(shares.size());
    ownVolumes_.setSize(shares.size());
    halfWidths_.setSize(shares.size());
    vectorField fromMiddle(shares.size());

    forAll(shares, i)
    {
        const share& s = shares[i];

        fromMiddle[i] = s.moment/s.volume;
        centres_[i] = counting
        (
            origin + (s.cube + vector::uniform(0.5))*cube + fromMiddle[i]
        );
        ownVolumes_[i] = s.own ? s.volume : 0;
        halfWidths_[i] = max(s.most - fromMiddle[i], fromMiddle[i] - s.least);
        gathered_ = gathered_ || s.nCells > 1;
    }

    forAll(offsets_, celli)
    {
        offsets_[celli] -= fromMiddle[aggregateOf_[celli]];
    }
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

void Foam::cellAggregates::reorder(const labelUList& order)
{
    centres_ = pointField(centres_, order);
    ownVolumes_ = scalarField(ownVolumes_, order);
    halfWidths_ = vectorField(halfWidths_, order);

    const labelList newNumber(invert(order.size(), order));
    for (label& aggregate : aggregateOf_)
    {
        aggregate = newNumber[aggregate];
    }
}
