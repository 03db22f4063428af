/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "IStringStream.H"
#include "OStringStream.H"
#include "exactTimeState.H"
#include "temporaryCase.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

std::string asText(const exactTimeState& state)
{
    dictionary dict;
    state.write(dict);
    OStringStream os;
    dict.write(os, false);
    return os.str();
}


exactTimeState fromText(const std::string& text)
{
    return exactTimeState::read(dictionary(IStringStream(text)()));
}

} // End anonymous namespace


TEST(exactTimeState, keepsEveryBit)
{
    // No short decimal numbers, and one that is denormal
    exactTimeState state;
    state.name = "3.33333e-05";
    state.value = 1e-4/3;
    state.deltaT = 0.1 + 0.2;
    state.deltaT0 = 4.9e-324;
    state.scheduleStart = -1./7;
    state.writeTimeIndex = 123456789;
    state.writeControl = "adjustableRunTime";
    state.writeInterval = 2./3;
    state.files = {"alpha.clay", "mag(U)", "lagrangian/clay/x"};

    const exactTimeState again(fromText(asText(state)));

    EXPECT_EQ(again.name, state.name);
    EXPECT_EQ(again.value, state.value);
    EXPECT_EQ(again.deltaT, state.deltaT);
    EXPECT_EQ(again.deltaT0, state.deltaT0);
    EXPECT_EQ(again.scheduleStart, state.scheduleStart);
    EXPECT_EQ(again.writeTimeIndex, state.writeTimeIndex);
    EXPECT_EQ(again.writeControl, state.writeControl);
    EXPECT_EQ(again.writeInterval, state.writeInterval);
    EXPECT_EQ(again.files, state.files);
}


TEST(exactTimeState, refusesDamagedNumbers)
{
    exactTimeState state;
    state.name = "1";
    state.value = 1;
    state.writeControl = "timeStep";
    const std::string text(asText(state));

    for (const char* damaged : {"0x1.8p", "nan", "inf", "", "1 2", "abc"})
    {
        std::string other(text);
        const auto at = other.find("0x1p+0");
        ASSERT_NE(at, std::string::npos);
        other.replace(at, 6, damaged);

        EXPECT_NE
        (
            messageOf([&]{fromText(other);}).find("damaged"),
            std::string::npos
        )   << damaged;
    }
}


TEST(exactTimeState, refusesMissingEntries)
{
    EXPECT_NE
    (
        messageOf([]{fromText("name \"1\"; value \"0x1p+0\";");})
            .find("deltaT"),
        std::string::npos
    );
}
