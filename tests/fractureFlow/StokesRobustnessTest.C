/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowCase.H"
#include "StokesFlow.H"
#include "surfaceFields.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using fractureFlows::StokesFlow;

static const string noSlip("type noSlip;");
static const string zeroGradient("type zeroGradient;");

static string fixed(const string& value)
{
    return "type fixedValue; value uniform " + value + ";";
}

static label nIterations(const fractureFlow& flow)
{
    return refCast<const StokesFlow>(flow).residuals().size() - 1;
}


//- A channel of two heights length between walls, water driven by pressure
static boxSpec channel(const label n)
{
    boxSpec spec;
    spec.size = vector(2, 1, 1./n);
    spec.cells = {2*n, n, 1};
    spec.types = {"patch", "patch", "wall", "wall", "empty", "empty"};
    return spec;
}

static void writePressureDriven(const flowCase& c)
{
    c.writeU
    ({
        {"bottom", noSlip},
        {"top", noSlip},
        {"inlet", zeroGradient},
        {"outlet", zeroGradient}
    });
    c.writeP
    ({
        {"bottom", zeroGradient},
        {"top", zeroGradient},
        {"inlet", fixed("1e-3")},
        {"outlet", fixed("0")}
    });
}

static void writeVelocityDriven(const flowCase& c)
{
    c.writeU
    ({
        {"bottom", noSlip},
        {"top", noSlip},
        {"inlet", fixed("(1e-5 0 0)")},
        {"outlet", zeroGradient}
    });
    c.writeP
    ({
        {"bottom", zeroGradient},
        {"top", zeroGradient},
        {"inlet", zeroGradient},
        {"outlet", fixed("0")}
    });
}

//- Gel on the bottom in the middle of the channel, in steps of cells
static scalar bump(const vector& x, const scalar ratio)
{
    return x.y() < 0.5*std::exp(-4*sqr(x.x() - 1)) ? ratio : 1;
}

//- Loose pieces of gel
static scalar pieces(const vector& x, const scalar ratio)
{
    return
        std::sin(9*x.x() + 1)*std::sin(11*x.y() + 0.3) > 0.3 ? ratio : 1;
}


// The preconditioner has to answer for cells and jumps alike. 60: two thirds
// above what was measured, 33 with 1e6 on the finest mesh here
TEST(Stokes, iterationsDoNotGrowWithCellsOrJumpsOfViscosity)
{
    for (const label n : {12, 48})
    {
        for (const scalar ratio : {1., 1e6})
        {
            flowCase c(channel(n));
            c.setViscosity
            (
                [&](const vector& x) { return bump(x, ratio); }
            );

            writePressureDriven(c);
            auto flow = c.newFlow("model Stokes;");
            flow->solve();
            EXPECT_LE(nIterations(*flow), 60) << n << " cells, " << ratio;
        }
    }
}


// Measured: 58 to 62 with 16 to 64 cells. Each piece moves as a rigid body, slow for any preconditioner
TEST(Stokes, loosePiecesOfGelConverge)
{
    flowCase c(channel(40));
    c.setViscosity([](const vector& x) { return pieces(x, 1e6); });
    writePressureDriven(c);

    auto flow = c.newFlow("model Stokes;");
    flow->solve();
    EXPECT_LE(nIterations(*flow), 120);
}


TEST(Stokes, longChannelConverges)
{
    boxSpec spec = channel(16);
    spec.size.x() = 50;
    spec.cells[0] = 200;
    flowCase c(spec);
    writePressureDriven(c);

    auto flow = c.newFlow("model Stokes;");
    flow->solve();
    EXPECT_LE(nIterations(*flow), 90);
}


TEST(Stokes, waterIsNeitherLostNorMade)
{
    flowCase c(channel(32));
    c.setViscosity([](const vector& x) { return bump(x, 1e6); });
    writeVelocityDriven(c);

    auto flow = c.newFlow("model Stokes;");
    flow->solve();

    const scalar in = -gSum(flow->phi().boundaryField()[0]);
    const scalar out = gSum(flow->phi().boundaryField()[1]);

    EXPECT_NEAR(in, 1e-5/32, 1e-12*in);

    // What the residual, 1e-8, leaves: it counts the gel's dissipation too
    EXPECT_NEAR(out, in, 1e-5*in);
    EXPECT_LT(relativeDivergence(*flow), 1e-5);

    // The gel is a wall to the water: 1e6 times stiffer, less for the pressure
    // that piles up in front
    scalar inGel = 0;
    forAll(c.mesh().C(), i)
    {
        const vector x = c.mesh().C()[i];
        if (bump(x, 1e6) > 1 && mag(x.x() - 1) < 0.2)
        {
            inGel = max(inGel, mag(flow->U()[i]));
        }
    }
    EXPECT_LT(returnReduce(inGel, maxOp<scalar>()), 1e-4*1e-5);
}


