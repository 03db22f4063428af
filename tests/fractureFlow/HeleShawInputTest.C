/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fracturePlane.H"

#include <gtest/gtest.h>

using namespace Foam;

static string messageOfSolution
(
    fracturePlane& c,
    const string& coeffs = "aperture 1e-3;"
)
{
    return messageOf([&]() { c.HeleShaw(coeffs)->solve(); });
}


TEST(HeleShawInput, goodInputIsNotRefused)
{
    fracturePlane c;
    EXPECT_EQ(messageOfSolution(c), "");
}


TEST(HeleShawInput, aperturesThatCannotBeAreRefused)
{
    fracturePlane c;
    c.writePlaneField
    (
        "b", "[0 1 0 0 0 0 0]",
        [](const vector& x) { return x.x() < 1 ? 0 : 1e-3; }, "0"
    );
    c.writePlaneField
    (
        "T", "[0 2 -1 0 0 0 0]", [](const vector&) { return 1e-5; }, "0"
    );

    const std::map<string, std::vector<string>> messages
    {
        {"", {"Neither aperture", "nor transmissivity"}},
        {"aperture 1; transmissivity 1;", {"Both aperture"}},
        {"apertur 1;", {"aperture"}},
        {"aperture 1e-3; nu 1;", {"nu", "transmissivity"}},
        {"aperture 0;", {"Impossible aperture 0", "1e-09"}},
        {"aperture -1e-3;", {"Impossible aperture"}},
        {"aperture 1 kg;", {"aperture", "kg", "mm"}},
        {"aperture missing;", {"missing", "neither in", "decomposePar"}},
        {"aperture T;", {"T", "[0 2 -1 0 0 0 0]", "[0 1 0 0 0 0 0]"}},
        {"aperture b;", {"Impossible aperture", "field b", "from 0"}},
        {"aperture 0.11;", {"Impossible aperture 0.11", "to 0.1"}},
        // g b^3/(12 nu) of 0.1 m
        {"transmissivity 818;", {"Impossible transmissivity 818", "to 817.22"}},
        {"transmissivity b;", {"[0 1 0 0 0 0 0]", "[0 2 -1 0 0 0 0]"}}
    };

    for (const auto& [coeffs, parts] : messages)
    {
        EXPECT_TRUE(mentions(messageOfSolution(c, coeffs), parts)) << coeffs;
    }
}


TEST(HeleShawInput, meshesThatAreNoPlaneAreRefused)
{
    boxSpec spec = fracturePlane::spec();
    spec.types[4] = spec.types[5] = "symmetryPlane";
    {
        fracturePlane c(spec);
        EXPECT_TRUE
        (
            mentions
            (
                messageOfSolution(c),
                {"across the fracture", "3 directions", "type empty", "Stokes"}
            )
        );
    }

    spec = fracturePlane::spec();
    spec.cells[2] = 2;
    {
        fracturePlane c(spec);
        EXPECT_TRUE(mentions(messageOfSolution(c), {"one cell thick"}));
    }
}


TEST(HeleShawInput, boundariesThatSayTooMuchOrTooLittleAreRefused)
{
    const string zeroGradient("type zeroGradient;");
    const string velocity("type fixedValue; value uniform (1 0 0);");
    const string pressure("type fixedValue; value uniform 1;");

    fracturePlane c;

    c.writeInlet(velocity, pressure);
    EXPECT_TRUE(mentions(messageOfSolution(c), {"inlet", "both U and p"}));

    c.writeInlet(velocity, "type fixedGradient; gradient uniform 1;");
    EXPECT_TRUE(mentions(messageOfSolution(c), {"inlet", "both U and p"}));

    c.writeInlet(zeroGradient, zeroGradient);
    EXPECT_TRUE(mentions(messageOfSolution(c), {"inlet", "neither U nor p"}));

    c.writeInlet(zeroGradient, pressure, zeroGradient);
    EXPECT_TRUE(mentions(messageOfSolution(c), {"bottom", "neither U nor p"}));

    c.writeInlet
    (
        zeroGradient,
        "type mixed; refValue uniform 1; refGradient uniform 0;"
        "valueFraction uniform 1; value uniform 1;"
    );
    EXPECT_TRUE(mentions(messageOfSolution(c), {"inlet", "mixed", "slip"}));

    c.writeInlet("type inletOutlet; inletValue uniform (0 0 0);", pressure);
    EXPECT_EQ(messageOfSolution(c), "");
}


TEST(HeleShawInput, inflowWithoutOutflowIsRefused)
{
    fracturePlane c;
    c.writeU
    ({
        {"bottom", "type slip;"},
        {"top", "type slip;"},
        {"inlet", "type fixedValue; value uniform (1 0 0);"},
        {"outlet", "type fixedValue; value uniform (0.5 0 0);"}
    });
    c.writeP
    ({
        {"bottom", "type zeroGradient;"},
        {"top", "type zeroGradient;"},
        {"inlet", "type zeroGradient;"},
        {"outlet", "type zeroGradient;"}
    });
    EXPECT_TRUE(mentions(messageOfSolution(c), {"given on all patches"}));
}


TEST(HeleShawInput, controlsAreChecked)
{
    fracturePlane c;
    c.controls("HeleShaw").set("residuals", 1e-3);
    EXPECT_TRUE(mentions(messageOfSolution(c), {"residuals", "'residual'"}));
    c.controls("HeleShaw").remove("residuals");

    c.controls("HeleShaw").set("residual", -1);
    EXPECT_TRUE(mentions(messageOfSolution(c), {"residual"}));
    c.controls("HeleShaw").remove("residual");

    c.setViscosity([](const vector& x) { return x.x() < x.y() ? 1e4 : 1; });
    c.controls("solvers").set
    (
        "p",
        dictionaryOf
        (
            "solver PCG; preconditioner DIC; tolerance 0; relTol 0.5;"
        )
    );
    c.controls("HeleShaw").set("maxIterations", 2);
    EXPECT_TRUE
    (
        mentions(messageOfSolution(c), {"2 linear solutions", "notConverged"})
    );

    c.controls("HeleShaw").set("notConverged", word("warning"));
    EXPECT_EQ(messageOfSolution(c), "");

    // A loose linear solver only needs more solutions
    c.controls("HeleShaw").set("maxIterations", 1000);
    c.controls("HeleShaw").set("notConverged", word("error"));
    EXPECT_EQ(messageOfSolution(c), "");
}
