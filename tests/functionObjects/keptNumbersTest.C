/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxMesh.H"
#include "keptNumbers.H"
#include "OSspecific.H"
#include "StringStream.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

dictionary made(const string& text)
{
    return dictionary(IStringStream(text)());
}


//- The numbers that go on where they were kept with one thing, and another is there
scalarList goOn(const string& before, const string& now)
{
    const boxMesh box({});
    const Time& time = box.mesh().time();

    HashTable<scalarList> lists;
    lists.set("sums", scalarList({1.0/3.0, -2e-30}));
    const keptNumbers saved(time, "keptNumbersTest", lists, made(before));
    saved.save();

    const scalarList found
    (
        keptNumbers(time, "keptNumbersTest", made(now)).lists.lookup
        (
            "sums", scalarList()
        )
    );
    rmDir(time.path());
    return found;
}

} // End anonymous namespace


TEST(keptNumbers, goOnToTheBitWithWhatTheyWereMadeWith)
{
    // Ranks have no folders of their own here
    if (Pstream::parRun())
    {
        return;
    }
    const scalarList all({1.0/3.0, -2e-30});

    EXPECT_EQ(goOn("", ""), all);
    EXPECT_EQ(goOn("patch gel;", "patch gel;"), all);

    // In other digits
    EXPECT_EQ
    (
        goOn("centre (0.03 0.1 0); radius 0.01;", "centre (3e-2 0.1 0); radius 1e-2;"),
        all
    );

    // An older version kept nothing of it
    EXPECT_EQ(goOn("", "patch gel;"), all);
}


TEST(keptNumbers, beginAnewWithAnythingElse)
{
    if (Pstream::parRun())
    {
        return;
    }
    EXPECT_TRUE(goOn("patch gel;", "patch outlet;").empty());
    EXPECT_TRUE(goOn("patch gel;", "centre (0 0 0); radius 0.01;").empty());
    EXPECT_TRUE(goOn("centre (0 0 0);", "centre (0 0.001 0);").empty());
    EXPECT_TRUE(goOn("concentration 0.1;", "concentration 0.11;").empty());
}