TEST(Stokes, solutionThatStandsTakesNoIterationAndNearOneFew)
{
    flowCase c(channel(32));
    c.setViscosity([](const vector& x) { return bump(x, 1e3); });
    writePressureDriven(c);

    auto flow = c.newFlow("model Stokes;");
    flow->solve();
    const label fromRest = nIterations(*flow);
    const vectorField U(flow->U().primitiveField());

    flow->solve();
    EXPECT_EQ(nIterations(*flow), 0);
    EXPECT_EQ(gMax(mag(flow->U().primitiveField() - U)()), 0);

    c.alpha() *= 1.0001;
    flow->solve();
    EXPECT_GT(nIterations(*flow), 0);
    EXPECT_LT(nIterations(*flow), 0.7*fromRest);
}


TEST(Stokes, tighterResidualGoesOnWhereTheLooserStopped)
{
    flowCase c(channel(16));
    c.setViscosity([](const vector& x) { return bump(x, 1e3); });
    writePressureDriven(c);

    c.controls().set("residual", 1e-3);
    auto flow = c.newFlow("model Stokes;");
    flow->solve();
    const auto& residuals = refCast<const StokesFlow>(*flow).residuals();
    EXPECT_LE(residuals.last(), 1e-3);
    EXPECT_GT(residuals.last(), 1e-6);

    c.controls().set("residual", 1e-10);
    flow->solve();
    EXPECT_LE(residuals.last(), 1e-10);
}


TEST(Stokes, nothingThatDrivesIsWaterAtRest)
{
    flowCase c(channel(8));
    writePressureDriven(c);
    c.writeP
    ({
        {"bottom", zeroGradient},
        {"top", zeroGradient},
        {"inlet", fixed("0")},
        {"outlet", fixed("0")}
    });

    auto flow = c.newFlow("model Stokes;");
    flow->solve();
    EXPECT_EQ(gMax(mag(flow->U())().primitiveField()), 0);
    EXPECT_EQ(gMax(mag(flow->phi())().primitiveField()), 0);
}


// The lower half of a symmetric channel is the same flow
TEST(Stokes, symmetryPlaneCutsChannelInHalf)
{
    scalar largest[2];
    for (const label half : {0, 1})
    {
        boxSpec spec = channel(half ? 8 : 16);
        spec.cells[0] = 16;
        if (half)
        {
            spec.size.y() = 0.5;
            spec.types[3] = "symmetryPlane";
        }
        flowCase c(spec);
        c.setViscosity
        (
            [](const vector& x)
            {
                return std::min(x.y(), 1 - x.y()) < 0.25 ? 10 : 1;
            }
        );

        std::map<word, string> U
        {
            {"bottom", noSlip},
            {"inlet", zeroGradient},
            {"outlet", zeroGradient}
        };
        std::map<word, string> p
        {
            {"bottom", zeroGradient},
            {"inlet", fixed("1e-3")},
            {"outlet", fixed("0")}
        };
        if (!half)
        {
            U["top"] = noSlip;
            p["top"] = zeroGradient;
        }
        c.writeU(U);
        c.writeP(p);

        auto flow = c.newFlow("model Stokes;");
        flow->solve();
        largest[half] = gMax(mag(flow->U())().primitiveField());
    }
    EXPECT_NEAR(largest[1]/largest[0], 1, 1e-6);
}


// Cells sheared by 30 degrees along the walls: the profile stays
TEST(Stokes, shearedCellsKeepTheProfile)
{
    boxSpec spec;
    spec.size = vector(0.1, 1, 0.1);
    spec.cells = {4, 40, 1};
    spec.types = {"cyclic", "cyclic", "wall", "wall", "empty", "empty"};
    spec.map = [](const vector& x)
    {
        return vector(x.x() + 5.77*x.y(), x.y(), x.z());
    };
    flowCase c(spec);
    c.writeU({{"bottom", noSlip}, {"top", noSlip}});
    c.writeP({{"bottom", zeroGradient}, {"top", zeroGradient}});

    auto flow = c.newFlow
    (
        "model Stokes; StokesCoeffs { pressureGradient (-8e-3 0 0); }"
    );
    flow->solve();

    // u = G y (1 - y)/(2 eta), 1 in the middle
    scalar error = 0;
    forAll(c.mesh().C(), i)
    {
        const scalar y = c.mesh().C()[i].y();
        error = max(error, mag(flow->U()[i] - vector(4*y*(1 - y), 0, 0)));
    }
    EXPECT_LT(returnReduce(error, maxOp<scalar>()), 0.01);
}


TEST(Stokes, levelOfThePressureIsThatOfTheReferenceCell)
{
    boxSpec spec = channel(8);
    spec.types[0] = spec.types[1] = "cyclic";
    flowCase c(spec);
    c.setViscosity([](const vector& x) { return bump(x, 10); });
    c.writeU({{"bottom", noSlip}, {"top", noSlip}});
    c.writeP({{"bottom", zeroGradient}, {"top", zeroGradient}});
    c.controls().set("pRefCell", 3);
    c.controls().set("pRefValue", 0.25);

    auto flow = c.newFlow
    (
        "model Stokes; StokesCoeffs { pressureGradient (-1 0 0); }"
    );
    flow->solve();

    if (Pstream::master())
    {
        EXPECT_NEAR(refCast<const StokesFlow>(*flow).p()[3], 0.25, 1e-12);
    }
}
