/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Integrators and steps against solutions in closed form.
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"

#include <gtest/gtest.h>

namespace
{

const periodicBox openSpace;

engineSettings settings(const std::string& integrator, double deltaT)
{
    engineSettings chosen;
    chosen.cutOff = 100;
    chosen.pairKernel = engineSettings::kernel::exact;
    chosen.integrator = integrator;
    chosen.deltaT = deltaT;
    return chosen;
}


//- Platelets at places along x, on the last rank
platelets row(const std::vector<double>& places, bool endsFixed = false)
{
    platelets all;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
        all.append(k, vector(places[k], 0, 0));
        all.tag.back() = int(k);
        all.fixed.back() =
            endsFixed && (k == 0 || k + 1 == places.size());
    }
    return myRank() == nRanks() - 1 ? all : platelets();
}


double place(const engine& system, int tag)
{
    return gather(system.local(), system.local().position, 3)[tag][0];
}


//- Distance of two platelets that repel one another by exp(-3 r) with unit
//  friction, after a time: dr/dt = 2 exp(-3 r)
double exactDistance(double start, double time)
{
    return std::log(std::exp(3*start) + 6*time)/3;
}


//- Error of that distance after unit time in a number of equal steps
double error(const std::string& integrator, int steps)
{
    engine system
    (
        openSpace, {}, std::make_shared<repulsion>(),
        settings(integrator, 1.0/steps), MPI_COMM_WORLD
    );
    system.load(row({0, 0.5}));
    system.advance(1);

    EXPECT_EQ(system.counters().steps, steps);
    return std::abs
    (
        place(system, 1) - place(system, 0) - exactDistance(0.5, 1)
    );
}


//- One platelet held between two fixed ones by springs: the factor by which
//  its displacement grows per step, after many
double growth(const std::string& integrator, double deltaT)
{
    engine system
    (
        openSpace, {}, std::make_shared<spring>(),
        settings(integrator, deltaT), MPI_COMM_WORLD
    );
    system.load(row({-1, 1e-3, 1}, true));

    system.advance(29*deltaT);
    const double before = place(system, 1);
    system.advance(deltaT);
    return place(system, 1)/before;
}

} // End namespace


TEST(integrators, EulerIsFirstOrder)
{
    const double ratio = error("Euler", 40)/error("Euler", 80);

    EXPECT_NEAR(ratio, 2, 0.1);
}


TEST(integrators, AdamsBashforth2IsSecondOrder)
{
    // The first, Euler's, step adds an error of second order too
    const double ratio =
        error("AdamsBashforth2", 80)/error("AdamsBashforth2", 160);

    EXPECT_NEAR(ratio, 4, 0.3);
    EXPECT_LT(error("AdamsBashforth2", 80), 1e-4);
}


TEST(integrators, AdamsBashforth2IsSecondOrderWhenTheStepChanges)
{
    const auto error = [](int steps)
    {
        // Steps of three sizes one after the other
        auto chosen = settings("AdamsBashforth2", 1.0/steps);
        engine system
        (
            openSpace, {}, std::make_shared<repulsion>(), chosen, MPI_COMM_WORLD
        );
        system.load(row({0, 0.5}));
        for (int part = 0; part < steps; ++part)
        {
            system.advance(1.0/steps);
            system.advance(0.6/steps);
            system.advance(0.9/steps);
        }
        return std::abs
        (
            place(system, 1) - place(system, 0) - exactDistance(0.5, 2.5)
        );
    };

    EXPECT_NEAR(error(80)/error(160), 4, 0.4);
}


TEST(integrators, growDisturbancesByTheFactorsOfTheory)
{
    // Rate of decay 2. Euler: 1 - 2 dt. Adams-Bashforth: the greater root of
    // z^2 - (1 - 3 dt) z - dt = 0. Friction 1, springs exact: to rounding,
    // where the lesser root's part has died out
    for (const double deltaT : {0.1, 0.9, 1.2})
    {
        EXPECT_NEAR(growth("Euler", deltaT), 1 - 2*deltaT, 1e-9);
    }
    for (const double deltaT : {0.1, 0.55})
    {
        const double b = 1 - 3*deltaT;
        const double root = std::sqrt(b*b + 4*deltaT);
        const double expected =
            b > 0 ? (b + root)/2 : (b - root)/2;

        EXPECT_NEAR(growth("AdamsBashforth2", deltaT), expected, 1e-6);
    }

    // The limits on the real axis, 2 and 1 over the rate
    EXPECT_LT(std::abs(growth("Euler", 0.99)), 1);
    EXPECT_GT(std::abs(growth("Euler", 1.01)), 1);
    EXPECT_LT(std::abs(growth("AdamsBashforth2", 0.49)), 1);
    EXPECT_GT(std::abs(growth("AdamsBashforth2", 0.51)), 1);
}


