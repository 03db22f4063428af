/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coVolumeViscosity.H"
#include "referenceTable.H"

#include "IStringStream.H"
#include "error.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::colloid;

namespace
{

const char* const defaults =
    "model LiuCoVolume; coreThickness 1; gelCoVolume 1.6; gelStop on;"
    "gelViscosity 1e6;";

const char* const noStop =
    "model LiuCoVolume; coreThickness 1; gelCoVolume 1.6; gelStop off;"
    "gelViscosity 1e6;";

const char* const notFlocculated = "active off; fraction 0.005;";
const char* const flocculated = "active on; fraction 0.005;";

dictionary parse(const char* text)
{
    IStringStream stream(text);
    return dictionary(stream);
}

coVolumeViscosity viscosityOf
(
    const scalar concentration,
    const char* viscosity = defaults,
    const char* flocculation = notFlocculated
)
{
    water solution;
    solution.concentration = concentration;

    return coVolumeViscosity
    (
        parse(viscosity), parse(flocculation), platelet(), solution
    );
}

} // End anonymous namespace


TEST(coVolumeViscosity, agreesWithTheReference)
{
    for (const char* table : {"colloid.csv", "suspension.csv"})
    {
        for (const referenceRow& row : referenceTable(table))
        {
            const coVolumeViscosity law = viscosityOf(row.at("c"));
            const scalar phi = row.at("phi");

            EXPECT_LT
            (
                relativeError(law.coVolumeFraction(phi), row.at("phi_cov")),
                1e-10
            );
            EXPECT_LT
            (
                relativeError(law.uncappedViscosity(phi), row.at("eta_r")),
                1e-10
            );
        }
    }
}


// Round-off of one root instead of another
TEST(coVolumeViscosity, atAnotherConcentrationIsThatOfOtherWater)
{
    for (const char* floc : {notFlocculated, flocculated})
    {
        const coVolumeViscosity law = viscosityOf(0.1, defaults, floc);

        for (const scalar concentration : {1e-3, 0.1, 30.})
        {
            const coVolumeViscosity expected =
                viscosityOf(concentration, defaults, floc);
            const coVolumeViscosity there = law.at(concentration);

            for (const scalar phi : {0., 1e-4, 0.003, 0.011, 0.1})
            {
                const scalar eta = expected.relativeViscosity(phi);
                EXPECT_NEAR(there.relativeViscosity(phi), eta, 1e-12*eta);
            }
            EXPECT_NEAR
            (
                there.gelFraction(), expected.gelFraction(), 1e-14
            );
        }
    }
}


// Published (39.2) and computed independently, with the digits they have
TEST(coVolumeViscosity, reproducesPublishedNumbers)
{
    EXPECT_NEAR(viscosityOf(0.1).uncappedViscosity(0.01), 39.2, 0.05);

    EXPECT_NEAR(viscosityOf(0.01).gelFraction(), 0.00159, 5e-6);
    EXPECT_NEAR(viscosityOf(0.1).gelFraction(), 0.0054093, 5e-8);
    EXPECT_NEAR(viscosityOf(1).gelFraction(), 0.00911, 5e-6);
    EXPECT_NEAR(viscosityOf(10).gelFraction(), 0.01097, 5e-6);
    EXPECT_NEAR(viscosityOf(100).gelFraction(), 0.01166, 5e-6);
}


TEST(coVolumeViscosity, ofLiquidIsThatOfTheLaw)
{
    const coVolumeViscosity law = viscosityOf(0.1);

    EXPECT_EQ(law.relativeViscosity(0), 1);
    EXPECT_EQ(law.relativeViscosity(0.003), law.uncappedViscosity(0.003));
    EXPECT_EQ
    (
        law.relativeViscosity(0.9999*law.gelFraction()),
        law.uncappedViscosity(0.9999*law.gelFraction())
    );
}


TEST(coVolumeViscosity, gelStopsWithin5PercentSmoothlyAndMonotonically)
{
    const coVolumeViscosity law = viscosityOf(0.1);
    const scalar gel = law.gelFraction();

    EXPECT_EQ(law.relativeViscosity(1.051*gel), 1e6);
    EXPECT_EQ(law.relativeViscosity(0.57), 1e6);

    scalar previous = 0;
    for (scalar phi = 0.9*gel; phi < 1.1*gel; phi += 1e-4*gel)
    {
        ASSERT_GE(law.relativeViscosity(phi), previous);
        previous = law.relativeViscosity(phi);
    }

    // Slopes on both sides of either end agree to the second derivative's
    // share, of the logarithm: 6 ln(1e6/8)/0.05^2 = 3e4 times the step
    for (const scalar end : {gel, 1.05*gel})
    {
        const scalar d = 1e-6*gel;
        const scalar left =
            std::log(law.relativeViscosity(end - d))
          - std::log(law.relativeViscosity(end - 2*d));
        const scalar right =
            std::log(law.relativeViscosity(end + 2*d))
          - std::log(law.relativeViscosity(end + d));

        EXPECT_NEAR(left, right, 6*3e4*1e-12) << end;
    }
}


TEST(coVolumeViscosity, withoutGelStopTheLawGoesOn)
{
    const coVolumeViscosity law = viscosityOf(0.1, noStop);

    EXPECT_FALSE(law.gels());
    EXPECT_EQ(law.relativeViscosity(0.1), law.uncappedViscosity(0.1));
}


TEST(coVolumeViscosity, flocsAreCarriedAsByWaterOrDoNotFlow)
{
    for (const char* viscosity : {defaults, noStop})
    {
        const coVolumeViscosity law = viscosityOf(0.1, viscosity, flocculated);

        EXPECT_TRUE(law.gels());
        EXPECT_EQ(law.gelFraction(), 0.005);
        EXPECT_EQ(law.relativeViscosity(0.0049), 1);
        EXPECT_EQ(law.relativeViscosity(0.0053), 1e6);
        EXPECT_GT(law.uncappedViscosity(0.0049), 5);
    }
}


TEST(coVolumeViscosity, refusesWhatIsImpossible)
{
    const auto refused = [](const char* viscosity, const char* flocculation)
    {
        EXPECT_THROW
        (
            viscosityOf(0.1, viscosity, flocculation), Foam::error
        ) << viscosity << flocculation;
    };

    refused
    (
        "model Einstein; coreThickness 1; gelCoVolume 1.6; gelStop on;"
        "gelViscosity 1e6;", notFlocculated
    );
    refused
    (
        "model LiuCoVolume; coreThickness -1; gelCoVolume 1.6; gelStop on;"
        "gelViscosity 1e6;", notFlocculated
    );
    // Less than the liquid's at the gel
    refused
    (
        "model LiuCoVolume; coreThickness 1; gelCoVolume 1.6; gelStop on;"
        "gelViscosity 5;", notFlocculated
    );
    refused(defaults, "active on; fraction 1.1;");
    refused(defaults, "activ on; fraction 0.005;");
}


// ************************************************************************* //
