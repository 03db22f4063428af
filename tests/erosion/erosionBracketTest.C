/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "erosionBracket.H"
#include "LiusClay.H"

#include "StringStream.H"

#include "Pstream.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

namespace
{

const scalar density = 2700;

erosionBracket::matter matterOf(const LiusClay& clay)
{
    return erosionBracket::matter::of
    (
        [D = clay.D](const scalar phi) { return D.value(phi); },
        clay.D.value(0),
        clay.viscosity
    );
}


// kg/s of mg/h
constexpr scalar mgPerHour = 1e-6/3600;

} // End anonymous namespace


// Computed independently: r_R = 2 cm, 1e-5 m/s, 1 mm, phi_R = 0.01, with the
// digits that are known of it
TEST(erosionBracket, hasThePublishedRates)
{
    const LiusClay clay
    (
        "water { concentration 0.1; } viscosity { gelStop off; }"
    );
    const erosionBracket bracket(matterOf(clay), 0.01);
    const auto hole = erosionBracket::edge::around(0.02, 1e-3, 1e-5);

    const auto rate = [&](const erosionBracket::theory& t)
    {
        return t.rate(hole, density)/mgPerHour;
    };

    EXPECT_NEAR(rate(bracket.penetration()), 4.59, 0.005);
    EXPECT_NEAR(rate(bracket.printed()), 1.87, 0.005);
    EXPECT_NEAR(rate(bracket.conservative()), 0.81, 0.005);
}


// Where D is constant and the viscosity that of water, all are formula 2-2,
// and the rim reaches to erfc(z) = 0.01, z = 1.8214
TEST(erosionBracket, isOneFormulaForFlocsOfConstantD)
{
    const scalar D = 2e-10;
    const rimSimilarity::laws laws
    {
        [=](const scalar) { return D; }, [](const scalar) { return 1; }, D/7
    };
    const erosionBracket bracket({laws, laws}, 0.02);
    const auto edge = erosionBracket::edge::straight(0.3, 1e-4, 1e-6);

    for
    (
        const auto* t :
        {&bracket.printed(), &bracket.conservative(), &bracket.flocculated()}
    )
    {
        EXPECT_NEAR
        (
            t->rate(edge, density)/bracket.penetration().rate(edge, density),
            1, 2e-4
        );
        EXPECT_NEAR
        (
            t->rimThickness(edge)/(1.8214*2*std::sqrt(D*0.3/1e-6)), 1, 1e-3
        );
    }
}


// One side of length pi r_R is half of a hole
TEST(erosionBracket, holeHasTwoSides)
{
    const erosionBracket bracket(matterOf(LiusClay()), 0.01);
    const scalar pi = std::acos(-1.0);
    const auto hole = erosionBracket::edge::around(0.5, 1e-3, 1e-5);
    const auto side = erosionBracket::edge::straight(0.5*pi, 1e-3, 1e-5);
    const auto& rim = bracket.conservative();

    EXPECT_NEAR(rim.rate(hole, density)/rim.rate(side, density), 2, 1e-12);
    EXPECT_NEAR(hole.area(), pi*1e-3, 1e-15);
    EXPECT_EQ(rim.rimThickness(hole), rim.rimThickness(side));
}


// Flocs flow as water up to their fraction, 0.005, whatever is behind them:
// that of rim (C) with eta_r = 1 and the edge at 0.005. More is lost, since
// viscous clay is carried off more slowly
TEST(erosionBracket, flocsFlowAsWaterUpToTheirFraction)
{
    const LiusClay clay;
    const auto matter = matterOf(clay);
    const erosionBracket bracket(matter, 0.01);

    rimSimilarity::laws laws(matter.clay);
    laws.viscosity = [](const scalar) { return 1; };
    const rimSimilarity rim(rimSimilarity::form::conservative, laws, 0.005);

    EXPECT_NEAR
    (
        bracket.flocculated().coefficient
       /(rim.edgeLoss()*std::sqrt(clay.D.value(0))),
        1, 1e-12
    );
    EXPECT_GT
    (
        bracket.flocculated().coefficient, bracket.conservative().coefficient
    );
}


// A rim of 9.2 mm in an aperture of 1 mm is thick enough, one of 10 cm/s is not
TEST(erosionBracket, warnsOfARimThinnerThanTheAperture)
{
    const LiusClay clay;
    const erosionBracket bracket(matterOf(clay), 0.005);

    const auto warnings = [&](const scalar velocity)
    {
        OStringStream os;
        testing::internal::CaptureStderr();
        testing::internal::CaptureStdout();
        bracket.write
        (
            os, erosionBracket::edge::around(0.02, 1e-3, velocity), density
        );
        return
            testing::internal::GetCapturedStderr()
          + testing::internal::GetCapturedStdout();
    };

    EXPECT_EQ(warnings(1e-5), "");
    // The first rank speaks
    EXPECT_EQ
    (
        warnings(0.1).find("thinner than the aperture") != std::string::npos,
        Pstream::master()
    );
}


// Not the root of a negative number
TEST(erosionBracket, refusesClayThatCoagulates)
{
    const LiusClay clay
    (
        "water { concentration 100; } viscosity { gelStop off; }"
    );
    EXPECT_LT(clay.D.value(0.05), 0);
    EXPECT_NE
    (
        messageOf([&] { erosionBracket(matterOf(clay), 0.05); })
           .find("coagulates"),
        std::string::npos
    );
}


TEST(erosionBracket, isPrintedInTheUnitsOfTheField)
{
    const LiusClay clay
    (
        "water { concentration 0.1; } viscosity { gelStop off; }"
    );
    const erosionBracket bracket(matterOf(clay), 0.01);
    OStringStream os;
    bracket.write
    (
        os, erosionBracket::edge::around(0.02, 1e-3, 1e-5), density
    );
    const std::string text(os.str());

    // 4.59 mg/h are 0.04024 kg in 8766 h; the edge has 1.2566e-4 m2
    for
    (
        const char* part :
        {
            "formula 2-2", " 4.59 ", " 0.04024 ", " 320.2 ", " 4024\n",
            "rim (A), as printed ", "rim (C) ", "rim (C), flocculated",
            "rim/b", "ten\ntimes or more"
        }
    )
    {
        EXPECT_NE(text.find(part), std::string::npos) << part << nl << text;
    }

    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
        EXPECT_LE(line.size(), 80u) << line;
    }
}


// ************************************************************************* //