TEST(steps, areHalfTheIntegratorsLimit)
{
    // Springs to two fixed platelets: rate of decay 2
    for (const auto& [integrator, limit] :
        {std::make_pair("Euler", 2.0), std::make_pair("AdamsBashforth2", 1.0)})
    {
        engine system
        (
            openSpace, {}, std::make_shared<spring>(),
            settings(integrator, 0), MPI_COMM_WORLD
        );
        system.load(row({-1, 1e-3, 1}, true));

        EXPECT_NEAR(system.stabilityLimit(), limit/2, 1e-12);
        EXPECT_NEAR(system.stableDeltaT(), limit/4, 1e-12);

        system.advance(10);
        EXPECT_EQ(system.counters().steps, std::lround(10/(limit/4)));
    }
}


TEST(steps, growAsTheForcesSoften)
{
    // Two that repel: the rate of decay 2*3*exp(-3 r) falls by 20 in this time
    auto chosen = settings("AdamsBashforth2", 0);
    chosen.cutOff = 2;
    engine system
    (
        openSpace, {}, std::make_shared<repulsion>(), chosen, MPI_COMM_WORLD
    );
    system.load(row({0, 0.5}));

    const double first = system.stableDeltaT();
    system.advance(14);

    // Steps of half of 1/rate would be 2 ln(20) in all. More, as a step serves
    // until the platelets have come a small part of the cut-off
    EXPECT_GE(system.counters().steps, 5);
    EXPECT_LT(system.counters().steps, 0.3*14/first);

    // Few steps, half the limit of stability each
    EXPECT_NEAR
    (
        place(system, 1) - place(system, 0), exactDistance(0.5, 14), 0.03
    );
}


TEST(steps, areEqualAndEndOnTheDuration)
{
    engine system
    (
        openSpace, {}, std::make_shared<noForce>(),
        settings("AdamsBashforth2", 0.3), MPI_COMM_WORLD
    );
    system.load(row({1}));

    system.advance(1);
    EXPECT_EQ(system.counters().steps, 4);
    for (const double step : system.local().previousStep)
    {
        EXPECT_DOUBLE_EQ(step, 0.25);
    }

    // A multiple of the step but for rounding is not one more step
    system.advance(3*0.3);
    EXPECT_EQ(system.counters().steps, 7);

    // Larger than the duration: one step
    system.advance(0.01);
    EXPECT_EQ(system.counters().steps, 8);

    system.advance(0);
    EXPECT_EQ(system.counters().steps, 8);
}


TEST(steps, followAFastFlow)
{
    // A lone platelet that the water carries over many cut-offs; a step moves
    // it by a quarter of the spacing, of the cut-off where none is given
    for (const double spacing : {0.0, 0.5})
    {
        auto chosen = settings("AdamsBashforth2", 0);
        chosen.cutOff = 1;
        chosen.spacing = spacing;
        chosen.bodyForce = vector(1, 0, 0);

        engine system
        (
            openSpace, {}, std::make_shared<repulsion>(), chosen,
            MPI_COMM_WORLD
        );
        platelets one(row({0}));
        for (std::size_t k = 0; k < one.size(); ++k)
        {
            one.waterVelocity[k] = vector(499, 0, 0);
        }
        system.load(one);
        system.advance(0.2);

        // Constant velocity is integrated exactly
        EXPECT_NEAR(place(system, 0), 100, 1e-10);
        EXPECT_EQ(system.counters().steps, spacing > 0 ? 800 : 400);
    }
}


