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


namespace
{

//- Start of a run that may begin with alpha.clay
std::string runOf(const temporaryCase& here, const std::string& control)
{
    const completeTimes times(here.path(), "alpha.clay");
    return times.start(dictionary(IStringStream(control)())).name();
}


std::string refusalOfRun(const temporaryCase& here, const std::string& control)
{
    return messageOf([&]{runOf(here, control);});
}


//- A time that a run has written, with these files
void written
(
    const temporaryCase& here,
    const std::string& time,
    const std::string& files
)
{
    here.file
    (
        time + "/uniform/restartableTime",
        "files (" + files + ");\n"
    );
    here.file(time + "/alpha.clay", "");
}

} // End anonymous namespace


TEST(completeTimes, skipWhatFunctionObjectsHaveWritten)
{
    const temporaryCase here;
    here.file("0/alpha.clay", "");
    here.file("20/mag(U)", "");

    // Nothing but those of the run's begin, and with times of the run
    EXPECT_EQ(runOf(here, latest), "0");
    written(here, "10", "\"alpha.clay\"");
    EXPECT_EQ(runOf(here, latest), "10");

    // Fields of the run alone don't make a time of it: salt, fluxes, the state
    // of the platelets are missing
    here.file("30/alpha.clay", "");
    EXPECT_EQ(runOf(here, latest), "10");
    EXPECT_EQ(runOf(here, "startFrom firstTime;"), "0");

    const std::string message
    (
        refusalOfRun(here, "startFrom startTime; startTime 20;")
    );
    EXPECT_NE(message.find("not a time of the run"), std::string::npos);
    EXPECT_NE(message.find("start from 0 10"), std::string::npos) << message;
}


TEST(completeTimes, beginWithWhatTheUserHasPlaced)
{
    const temporaryCase here;

    // Of another solver; by mapFields to a time that isn't the first
    here.file("0/U", "");
    EXPECT_EQ(runOf(here, latest), "0");
    here.file("5/alpha.clay.gz", "");
    here.file("7/alpha.clay", "");

    EXPECT_EQ(runOf(here, latest), "5");
    EXPECT_EQ(runOf(here, "startFrom firstTime;"), "5");
    EXPECT_EQ(runOf(here, "startFrom startTime; startTime 7;"), "7");
}


TEST(completeTimes, leaveItToTheProgramWhereNothingIsPlaced)
{
    const temporaryCase here;
    here.file("0/U", "");
    here.file("1/U", "");

    EXPECT_EQ(runOf(here, latest), "1");
    EXPECT_EQ(runOf(here, "startFrom startTime; startTime 0;"), "0");
}


TEST(completeTimes, areOfTheRunOnAllRanksOrNotAtAll)
{
    const temporaryCase here;
    here.file("0/alpha.clay", "");
    here.time("1");
    if (onLastRank())
    {
        written(here, "1", "");
    }
    EXPECT_EQ(runOf(here, latest), Pstream::parRun() ? "0" : "1");
}


TEST(completeTimes, refuseATimeThatLacksAFile)
{
    const temporaryCase here;
    written(here, "1", "\"alpha.clay\"");
    written(here, "2", "\"alpha.clay\" \"phi.gz\"");

    // Also where it has been unpacked
    here.file("2/phi", "");
    EXPECT_EQ(runOf(here, latest), "2");

    if (onLastRank())
    {
        std::remove((here.path()/"2"/"phi").c_str());
    }
    const std::string message(refusalOfRun(here, latest));
    EXPECT_NE(message.find("2/phi"), std::string::npos) << message;
    EXPECT_NE(message.find("not whole"), std::string::npos);
    EXPECT_NE(message.find("startTime 1;)"), std::string::npos) << message;
    EXPECT_NE(message.find("reconstructPar -time 2"), std::string::npos);
}


TEST(completeTimes, knowThatRanksMayHaveNoPlatelets)
{
    const temporaryCase here;
    written
    (
        here,
        "1",
        "\"lagrangian/clay/x\" \"lagrangian/clay/origProcId\""
        " \"lagrangian/clay/positions\""
    );
    EXPECT_NE(refusalOfRun(here, latest).find("clay/"), std::string::npos);

    if (Pstream::master())
    {
        here.file("1/lagrangian/clay/x", "");
        here.file("1/lagrangian/clay/origProcId", "");
    }
    EXPECT_EQ(runOf(here, latest), "1");

    if (Pstream::master())
    {
        std::remove
        (
            (here.path()/"1"/"lagrangian"/"clay"/"origProcId").c_str()
        );
    }
    EXPECT_NE(refusalOfRun(here, latest).find("origProcId"), std::string::npos);
}
