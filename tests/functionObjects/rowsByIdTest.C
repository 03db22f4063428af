/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rowsById.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Every third number is an id; they are dealt to the ranks from the largest
rowsById dealt(const label number)
{
    labelList ids;
    vectorField once, squared;
    for (label i = number - 1; i >= 0; --i)
    {
        if (i % Pstream::nProcs() == Pstream::myProcNo())
        {
            const scalar id = 3*i;
            ids.append(3*i);
            once.append(vector(id, -id, 0.5));
            squared.append(vector(id*id, 0, id));
        }
    }
    List<vectorField> columns(2);
    columns[0] = once;
    columns[1] = squared;
    return rowsById(std::move(ids), std::move(columns));
}

} // End anonymous namespace


TEST(rowsById, areInTheOrderOfIdsOverAllRanks)
{
    const label number = 1001;
    const rowsById rows(dealt(number));

    EXPECT_EQ(rows.total, number);
    EXPECT_EQ(returnReduce(rows.ids.size(), sumOp<label>()), number);
    ASSERT_EQ(rows.columns.size(), 2);

    // Without gaps in the rows, the id says which row it is
    forAll(rows.ids, row)
    {
        const scalar id = rows.ids[row];
        EXPECT_EQ(rows.ids[row], 3*(rows.first + row));
        EXPECT_EQ(rows.columns[0][row], vector(id, -id, 0.5));
        EXPECT_EQ(rows.columns[1][row], vector(id*id, 0, id));
    }
}


TEST(rowsById, areSharedEvenlyWhereNoIdIsMissing)
{
    const rowsById rows(dealt(1001));
    EXPECT_NEAR(rows.ids.size(), 1001.0/Pstream::nProcs(), 2);
}


TEST(rowsById, mayBeFewerThanRanks)
{
    for (const label number : {0, 1, 2})
    {
        const rowsById rows(dealt(number));
        EXPECT_EQ(rows.total, number);
        EXPECT_EQ(returnReduce(rows.ids.size(), sumOp<label>()), number);
    }
}