TEST(steps, carryABodyForceOnMobilePlateletsOnly)
{
    auto chosen = settings("Euler", 0.1);
    chosen.bodyForce = vector(2, 0, 0);

    engine system
    (
        openSpace, {}, std::make_shared<noForce>(), chosen, MPI_COMM_WORLD
    );
    platelets some(row({0, 5, 10}, true));
    for (double& friction : some.friction)
    {
        friction = 4;
    }
    system.load(some);
    system.advance(1);

    EXPECT_DOUBLE_EQ(place(system, 0), 0);
    EXPECT_NEAR(place(system, 1), 5.5, 1e-14);
    EXPECT_DOUBLE_EQ(place(system, 2), 10);
}


TEST(fixedPlatelets, actButDoNotMove)
{
    engine system
    (
        openSpace, {}, std::make_shared<repulsion>(),
        settings("AdamsBashforth2", 0.01), MPI_COMM_WORLD
    );
    platelets pair(row({0, 0.5}));
    if (pair.size())
    {
        // A history must not move it either
        pair.fixed[0] = 1;
        pair.previousVelocity[0] = vector(1, 1, 1);
        pair.previousStep[0] = 0.01;
    }
    system.load(pair);
    system.advance(0.5);

    // dr/dt = exp(-3 r): half as fast as two that move
    EXPECT_DOUBLE_EQ(place(system, 0), 0);
    EXPECT_NEAR(place(system, 1), exactDistance(0.5, 0.25), 1e-5);

    system.evaluate();
    const auto force = gather(system.local(), system.local().force, 2);
    EXPECT_NEAR(force[0][0], -std::exp(-3*place(system, 1)), 1e-14);
}


namespace
{

//- The distance of two platelets that repel one another after unit time, and
//  what it cost
struct adaptiveRun
{
    double error;
    std::int64_t evaluations;
    std::int64_t steps;
};

adaptiveRun repelled(const std::string& integrator, double tolerance)
{
    auto chosen = settings(integrator, 0);
    chosen.spacing = 1;
    chosen.stepTolerance = tolerance;
    engine system
    (
        openSpace, {}, std::make_shared<repulsion>(), chosen, MPI_COMM_WORLD
    );
    system.load(row({0, 0.5}));
    system.advance(1);

    return
    {
        std::abs
        (
            place(system, 1) - place(system, 0) - exactDistance(0.5, 1)
        ),
        system.counters().evaluations,
        system.counters().steps
    };
}

} // End namespace


TEST(adaptiveIntegrators, keepTheirTolerance)
{
    for (const std::string integrator : {"RKC2", "BogackiShampine"})
    {
        std::int64_t before = 0;
        for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6})
        {
            const auto run = repelled(integrator, tolerance);

            // Errors of steps add up
            EXPECT_LT(run.error, tolerance*run.steps) << integrator;
            EXPECT_GT(run.evaluations, before) << integrator;
            before = run.evaluations;
        }
    }
}


TEST(adaptiveIntegrators, areOfTheirOrder)
{
    // Equal steps: the tolerance holds for any
    const auto error = [](const std::string& integrator, int steps)
    {
        auto chosen = settings(integrator, 1.0/steps);
        chosen.spacing = 1;
        chosen.stepTolerance = 10;
        engine system
        (
            openSpace, {}, std::make_shared<repulsion>(), chosen,
            MPI_COMM_WORLD
        );
        system.load(row({0, 0.5}));

        // One call for each step
        for (int step = 0; step < steps; ++step)
        {
            system.advance(1.0/steps);
        }
        EXPECT_EQ(system.counters().steps, steps);
        return std::abs
        (
            place(system, 1) - place(system, 0) - exactDistance(0.5, 1)
        );
    };

    EXPECT_NEAR(error("RKC2", 16)/error("RKC2", 32), 4, 0.5);
    EXPECT_NEAR
    (
        error("BogackiShampine", 16)/error("BogackiShampine", 32), 8, 1.2
    );
}


TEST(adaptiveIntegrators, RKC2IsStableFarBeyondEuler)
{
    // A displaced platelet between springs: all steps 400 times Euler's limit,
    // 1 over the rate 2 of decay
    auto chosen = settings("RKC2", 400);
    chosen.spacing = 1;
    chosen.stepTolerance = 1;
    engine system
    (
        openSpace, {}, std::make_shared<spring>(), chosen, MPI_COMM_WORLD
    );
    system.load(row({-1, 1e-3, 1}, true));
    system.advance(8000);

    EXPECT_LE(system.counters().steps, 40);
    EXPECT_LT(std::abs(place(system, 1)), 1e-5);
}


