/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompleteMarker.H"
#include "temporaryCase.H"

#include <gtest/gtest.h>

using namespace Foam;


TEST(incompleteMarker, isSetAndRemoved)
{
    const temporaryCase here;
    const fileName time(here.path()/"0.5");

    EXPECT_FALSE(incompleteMarker::found(time));
    EXPECT_TRUE(incompleteMarker::set(time));
    EXPECT_TRUE(incompleteMarker::found(time));
    EXPECT_TRUE(here.has("0.5/uniform/incomplete"));
    EXPECT_TRUE(incompleteMarker::remove(time));
    EXPECT_FALSE(incompleteMarker::found(time));
    EXPECT_TRUE(here.has("0.5"));
}


TEST(incompleteMarker, clearsWhatAnInterruptedRunLeft)
{
    const temporaryCase here;
    here.file("0.5/U", "half");
    here.file("0.5/lagrangian/clay/x", "half");
    here.file("0.5/uniform/time", "half");
    here.file("0.5/uniform/incomplete", "");

    EXPECT_TRUE(incompleteMarker::set(here.path()/"0.5"));

    EXPECT_TRUE(here.has("0.5/uniform/incomplete"));
    EXPECT_FALSE(here.has("0.5/U"));
    EXPECT_FALSE(here.has("0.5/lagrangian"));
    EXPECT_FALSE(here.has("0.5/uniform/time"));
}


TEST(incompleteMarker, keepsWhatWasComplete)
{
    // A time that is written again: what others have put there stays
    const temporaryCase here;
    here.file("0.5/U", "whole");

    EXPECT_TRUE(incompleteMarker::set(here.path()/"0.5"));

    EXPECT_EQ(here.read("0.5/U"), "whole");
}


TEST(incompleteMarker, takesTheLeftoversOfAKill)
{
    // Killed between making the directory aside and moving it into place
    const temporaryCase here;
    here.file(".0.5.new/uniform/incomplete", "");

    EXPECT_TRUE(incompleteMarker::set(here.path()/"0.5"));

    EXPECT_TRUE(here.has("0.5/uniform/incomplete"));
    EXPECT_FALSE(here.has(".0.5.new"));
}


TEST(incompleteMarker, removesWholeTimes)
{
    const temporaryCase here;
    here.file("0.5/U", "whole");
    here.file("0.5/lagrangian/clay/x", "whole");
    here.file("0.5/uniform/time", "whole");
    here.file("1/U", "without uniform");

    EXPECT_TRUE(incompleteMarker::removeTime(here.path()/"0.5"));
    EXPECT_TRUE(incompleteMarker::removeTime(here.path()/"1"));

    EXPECT_FALSE(here.has("0.5"));
    EXPECT_FALSE(here.has("1"));
}


TEST(incompleteMarker, tellsWhereItCantBeSet)
{
    const temporaryCase here;
    here.file("0.5", "a file where the directory should be");

    EXPECT_FALSE(incompleteMarker::set(here.path()/"0.5"));
}
