/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Forces of rocks that are rough, round, stepped or sharp.
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"

#include <gtest/gtest.h>

namespace
{

engineSettings settings()
{
    engineSettings chosen;
    chosen.thickness = 0.1;
    chosen.cutOff = 1;
    chosen.pairKernel = engineSettings::kernel::exact;
    return chosen;
}


//- The force of a plane at a distance, as of a platelet at the same gap
double planeForce(const gapForce& law, double distance)
{
    return pairForce(law, settings(), distance + 0.05);
}


const periodicBox openSpace;

} // End namespace


TEST(rocks, withAStepActContinuously)
{
    // Round the protruding edge of a block: the force has no jumps
    boundarySurface block;
    addRock
    (
        block, vector(-3, -3, -3), vector(0, 3, 0), action::platelet, 8
    );

    const auto jump = [&](int points)
    {
        std::vector<vector> places;
        for (int k = 0; k <= points; ++k)
        {
            // Half way round the edge at x = z = 0
            const double angle = 0.05 + (1.5*M_PI - 0.1)*k/points;
            places.push_back
            (
                0.4*vector(-std::cos(angle), 0, std::sin(angle))
              + vector(0, 0.123, 0)
            );
        }
        const auto force =
            wallForcesAt(places, openSpace, block, repulsion(), settings());

        double most = 0;
        for (int k = 0; k < points; ++k)
        {
            most = std::max(most, (force[k + 1] - force[k]).norm());
        }
        return most;
    };

    // The change from point to point falls as the points come closer
    EXPECT_LT(jump(160), 0.3*jump(40));
}


TEST(rocks, actFromTheNearestPoint)
{
    // A sphere of triangles: one smooth region
    boundarySurface sphere;
    const int n = 24;
    const auto at = [&](int i, int j)
    {
        const double polar = M_PI*i/n;
        const double around = M_PI*j/n;
        return vector
        (
            std::sin(polar)*std::cos(around),
            std::sin(polar)*std::sin(around),
            std::cos(polar)
        );
    };
    for (int i = 0; i < n; ++i)
    {
        for (int j = 0; j < 2*n; ++j)
        {
            // The triangles at the poles that have no area are left out
            addTriangle(sphere, at(i, j), at(i + 1, j), at(i + 1, j + 1));
            addTriangle(sphere, at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }

    const std::vector<vector> places
    {
        vector(0, 0, 1.3), vector(0.9, 0.7, 0.3), vector(-1.1, 0.1, -0.5)
    };
    const auto force =
        wallForcesAt(places, openSpace, sphere, repulsion(), settings());

    for (std::size_t k = 0; k < places.size(); ++k)
    {
        const double expected = pairForce
        (
            repulsion(), settings(), places[k].norm() - 1 + 0.05
        );

        // The facets lie up to (pi/24)^2/4 inside the sphere; decay 3
        EXPECT_NEAR(force[k].norm(), expected, 0.02*expected);
        EXPECT_GT(force[k].dot(places[k].normalized()), 0.98*force[k].norm());
    }
}


TEST(rocks, actTheSameWhileListsAreKept)
{
    // Carried past a rough surface within half of a large skin, against lists
    // that are made at the same place
    boundarySurface rough;
    const auto at = [](int i, int j)
    {
        return vector(0.1*i, 0.1*j, 0.03*((7*i + 3*j) % 4));
    };
    for (int i = -12; i < 22; ++i)
    {
        for (int j = -12; j < 22; ++j)
        {
            addTriangle(rough, at(i, j), at(i + 1, j), at(i + 1, j + 1));
            addTriangle(rough, at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }

    auto chosen = settings();
    chosen.skin = 0.6;
    chosen.deltaT = 0.02;
    chosen.integrator = "Euler";
    const auto law = std::make_shared<repulsion>();

    // As one region, and as many flat ones
    for (const double featureAngle : {179.0, 30.0})
    {
        rough.featureAngle = featureAngle;

        engine system(openSpace, rough, law, chosen, MPI_COMM_WORLD);
        std::vector<vector> places;
        std::vector<vector> kept;

        for (const vector& start : scatter(20, vector(0.3, 0.3, 0.3)).position)
        {
            platelets one;
            if (myRank() == 0)
            {
                one.append(0, start + vector(0, 0, 0.02));
                one.tag[0] = 0;
                one.friction[0] = 1e3;
                one.waterVelocity[0] = vector(0.9, 0.4, 0.3);
            }
            system.load(one);
            system.evaluate();
            const std::int64_t rebuilds = system.counters().rebuilds;

            for (int step = 0; step < 14; ++step)
            {
                system.advance(0.02);
                system.evaluate();
                EXPECT_EQ(system.counters().rebuilds, rebuilds);

                kept.push_back
                (
                    gather(system.local(), system.local().force, 1)[0]
                );
                places.push_back
                (
                    gather(system.local(), system.local().position, 1)[0]
                );
            }
        }

        const auto made =
            wallForcesAt(places, openSpace, rough, *law, settings());

        EXPECT_LT(largestDifference(kept, made), 1e-14);
    }
}


TEST(rocks, ofSharpRockPushOutwardsEverywhere)
{
    // A thin spike of four sides, one of them in slivers at the tip, all one
    // region: the normals of single faces mislead about the side at the tip
    const vector tip(0, 0, 1);
    const std::vector<vector> foot
    {
        vector(0.1, 0, 0), vector(-0.05, 0.09, 0), vector(-0.05, -0.09, 0)
    };

    boundarySurface spike;
    spike.featureAngle = 179.9;
    addTriangle(spike, foot[1], foot[0], foot[2]);
    addTriangle(spike, foot[1], foot[2], tip);
    addTriangle(spike, foot[2], foot[0], tip);
    for (int k = 0; k < 16; ++k)
    {
        addTriangle
        (
            spike,
            foot[0] + (foot[1] - foot[0])*k/16,
            foot[0] + (foot[1] - foot[0])*(k + 1)/16,
            tip
        );
    }

    // Round the tip and along the spike, outside by all means
    std::vector<vector> places;
    for (int k = 0; k < 200; ++k)
    {
        const double around = 2.4*k;
        const double up = std::cos(0.05 + 0.0075*k);
        places.push_back
        (
            tip
          + 0.3
           *vector
            (
                std::sqrt(1 - up*up)*std::cos(around),
                std::sqrt(1 - up*up)*std::sin(around),
                up
            )
        );
    }

    const auto force =
        wallForcesAt(places, openSpace, spike, repulsion(), settings());

    for (std::size_t k = 0; k < places.size(); ++k)
    {
        // The nearest point is the tip or close to it
        EXPECT_GT
        (
            force[k].dot((places[k] - tip).normalized()), 0.9*force[k].norm()
        );
        EXPECT_GT(force[k].norm(), 0.9*planeForce(repulsion(), 0.3)) << k;
        EXPECT_LT(force[k].norm(), 1.2*planeForce(repulsion(), 0.3)) << k;
    }

    // Within, out by the nearest side
    const auto inside = wallForcesAt
    (
        {vector(0, 0, 0.9), vector(1e-4, 2e-4, 0.98)},
        openSpace, spike, repulsion(), settings()
    );
    EXPECT_LT(std::abs(inside[0][2]), 0.2*inside[0].norm());
    EXPECT_GT(inside[0].norm(), planeForce(repulsion(), 0));
    EXPECT_GT(inside[1].norm(), planeForce(repulsion(), 0));
}
