/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldEntries.H"
#include "LiusClay.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::fieldEntries;


// Of 1600 kg in a m3, three quarters are montmorillonite of 2750 kg/m3
TEST(fieldEntries, fractionFromDryDensity)
{
    EXPECT_NEAR
    (
        solidFraction
        (
            parse
            (
                "dryDensity 1.6 g/cm3; grainDensity 2750;"
                " montmorillonite 0.75;"
            )
        ),
        0.43636363636, 1e-10
    );
    EXPECT_EQ(solidFraction(parse("fraction 0.4;")), 0.4);
}


TEST(fieldEntries, fractionIsGivenInOneWay)
{
    const auto refusal = [](const std::string& text)
    {
        return messageOf([&] { solidFraction(parse(text)); });
    };

    for
    (
        const auto& [text, part] :
        std::map<std::string, std::string>
        {
            {"", "Neither fraction nor dryDensity"},
            {"fraction 0.1; dryDensity 1600;", "Both fraction and dryDensity"},
            {"fraction 0.1; montmorillonite 1;", "belongs to a dryDensity"},
            {"dryDensity 1600; grainDensity 2750;", "'montmorillonite'"},
            {"dryDensity 1600; montmorillonite 1;", "'grainDensity'"},
            {
                "dryDensity 1600; montmorillonite 1; grainDensity 1600;",
                "make a solid fraction of 1"
            },
            {"fraction 1.1;", "Impossible fraction 1.1"}
        }
    )
    {
        EXPECT_NE(refusal(text).find(part), std::string::npos)
            << refusal(text);
    }
}


// 1e-7 m2/s in water of 1e-6 m2/s: b^3 = 12e-13/9.80665 m3
TEST(fieldEntries, apertureFromTransmissivity)
{
    const colloid::water water;

    EXPECT_NEAR
    (
        aperture(parse("transmissivity 1e-7 m2/s;"), water), 4.96463e-5, 1e-10
    );
    EXPECT_EQ(aperture(parse("aperture 0.1 mm;"), water), 1e-4);

    for (const char* text : {"", "aperture 1e-4; transmissivity 1e-7;"})
    {
        EXPECT_NE
        (
            messageOf([&] { aperture(parse(text), water); })
               .find("transmissivity"),
            std::string::npos
        );
    }
}


// ************************************************************************* //