TEST(adaptiveIntegrators, meetWallsAsStepsDo)
{
    // Carried against a wall that reflects: back by as much as it went through
    boundarySurface floor;
    const vector x(10, 0, 0);
    const vector y(0, 10, 0);
    addSheet(floor, vector(-5, -5, 0), x, y, action::reflect);

    for (const std::string integrator : {"RKC2", "BogackiShampine"})
    {
        auto chosen = settings(integrator, 0.25);
        chosen.cutOff = 1;
        engine system
        (
            openSpace, floor, std::make_shared<noForce>(), chosen,
            MPI_COMM_WORLD
        );
        platelets one;
        if (myRank() == 0)
        {
            one.append(0, vector(0, 0, 0.6));
            one.tag[0] = 0;
            one.waterVelocity[0] = vector(0, 0, -1);
        }
        system.load(one);
        system.advance(0.75);

        // 0.6 - 0.75, mirrored
        EXPECT_NEAR
        (
            gather(system.local(), system.local().position, 1)[0][2], 0.15,
            1e-12
        )   << integrator;
    }
}


TEST(adaptiveIntegrators, areTheSameOnAllRanks)
{
    const platelets all(scatter(300, vector::Constant(4)));
    const periodicBox space(cube(4));
    std::vector<std::vector<vector>> ends;

    for (const bool alone : {true, false})
    {
        engineSettings chosen;
        chosen.cutOff = 1.5;
        chosen.spacing = 0.6;
        chosen.pairKernel = engineSettings::kernel::exact;
        chosen.integrator = "RKC2";
        chosen.stepTolerance = 1e-3;
        engine system
        (
            space, {}, std::make_shared<repulsion>(), chosen,
            alone ? MPI_COMM_SELF : MPI_COMM_WORLD
        );
        system.load(alone ? all : share(all));
        system.advance(0.2);
        if (alone)
        {
            std::vector<vector> position(all.size());
            for (std::size_t k = 0; k < all.size(); ++k)
            {
                position[system.local().tag[k]] = system.local().position[k];
            }
            ends.push_back(position);
        }
        else
        {
            ends.push_back
            (
                gather(system.local(), system.local().position, all.size())
            );
        }
    }
    EXPECT_LT(largestDifference(ends[0], ends[1]), 1e-10);
}


TEST(adaptiveIntegrators, autoTakesTheBetterOne)
{
    // Where accuracy decides, Bogacki and Shampine's: 3 evaluations a step
    const auto smooth = repelled("BogackiShampine", 1e-6);
    const auto stiff = repelled("RKC2", 1e-6);
    const auto chosen = repelled("auto", 1e-6);

    EXPECT_LT(1.2*smooth.evaluations, stiff.evaluations);
    EXPECT_LT(chosen.evaluations, 1.2*smooth.evaluations);
}


TEST(adaptiveIntegrators, autoGoesBackWhereStabilityDecides)
{
    // A platelet between springs comes to rest, at a rate of 2, for a long time:
    // at first accuracy asks for small steps, then nothing does
    const auto evaluations = [](const std::string& integrator)
    {
        auto chosen = settings(integrator, 0);
        chosen.spacing = 1;
        chosen.stepTolerance = 1e-8;
        engine system
        (
            openSpace, {}, std::make_shared<spring>(), chosen, MPI_COMM_WORLD
        );
        system.load(row({-1, 0.5, 1}, true));
        system.advance(5);
        const auto early = system.counters().evaluations;
        system.advance(2000);
        EXPECT_LT(std::abs(place(system, 1)), 1e-5) << integrator;
        return std::array<std::int64_t, 2>
        {
            early, system.counters().evaluations - early
        };
    };
    const auto smooth = evaluations("BogackiShampine");
    const auto stiff = evaluations("RKC2");
    const auto chosen = evaluations("auto");

    EXPECT_LT(chosen[0], 1.2*smooth[0]);
    EXPECT_LT(1.2*smooth[0], stiff[0]);

    // No more than a rate of 2 and its limit of 2.5 allow
    EXPECT_GT(smooth[1], 3*2000*2/2.5);
    EXPECT_LT(chosen[1], 0.2*smooth[1]);
}
