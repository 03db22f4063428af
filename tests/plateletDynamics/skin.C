/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The skin that the engine chooses, by the work that it makes: pairs listed,
    in every step and five times when the lists are made.
\*---------------------------------------------------------------------------*/

#include "testSystems.H"

#include <gtest/gtest.h>

namespace
{

//- Listed pairs handled in 200 steps of a drifting suspension
double workWith(double skin, double speed)
{
    const periodicBox space(cube(6));
    platelets all(scatter(800, vector::Constant(6)));
    std::mt19937 numbers(7);
    for (vector& velocity : all.waterVelocity)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            velocity[axis] = speed*(numbers()/2147483648.0 - 1);
        }
    }

    engineSettings settings;
    settings.cutOff = 1.5;
    settings.skin = skin;
    settings.deltaT = 0.01;
    settings.integrator = "Euler";

    engine system
    (
        space, {}, std::make_shared<noForce>(), settings, MPI_COMM_SELF
    );
    system.load(all);

    // Until the choice has settled
    system.advance(2);
    const auto rebuildsBefore = system.counters().rebuilds;

    double work = 0;
    for (int i = 0; i < 10; ++i)
    {
        system.advance(0.2);
        work += 20.0*system.counters().listedPairs;
    }
    return
        work
      + 5.0*(system.counters().rebuilds - rebuildsBefore)
       *system.counters().listedPairs;
}

} // End namespace


TEST(skin, isTheOneOfTheLeastWork)
{
    for (const double speed : {0.1, 1.0, 3.0})
    {
        double least = 1e300;
        for (const double skin : {0.03, 0.06, 0.12, 0.25, 0.4, 0.6})
        {
            least = std::min(least, workWith(skin, speed));
        }

        // The cost is flat about its least, and whole steps make it rugged
        EXPECT_LT(workWith(0, speed), 1.07*least) << "speed " << speed;
    }
}


TEST(skin, givenByTheUserStays)
{
    engineSettings settings;
    settings.cutOff = 1;
    settings.skin = 0.21;
    engine system
    (
        cube(4), {}, std::make_shared<noForce>(), settings, MPI_COMM_WORLD
    );
    system.load(share(scatter(100, vector::Constant(4))));
    system.advance(1);

    EXPECT_EQ(system.skin(), 0.21);
}
