/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "filterProperties.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

filterProperties read(const char* text)
{
    return filterProperties(dictionary(IStringStream(text)()));
}


std::string refusal(const char* text)
{
    try
    {
        read(text);
    }
    catch (const Foam::error& err)
    {
        return err.message();
    }
    return "";
}

} // End anonymous namespace


TEST(filterProperties, haveDefaults)
{
    const filterProperties filter(read(""));

    EXPECT_EQ(filter.kernel, "cubic");
    EXPECT_TRUE(filter.lengthIsAuto);
    EXPECT_EQ(filter.timeScale, 0);
}


TEST(filterProperties, readWhatIsGiven)
{
    const filterProperties filter
    (
        read("kernel cubic; length 1.5e-6; timeScale 2e-4;")
    );

    EXPECT_FALSE(filter.lengthIsAuto);
    EXPECT_EQ(filter.length, 1.5e-6);
    EXPECT_EQ(filter.timeScale, 2e-4);

    EXPECT_TRUE(read("length auto;").lengthIsAuto);
}


TEST(filterProperties, refuseUnknownWords)
{
    EXPECT_NE(refusal("lenght 1e-6;").find("length"), std::string::npos);
    EXPECT_NE(refusal("kernel cubik;").find("cubic"), std::string::npos);
    EXPECT_NE(refusal("length atuo;").find("auto"), std::string::npos);
}


TEST(filterProperties, refuseImpossibleNumbers)
{
    EXPECT_NE(refusal("length 0;"), "");
    EXPECT_NE(refusal("length -1e-6;"), "");
    EXPECT_NE(refusal("timeScale -1;"), "");
}
