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


TEST(rocks, thatAreRoundActAsTheirCircleLessTheChordError)
{
    // A pipe of flat strips, and the same as a pillar: where the force says that
    // the wall is, at 0.3 from it all around, against the circle
    const double radius = 2;
    const double away = 0.3;

    // Largest and smallest distance too much
    const auto errors = [&](int strips, bool pillar)
    {
        boundarySurface surface;
        const auto at = [&](int i, double z)
        {
            const double angle = 2*M_PI*(i % strips)/strips;
            return vector
            (
                radius*std::cos(angle), radius*std::sin(angle), z
            );
        };
        for (int i = 0; i < strips; ++i)
        {
            const int a = pillar ? i : i + 1;
            const int b = pillar ? i + 1 : i;
            addTriangle(surface, at(a, -3), at(b, -3), at(b, 3));
            addTriangle(surface, at(a, -3), at(b, 3), at(a, 3));
        }

        std::vector<vector> places;
        for (int k = 0; k < 97; ++k)
        {
            const double angle = 0.001 + 2*M_PI*k/97;
            places.push_back
            (
                (radius + (pillar ? away : -away))
               *vector(std::cos(angle), std::sin(angle), 0)
            );
        }
        const auto force =
            wallForcesAt(places, openSpace, surface, repulsion(), settings());

        std::pair<double, double> found(1, -1);
        for (std::size_t k = 0; k < places.size(); ++k)
        {
            // F = exp(-3 (distance - 0.05))
            const double distance = 0.05 - std::log(force[k].norm())/3;
            found.first = std::min(found.first, distance - away);
            found.second = std::max(found.second, distance - away);

            // At most half the bend between two strips off the radius
            const vector outwards(places[k].normalized()*(pillar ? 1 : -1));
            EXPECT_GT
            (
                force[k].dot(outwards),
                (std::cos(M_PI/strips) - 1e-12)*force[k].norm()
            );
        }
        return found;
    };

    for (const int strips : {24, 48})
    {
        // Width^2/(8 radius), of which the middle of some strip is 1 % short
        const double sagitta = radius*(1 - std::cos(M_PI/strips));
        const double width = 2*radius*std::sin(M_PI/strips);
        EXPECT_NEAR(sagitta, width*width/(8*radius), 0.01*sagitta);

        const auto pipe = errors(strips, false);
        EXPECT_LT(pipe.second, 1e-12);
        EXPECT_NEAR(pipe.first, -sagitta, 0.01*sagitta);

        const auto pillar = errors(strips, true);
        EXPECT_GT(pillar.first, -1e-12);
        EXPECT_NEAR(pillar.second, sagitta, 0.01*sagitta);
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
