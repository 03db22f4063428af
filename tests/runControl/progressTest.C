/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "progress.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- A Time from start to end [s], without files
autoPtr<Time> timeUntil(const scalar start, const scalar end)
{
    dictionary control;
    control.add("startFrom", "startTime");
    control.add("startTime", start);
    control.add("endTime", end);
    control.add("deltaT", 0.01*end);
    control.add("writeInterval", 1);

    autoPtr<Time> runTime
    (
        new Time(control, ".", "progressTest", "system", "constant", false)
    );
    return runTime;
}

} // End anonymous namespace


TEST(progress, showsTimePercentPlateletsAndTimeLeft)
{
    autoPtr<Time> runTime(timeUntil(0, 2e-3));
    const progress log(*runTime);
    runTime->setTime(0.5e-3, 10);

    // A quarter took 100 s
    EXPECT_EQ
    (
        log.line(4096, 100),
        "t = 0.5 ms          25.0 %       4096 platelets  left 0:05:00"
    );
}


TEST(progress, saysWhatIsCounted)
{
    autoPtr<Time> runTime(timeUntil(0, 2e-3));
    const progress log(*runTime, "parcels");
    runTime->setTime(0.5e-3, 10);

    EXPECT_EQ
    (
        log.line(64, 100),
        "t = 0.5 ms          25.0 %         64 parcels  left 0:05:00"
    );
}


TEST(progress, reckonsFromThisRunOnly)
{
    autoPtr<Time> runTime(timeUntil(1, 2));
    const progress log(*runTime);
    runTime->setTime(1.5, 10);

    EXPECT_NE(log.line(-1, 60).find(" 75.0 %"), std::string::npos);
    EXPECT_NE(log.line(-1, 60).find("left 0:01:00"), std::string::npos);
}


TEST(progress, fitsInto80Columns)
{
    for (const scalar end : {1.23456789e-12, 123456.789, 9.87654321e13})
    {
        autoPtr<Time> runTime(timeUntil(0, end));
        const progress log(*runTime);
        runTime->setTime(end*0.123456789, 10);

        EXPECT_LE(log.line(2147483647, 1e9).size(), 80u)
            << log.line(2147483647, 1e9);
    }
}


// A run of a millisecond in steps of a picosecond
TEST(progress, showsEachStep)
{
    autoPtr<Time> runTime(timeUntil(1e-3, 1.0001e-3));
    const progress log(*runTime);
    runTime->setDeltaT(1e-12);
    runTime->setTime(1e-3 + 1e-12, 1);
    const std::string before(log.line(-1, 0));
    runTime->setTime(1e-3 + 2e-12, 2);

    EXPECT_EQ(before.substr(0, 18), "t = 1.000000001 ms");
    EXPECT_NE(before.substr(0, 18), log.line(-1, 0).substr(0, 18));
}


TEST(progress, doesWithoutAnEnd)
{
    autoPtr<Time> runTime(timeUntil(0, 2));
    const progress log(*runTime);
    runTime->stopAt(Time::saNextWrite);
    runTime->setTime(0.5, 10);

    const std::string line(log.line(7, 60));
    EXPECT_EQ(line.find('%'), std::string::npos);
    EXPECT_EQ(line.find("left"), std::string::npos);
}


TEST(progress, choosesUnits)
{
    EXPECT_EQ(withTimeUnit(0), "0 s");
    EXPECT_EQ(withTimeUnit(1.25e-3), "1.25 ms");
    EXPECT_EQ(withTimeUnit(2e-8), "20 ns");
    EXPECT_EQ(withTimeUnit(90), "90 s");
    EXPECT_EQ(withTimeUnit(7200), "2 h");
    EXPECT_EQ(withTimeUnit(10*31557600.), "10 a");
}


TEST(progress, writesWallTimesAsClocksDo)
{
    EXPECT_EQ(asClock(0), "0:00:00");
    EXPECT_EQ(asClock(59.6), "0:01:00");
    EXPECT_EQ(asClock(3725), "1:02:05");
    EXPECT_EQ(asClock(2*86400 + 3600), "2d 1:00:00");
    EXPECT_EQ(asClock(-1), "-");
}
