/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ofAllRanks.H"

#include "labelList.H"

#include <gtest/gtest.h>

using namespace Foam;


TEST(ofAllRanks, areByTheNumberOfTheRank)
{
    const label me = Pstream::myProcNo();

    const labelList numbers(ofAllRanks(10 + me));
    const List<labelList> lists(ofAllRanks(labelList(me, 7)));

    ASSERT_EQ(numbers.size(), Pstream::nProcs());
    ASSERT_EQ(lists.size(), Pstream::nProcs());
    forAll(numbers, rank)
    {
        EXPECT_EQ(numbers[rank], 10 + rank);
        EXPECT_EQ(lists[rank], labelList(rank, 7));
    }
}
