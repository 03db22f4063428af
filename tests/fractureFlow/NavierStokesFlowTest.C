/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowCase.H"
#include "pressureFlow.H"
#include "surfaceFields.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using constant::mathematical::pi;
using fractureFlows::pressureFlow;

static const string noSlip("type noSlip;");
static const string slip("type slip;");
static const string zeroGradient("type zeroGradient;");

static string fixed(const string& value)
{
    return "type fixedValue; value uniform " + value + ";";
}

//- fvSolution with these numbers of correctors
static string fvSolutionOf(const label outer, const label inner)
{
    return
        "solvers { \"p.*\" { solver PCG; preconditioner DIC;"
        "tolerance 1e-11; relTol 0; }"
        "\"U.*\" { solver smoothSolver; smoother symGaussSeidel;"
        "tolerance 1e-11; relTol 0; } }"
        "PIMPLE { nOuterCorrectors " + Foam::name(outer)
      + "; nCorrectors " + Foam::name(inner)
      + "; pRefCell 0; pRefValue 0; }";
}

//- Plane channel of height 1 with cyclic ends, n cells across
static boxSpec periodicChannel(const label n)
{
    boxSpec spec;
    spec.size = vector(4./n, 1, 1./n);
    spec.cells = {4, n, 1};
    spec.types = {"cyclic", "cyclic", "wall", "wall", "empty", "empty"};
    spec.solution = fvSolutionOf(1, 2);
    return spec;
}

static void advance(flowCase& c, fractureFlow& flow, const scalar deltaT)
{
    c.time().setDeltaT(deltaT);
    ++c.time();
    flow.solve();
}

static scalar largestError
(
    const fractureFlow& flow,
    const std::function<vector(const vector&)>& exact
)
{
    scalar error = 0;
    forAll(flow.U(), i)
    {
        error = max(error, mag(flow.U()[i] - exact(flow.mesh().C()[i])));
    }
    return returnReduce(error, maxOp<scalar>());
}


//- Start-up of Poiseuille flow, 1e-6 m/s in the middle at last, so that the
//  Reynolds number is one, in a tenth of the viscous time of 1e6 s
static autoPtr<fractureFlow> startUp(flowCase& c, const label n)
{
    c.writeU({{"bottom", noSlip}, {"top", noSlip}});
    c.writeP({{"bottom", zeroGradient}, {"top", zeroGradient}});
    auto flow = c.newFlow
    (
        "model NavierStokes;"
        "NavierStokesCoeffs { pressureGradient (-8e-9 0 0); }"
    );

    c.time().setEndTime(1e6);
    for (label i = 0; i < n; ++i)
    {
        advance(c, *flow, 1e5/n);
    }
    return flow;
}

static scalar startUpError(const label n)
{
    flowCase c(periodicChannel(n));
    const auto flow = startUp(c, n);

    return largestError
    (
        *flow,
        [](const vector& x)
        {
            const scalar y = x.y();
            scalar u = 4*y*(1 - y);
            for (label k = 1; k < 60; k += 2)
            {
                u -=
                    32/pow3(k*pi)*std::sin(k*pi*y)
                   *std::exp(-sqr(k*pi)*0.1);
            }
            return vector(1e-6*u, 0, 0);
        }
    );
}


TEST(NavierStokes, startUpOfPoiseuilleFlowIsThatOfTheSeries)
{
    const scalar coarse = startUpError(16);
    const scalar fine = startUpError(32);

    // Of 0.6e-6 in the middle. Second order in both cells and steps
    EXPECT_LT(fine, 1e-9);
    EXPECT_NEAR(coarse/fine, 4, 0.6);
}


// The second wall moves from the first step on: its friction enters through the
// boundary values
TEST(NavierStokes, startUpOfCouetteFlowIsThatOfTheSeries)
{
    const label n = 32;
    flowCase c(periodicChannel(n));
    c.writeU({{"bottom", noSlip}, {"top", fixed("(1e-6 0 0)")}});
    c.writeP({{"bottom", zeroGradient}, {"top", zeroGradient}});
    auto flow = c.newFlow("model NavierStokes;");

    c.time().setEndTime(1e6);
    for (label i = 0; i < n; ++i)
    {
        advance(c, *flow, 1e5/n);
    }

    const scalar error = largestError
    (
        *flow,
        [](const vector& x)
        {
            scalar u = x.y();
            for (label k = 1; k < 60; ++k)
            {
                u +=
                    (k % 2 ? -2 : 2)/(k*pi)*std::sin(k*pi*x.y())
                   *std::exp(-sqr(k*pi)*0.1);
            }
            return vector(1e-6*u, 0, 0);
        }
    );
    EXPECT_LT(error, 2e-9);
}


