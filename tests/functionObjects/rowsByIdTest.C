/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rowsById.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <gtest/gtest.h>

#include <cmath>

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
    return rowsById(ids, columns);
}

} // End anonymous namespace


TEST(rowsById, areThoseOfTheirIdsOverAllRanks)
{
    const label number = 1001;
    const rowsById rows(dealt(number));

    EXPECT_EQ(rows.number, number);
    EXPECT_EQ(rows.total, 3*(number - 1) + 1);
    EXPECT_EQ(returnReduce(rows.ids.size(), sumOp<label>()), rows.total);
    ASSERT_EQ(rows.columns.size(), 2);

    forAll(rows.ids, i)
    {
        const label row = rows.first + i;
        const scalar id = row;
        if (row % 3 == 0)
        {
            EXPECT_EQ(rows.ids[i], row);
            EXPECT_EQ(rows.columns[0][i], vector(id, -id, 0.5));
            EXPECT_EQ(rows.columns[1][i], vector(id*id, 0, id));
        }
        else
        {
            EXPECT_EQ(rows.ids[i], -1);
            EXPECT_TRUE(std::isnan(rows.columns[0][i].x()));
            EXPECT_TRUE(std::isnan(rows.columns[1][i].z()));
        }
    }
}


TEST(rowsById, areSharedEvenly)
{
    const rowsById rows(dealt(1001));
    EXPECT_NEAR(rows.ids.size(), 3001.0/Pstream::nProcs(), 4);
}


TEST(rowsById, mayBeFewerThanRanks)
{
    for (const label number : {0, 1, 2})
    {
        const rowsById rows(dealt(number));
        const label total = max(label(0), 3*(number - 1) + 1);

        EXPECT_EQ(rows.number, number);
        EXPECT_EQ(rows.total, total);
        EXPECT_EQ(returnReduce(rows.ids.size(), sumOp<label>()), total);
    }
}
