/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "IStringStream.H"
#include "checkControls.H"
#include "temporaryCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

std::string refusalOf(const std::string& entries)
{
    return messageOf
    (
        [&]
        {
            checkControls(dictionary(IStringStream(entries)()));
        }
    );
}


std::string ofFunction(const std::string& entries)
{
    return refusalOf("functions { one { type one; " + entries + " } }");
}

} // End anonymous namespace


TEST(checkControls, refuseImpossibleNumbers)
{
    for
    (
        const char* entry
      : {
            "deltaT 0;", "deltaT -1;", "maxDeltaT 0;", "maxCo 0;", "maxCo -1;",
            "maxDisplacement 0;", "endTime nan;", "startTime nan;",
            "writeInterval 0;", "writeInterval -1;", "writeInterval 2.5;",
            "writeFrequency 0;", "writeControl runTime; writeInterval 0;",
            "writeControl adjustable; writeInterval -1e-3;",
            "purgeWrite -1;", "purgeWrite 0.5;", "timePrecision 0;",
            "timePrecision -6;", "writePrecision 0;", "writePrecision 1000;"
        }
    )
    {
        EXPECT_NE(refusalOf(entry), "") << entry;
    }

    const std::string message(refusalOf("\n\ndeltaT -1;"));
    EXPECT_NE(message.find("Impossible deltaT -1"), std::string::npos);
    EXPECT_NE(message.find("more than 0 s"), std::string::npos);
}


TEST(checkControls, refuseImpossibleIntervalsOfFunctionObjects)
{
    for
    (
        const char* entries
      : {
            "writeInterval -1;", "executeInterval 1.5;", "timeStart nan;",
            "writeControl runTime; writeInterval 0;",
            "executeControl adjustable; executeInterval -1;"
        }
    )
    {
        EXPECT_NE(ofFunction(entries), "") << entries;
    }
}


TEST(checkControls, takeWhatRunsCanGoWith)
{
    for
    (
        const char* entries
      : {
            "", "deltaT 1e-100; endTime -1; startTime -2;",
            "writeControl runTime; writeInterval 0.25; purgeWrite 0;",
            "writeControl timeStep; writeInterval 1e3; maxDeltaT 1e300;",
            "writeControl none; timePrecision 12; writePrecision 17;"
        }
    )
    {
        EXPECT_EQ(refusalOf(entries), "") << entries;
    }
    EXPECT_EQ(ofFunction("writeInterval 0; writeControl writeTime;"), "");
    EXPECT_EQ(ofFunction("writeControl onEnd; writeInterval none;"), "");
}