// The same steps in one dimension: balance of each cell, backward differences,
// of which the first step is Euler's
static scalarField plainTwin(const label n)
{
    const scalar dt = 1e5/n;
    const scalar k = 1e-6*n*n;
    scalarField u(n, Zero);
    scalarField older(n, Zero);

    for (label step = 0; step < n; ++step)
    {
        const scalar c = step ? 1.5 : 1;
        scalarField factor(n);
        scalarField next(n);

        for (label i = 0; i < n; ++i)
        {
            const scalar below = i ? k : 2*k;
            const scalar above = i < n - 1 ? k : 2*k;
            const scalar old = step ? 2*u[i] - 0.5*older[i] : u[i];
            const scalar pivot =
                c/dt + below + above - (i ? k*factor[i - 1] : 0);

            factor[i] = above/pivot;
            next[i] = (8e-12 + old/dt + (i ? k*next[i - 1] : 0))/pivot;
        }
        for (label i = n - 2; i >= 0; --i)
        {
            next[i] += factor[i]*next[i + 1];
        }
        older = u;
        u = next;
    }
    return u;
}


TEST(NavierStokes, flowOnAnyNumberOfRanksIsThatOfTheOneDimensionalTwin)
{
    const label n = 16;
    flowCase c(periodicChannel(n));
    const auto flow = startUp(c, n);
    const scalarField u(plainTwin(n));

    EXPECT_LT
    (
        largestError
        (
            *flow,
            [&](const vector& x) { return vector(u[label(x.y()*n)], 0, 0); }
        ),
        1e-14
    );
}


// A vortex in a box with walls that let water slip: inertia is balanced by p,
// and friction lets it decay,
//     u = sin(x) cos(y) f, v = -cos(x) sin(y) f, f = exp(-2 nu t),
//     p = (cos(2x) + cos(2y)) f^2/4
struct vortexErrors
{
    scalar U;
    scalar p;
};

static vortexErrors vortex(const label n)
{
    boxSpec spec;
    spec.size = vector(pi, pi, 0.1);
    spec.cells = {n, n, 1};
    spec.types = {"wall", "wall", "wall", "wall", "empty", "empty"};
    spec.solution = fvSolutionOf(3, 2);

    flowCase c(spec);
    c.writeClayProperties("water { concentration 0.1; viscosity 100; }");
    c.writeU
    ({
        {"bottom", slip}, {"top", slip}, {"inlet", slip}, {"outlet", slip}
    });
    c.writeP
    ({
        {"bottom", zeroGradient},
        {"top", zeroGradient},
        {"inlet", zeroGradient},
        {"outlet", zeroGradient}
    });
    auto flow = c.newFlow("model NavierStokes;");

    const auto velocity = [](const vector& x, const scalar f)
    {
        return f*vector
        (
            std::sin(x.x())*std::cos(x.y()), -std::cos(x.x())*std::sin(x.y()), 0
        );
    };

    volVectorField& U = c.mesh().lookupObjectRef<volVectorField>("U");
    forAll(U, i)
    {
        U[i] = velocity(c.mesh().C()[i], 1);
    }
    U.correctBoundaryConditions();

    // nu = 0.1: one second is a fifth of the decay
    for (label i = 0; i < n; ++i)
    {
        advance(c, *flow, 1./n);
    }
    EXPECT_LT(relativeDivergence(*flow), 1e-8);

    const scalar f = std::exp(-0.2);
    vortexErrors errors;
    errors.U = largestError
    (
        *flow, [&](const vector& x) { return velocity(x, f); }
    );

    // Its level is that of a cell
    const volScalarField& p = refCast<const pressureFlow>(*flow).p();
    scalarField difference(p.primitiveField());
    forAll(difference, i)
    {
        const vector& x = c.mesh().C()[i];
        difference[i] -=
            (std::cos(2*x.x()) + std::cos(2*x.y()))*sqr(f)/4;
    }
    errors.p = gMax(mag(difference - gAverage(difference))());

    return errors;
}


