/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rowsById.H"

#include "ListOps.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"

#include <limits>

Foam::rowsById::rowsById
(
    const labelUList& unsortedIds,
    const List<vectorField>& unsorted
)
:
    columns(unsorted.size())
{
    label largest = -1;
    for (const label id : unsortedIds)
    {
        largest = max(largest, id);
    }
    total = returnReduce(largest, maxOp<label>()) + 1;
    number = returnReduce(unsortedIds.size(), sumOp<label>());

    const label ranks = Pstream::parRun() ? Pstream::nProcs() : 1;
    const label rank = Pstream::parRun() ? Pstream::myProcNo() : 0;
    const label rowsPerRank = max(label(1), (total + ranks - 1)/ranks);
    first = min(rank*rowsPerRank, total);

    labelList found(unsortedIds);
    List<vectorField> values(unsorted);
    if (Pstream::parRun())
    {
        exchange(found, values, rowsPerRank);
    }

    const label rows = min(rowsPerRank, total - first);
    ids.setSize(rows, -1);
    forAll(found, i)
    {
        ids[found[i] - first] = found[i];
    }
    forAll(columns, columni)
    {
        columns[columni].setSize
        (
            rows, vector::uniform(std::numeric_limits<scalar>::quiet_NaN())
        );
        forAll(found, i)
        {
            columns[columni][found[i] - first] = values[columni][i];
        }
    }
}


void Foam::rowsById::exchange
(
    labelList& unsortedIds,
    List<vectorField>& unsorted,
    const label rowsPerRank
)
{
    const label ranks = Pstream::nProcs();

    List<DynamicList<label>> rowsFor(ranks);
    forAll(unsortedIds, row)
    {
        rowsFor[unsortedIds[row]/rowsPerRank].append(row);
    }

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    for (label rank = 0; rank < ranks; ++rank)
    {
        const labelUList& rows = rowsFor[rank];
        UOPstream to(rank, buffers);

        to << labelList(UIndirectList<label>(unsortedIds, rows));
        for (const vectorField& column : unsorted)
        {
            to << vectorField(column, rows);
        }
    }
    buffers.finishedSends();

    unsortedIds.clear();
    for (vectorField& column : unsorted)
    {
        column.clear();
    }
    for (label rank = 0; rank < ranks; ++rank)
    {
        UIPstream from(rank, buffers);

        unsortedIds.append(labelList(from));
        for (vectorField& column : unsorted)
        {
            column.append(vectorField(from));
        }
    }
}
