/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rowsById.H"
#include "ofAllRanks.H"

#include "ListOps.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"

#include <utility>

Foam::rowsById::rowsById
(
    labelList&& unsortedIds,
    List<vectorField>&& unsortedColumns
)
:
    ids(std::move(unsortedIds)),
    columns(std::move(unsortedColumns))
{
    if (Pstream::parRun())
    {
        exchange();
    }
    sort();

    const labelList numbers(ofAllRanks(ids.size()));
    forAll(numbers, rank)
    {
        first += (rank < Pstream::myProcNo() ? numbers[rank] : 0);
        total += numbers[rank];
    }
}


void Foam::rowsById::exchange()
{
    const label ranks = Pstream::nProcs();

    label largest = 0;
    for (const label id : ids)
    {
        largest = max(largest, id);
    }
    reduce(largest, maxOp<label>());
    const label idsPerRank = largest/ranks + 1;

    List<DynamicList<label>> rowsFor(ranks);
    forAll(ids, row)
    {
        rowsFor[ids[row]/idsPerRank].append(row);
    }

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    for (label rank = 0; rank < ranks; ++rank)
    {
        const labelUList& rows = rowsFor[rank];
        UOPstream to(rank, buffers);

        to << labelList(UIndirectList<label>(ids, rows));
        for (const vectorField& column : columns)
        {
            to << vectorField(column, rows);
        }
    }
    buffers.finishedSends();

    ids.clear();
    for (vectorField& column : columns)
    {
        column.clear();
    }
    for (label rank = 0; rank < ranks; ++rank)
    {
        UIPstream from(rank, buffers);

        ids.append(labelList(from));
        for (vectorField& column : columns)
        {
            column.append(vectorField(from));
        }
    }
}


void Foam::rowsById::sort()
{
    labelList order;
    sortedOrder(ids, order);

    ids = labelList(UIndirectList<label>(ids, order));
    for (vectorField& column : columns)
    {
        column = vectorField(column, order);
    }
}