TEST(NavierStokes, decayingVortexHasThePressureOfItsInertia)
{
    const vortexErrors coarse = vortex(12);
    const vortexErrors fine = vortex(24);

    // Of 0.8 and 0.34; without inertia p would be zero
    EXPECT_LT(fine.U, 1e-3);
    EXPECT_LT(fine.p, 2e-3);
    EXPECT_GT(coarse.U/fine.U, 3.5);
}


//- Gel on the bottom in the middle of a channel, 1e6 times as stiff as water
static scalar bump(const vector& x)
{
    return x.y() < 0.5*std::exp(-4*sqr(x.x() - 1)) ? 1e6 : 1;
}

static autoPtr<fractureFlow> channelWithGel(flowCase& c, const word& model)
{
    c.setViscosity(bump);
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
        {"inlet", fixed("1e-13")},
        {"outlet", fixed("0")}
    });
    return c.newFlow("model " + model + ";");
}

static boxSpec channel(const label n)
{
    boxSpec spec;
    spec.size = vector(2, 1, 1./n);
    spec.cells = {2*n, n, 1};
    spec.types = {"patch", "patch", "wall", "wall", "empty", "empty"};
    return spec;
}


// Steps of a fiftieth of the viscous time, at a Reynolds number of 1e-3
TEST(NavierStokes, steadyFlowRoundGelIsThatOfStokes)
{
    flowCase creeping(channel(16));
    auto expected = channelWithGel(creeping, "Stokes");
    expected->solve();

    boxSpec spec = channel(16);
    spec.solution = fvSolutionOf(1, 3);
    flowCase c(spec);
    auto flow = channelWithGel(c, "NavierStokes");
    c.time().setEndTime(1e7);
    for (label i = 0; i < 50; ++i)
    {
        advance(c, *flow, 2e4);
    }

    const scalar size = gMax(mag(expected->U())().primitiveField());
    const scalar difference = gMax
    (
        mag(flow->U().primitiveField() - expected->U().primitiveField())()
    );
    EXPECT_LT(difference, 1e-3*size);
    EXPECT_LT(relativeDivergence(*flow), 1e-8);
}


// Gel amid the water, free to move, in steps of five viscous times
TEST(NavierStokes, divergenceEndsWithAWayOut)
{
    boxSpec spec = channel(16);
    spec.solution = fvSolutionOf(1, 3);
    flowCase c(spec);
    auto flow = channelWithGel(c, "NavierStokes");
    c.setViscosity
    (
        [](const vector& x)
        {
            return sqr(x.x() - 1) + sqr(x.y() - 0.5) < 0.04 ? 1e6 : 1;
        }
    );
    c.time().setEndTime(1e9);

    const string message = messageOf
    (
        [&]()
        {
            for (label i = 0; i < 200; ++i)
            {
                advance(c, *flow, 5e6);
            }
        }
    );
    EXPECT_TRUE(mentions(message, {"diverges", "Courant", "Stokes", "HeleShaw"}))
        << message;
}


TEST(NavierStokes, wrongInputIsRefused)
{
    flowCase c(periodicChannel(4));
    c.writeU({{"bottom", noSlip}, {"top", noSlip}});
    c.writeP({{"bottom", zeroGradient}, {"top", zeroGradient}});
    EXPECT_TRUE
    (
        mentions
        (
            messageOf
            (
                [&]()
                {
                    c.newFlow
                    (
                        "model NavierStokes;"
                        "NavierStokesCoeffs { presureGradient (1 0 0); }"
                    );
                }
            ),
            {"presureGradient", "pressureGradient"}
        )
    );

    c.writeField
    (
        "p", "volScalarField", "[1 -1 -2 0 0 0 0]", "uniform 0",
        {{"bottom", zeroGradient}, {"top", zeroGradient}}
    );
    EXPECT_TRUE
    (
        mentions
        (
            messageOf([&]() { c.newFlow("model NavierStokes;"); }),
            {"kinematic", "[0 2 -2"}
        )
    );
}
