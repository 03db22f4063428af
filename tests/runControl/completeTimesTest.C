/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The choice of the start, also where ranks have different times.
\*---------------------------------------------------------------------------*/

#include "IStringStream.H"
#include "Pstream.H"
#include "completeTimes.H"
#include "temporaryCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const std::string latest("startFrom latestTime;");


std::string startOf(const temporaryCase& here, const std::string& control)
{
    const completeTimes times(here.path());
    return times.start(dictionary(IStringStream(control)())).name();
}


std::string refusalOf(const temporaryCase& here, const std::string& control)
{
    return messageOf([&]{startOf(here, control);});
}


bool onLastRank()
{
    return Pstream::myProcNo() == Pstream::nProcs() - 1;
}

} // End anonymous namespace


TEST(completeTimes, latestIsByNumberNotByName)
{
    const temporaryCase here;
    for (const char* time : {"0", "9", "10", "1e-05", "0.orig", "constant"})
    {
        here.time(time);
    }

    EXPECT_EQ(startOf(here, latest), "10");
    EXPECT_EQ(startOf(here, ""), "10");
    EXPECT_EQ(startOf(here, "startFrom firstTime;"), "0");
    EXPECT_EQ
    (
        startOf(here, "startFrom startTime; startTime 0.00001;"),
        "1e-05"
    );
}


TEST(completeTimes, skipTimesThatAreMarkedOnAnyRank)
{
    const temporaryCase here;
    for (const char* time : {"0", "1", "2", "3"})
    {
        here.time(time);
    }
    here.file("3/uniform/incomplete", "");
    if (onLastRank())
    {
        here.file("2/uniform/incomplete", "");
    }

    EXPECT_EQ(startOf(here, latest), "1");
    EXPECT_EQ(startOf(here, "startFrom startTime; startTime 3;"), "1");
    EXPECT_EQ(startOf(here, "startFrom startTime; startTime 1;"), "1");
}


TEST(completeTimes, skipTimesThatAreNotOnAllRanks)
{
    if (!Pstream::parRun())
    {
        GTEST_SKIP();
    }

    // Killed when one rank had made its directory, the other had not
    const temporaryCase here;
    here.time("0");
    here.time("1");
    if (onLastRank())
    {
        here.time("2");
    }

    EXPECT_EQ(startOf(here, latest), "1");
}


TEST(completeTimes, refuseWhenNoneIsComplete)
{
    const temporaryCase here;
    here.time("0");
    here.file("0/uniform/incomplete", "");

    const std::string message(refusalOf(here, latest));
    EXPECT_NE(message.find("No complete time"), std::string::npos);
    EXPECT_NE(message.find("uniform/incomplete"), std::string::npos);
}


TEST(completeTimes, refuseAStartTimeThatIsNotThere)
{
    const temporaryCase here;
    here.time("0");
    here.time("0.5");

    const std::string message
    (
        refusalOf(here, "startFrom startTime; startTime 0.49;")
    );
    EXPECT_NE(message.find("0.49"), std::string::npos);
    EXPECT_NE(message.find("the times 0 0.5"), std::string::npos) << message;
}


TEST(completeTimes, startFromNothingAtZero)
{
    const temporaryCase here;

    EXPECT_EQ(startOf(here, latest), "");
    EXPECT_EQ(startOf(here, "startFrom startTime; startTime 0;"), "");
    EXPECT_NE(refusalOf(here, "startFrom startTime; startTime 1;"), "");
}


TEST(completeTimes, refuseUnknownWords)
{
    const temporaryCase here;
    EXPECT_NE
    (
        refusalOf(here, "startFrom lastTime;").find("latestTime"),
        std::string::npos
    );
}
