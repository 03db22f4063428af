/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Pstream.H"
#include "temporaryCase.H"
#include "writtenTimes.H"

#include <gtest/gtest.h>

using namespace Foam;

TEST(writtenTimes, areNamedAndRemovedInTheCaseAndItsProcessors)
{
    if (Pstream::parRun())
    {
        GTEST_SKIP();
    }
    const temporaryCase here;
    const char* file = "uniform/restartableTime";
    here.file("0/alpha.clay", "");
    here.file("0.45/mag(U)", "");
    here.file("10/" + std::string(file), "");
    here.file("9/uniform/incomplete", "");
    here.file("processor0/0/alpha.clay", "");
    here.file("processor0/9/" + std::string(file), "");
    here.file("processors/9/" + std::string(file), "");

    const std::string message
    (
        messageOf([&]{writtenTimes(here.path()).refuse();})
    );
    EXPECT_NE
    (
        message.find("rm -r processor0/9 9 10"), std::string::npos
    )   << message;
    EXPECT_NE(message.find("setClay -overwrite"), std::string::npos);

    writtenTimes(here.path()).remove();
    EXPECT_EQ(messageOf([&]{writtenTimes(here.path()).refuse();}), "");

    for (const char* gone : {"9", "10", "processor0/9"})
    {
        EXPECT_FALSE(here.has(gone)) << gone;
    }
    for (const char* kept : {"0/alpha.clay", "0.45/mag(U)", "processor0/0"})
    {
        EXPECT_TRUE(here.has(kept)) << kept;
    }
}


TEST(writtenTimes, areKeptWhereTheyAreAllThatTheCaseHas)
{
    if (Pstream::parRun())
    {
        GTEST_SKIP();
    }
    const temporaryCase here;
    here.file("10/uniform/restartableTime", "");

    EXPECT_NE(messageOf([&]{writtenTimes(here.path()).checkRemovable();}), "");
    EXPECT_TRUE(here.has("10/uniform/restartableTime"));
}
