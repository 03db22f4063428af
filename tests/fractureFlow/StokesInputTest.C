/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowCase.H"

#include <gtest/gtest.h>

using namespace Foam;

static const string noSlip("type noSlip;");
static const string slip("type slip;");
static const string zeroGradient("type zeroGradient;");

static string fixed(const string& value)
{
    return "type fixedValue; value uniform " + value + ";";
}

//- Four by four cells with the given conditions of inlet and outlet
struct smallChannel
:
    flowCase
{
    static boxSpec spec()
    {
        boxSpec result;
        result.cells = {4, 4, 1};
        result.types = {"patch", "patch", "wall", "wall", "empty", "empty"};
        return result;
    }

    smallChannel
    (
        const string& inletU = zeroGradient,
        const string& inletP = fixed("1"),
        const string& outletU = zeroGradient,
        const string& outletP = fixed("0"),
        const string& walls = noSlip
    )
    :
        flowCase(spec())
    {
        writeU
        ({
            {"bottom", walls},
            {"top", walls},
            {"inlet", inletU},
            {"outlet", outletU}
        });
        writeP
        ({
            {"bottom", zeroGradient},
            {"top", zeroGradient},
            {"inlet", inletP},
            {"outlet", outletP}
        });
    }

    string messageOfSolution(const string& properties = "model Stokes;")
    {
        return messageOf([&]() { newFlow(properties)->solve(); });
    }
};


TEST(StokesInput, goodInputIsNotRefused)
{
    EXPECT_EQ(smallChannel().messageOfSolution(), "");
}


TEST(StokesInput, misspeltEntryIsNamedWithTheNearestWord)
{
    EXPECT_TRUE
    (
        mentions
        (
            smallChannel().messageOfSolution
            (
                "model Stokes; StokesCoeffs { presureGradient (1 0 0); }"
            ),
            {"presureGradient", "pressureGradient"}
        )
    );

    smallChannel c;
    c.controls().set("residuals", 1e-3);
    EXPECT_TRUE(mentions(c.messageOfSolution(), {"residuals", "'residual'"}));
}


TEST(StokesInput, impossibleControlsAreRefused)
{
    for (const word name : {"residual", "maxIterations", "directions"})
    {
        smallChannel c;
        c.controls().set(name, -1);
        EXPECT_TRUE(mentions(c.messageOfSolution(), {name}));
    }

    smallChannel c;
    c.controls().set("notConverged", word("warn"));
    EXPECT_TRUE(mentions(c.messageOfSolution(), {"warn", "warning", "error"}));
}


TEST(StokesInput, missedResidualIsAnErrorOrAWarningAsAsked)
{
    smallChannel c;
    c.controls().set("maxIterations", 1);
    EXPECT_TRUE
    (
        mentions(c.messageOfSolution(), {"1 iterations", "notConverged"})
    );

    c.controls().set("notConverged", word("warning"));
    EXPECT_EQ(c.messageOfSolution(), "");
}


TEST(StokesInput, pressureInPascalIsRefused)
{
    smallChannel c;
    c.writeField
    (
        "p", "volScalarField", "[1 -1 -2 0 0 0 0]", "uniform 0",
        {
            {"bottom", zeroGradient},
            {"top", zeroGradient},
            {"inlet", fixed("1")},
            {"outlet", fixed("0")}
        }
    );
    EXPECT_TRUE(mentions(c.messageOfSolution(), {"kinematic", "[0 2 -2"}));
}


TEST(StokesInput, pressureAndVelocityGivenOnOnePatchAreRefused)
{
    smallChannel c(fixed("(1 0 0)"), fixed("1"));
    EXPECT_TRUE
    (
        mentions(c.messageOfSolution(), {"inlet", "both U", "zeroGradient"})
    );
}


TEST(StokesInput, inflowWithoutOutflowIsRefused)
{
    smallChannel c
    (
        fixed("(1 0 0)"), zeroGradient, fixed("(0.5 0 0)"), zeroGradient
    );
    EXPECT_TRUE(mentions(c.messageOfSolution(), {"given on all patches"}));
}


TEST(StokesInput, waterThatNothingHoldsIsRefused)
{
    smallChannel c
    (
        zeroGradient, fixed("1"), zeroGradient, fixed("0"), slip
    );
    EXPECT_TRUE(mentions(c.messageOfSolution(), {"Nothing holds the water"}));
}
