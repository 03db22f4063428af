/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Platelets that meet reflecting and absorbing boundaries.
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"

#include <gtest/gtest.h>

namespace
{

engineSettings settings(double deltaT)
{
    engineSettings chosen;
    chosen.cutOff = 1;
    chosen.deltaT = deltaT;
    chosen.integrator = "Euler";
    return chosen;
}


//- One platelet at a place, carried by the water, on the last rank
platelets one(const vector& place, const vector& velocity)
{
    platelets made;
    if (myRank() == nRanks() - 1)
    {
        made.append(7, place);
        made.tag[0] = 0;
        made.waterVelocity[0] = velocity;
    }
    return made;
}


//- A cube of water, the triangles facing inwards, patches 0 to 5: the lower x,
//  y, z side, then the upper
boundarySurface room(double edge, action does, int n = 1)
{
    const vector x(edge, 0, 0);
    const vector y(0, edge, 0);
    const vector z(0, 0, edge);
    const vector top(x + y + z);

    boundarySurface surface;
    addSheet(surface, vector::Zero(), y, z, does, n, 0);
    addSheet(surface, vector::Zero(), z, x, does, n, 1);
    addSheet(surface, vector::Zero(), x, y, does, n, 2);
    addSheet(surface, top, -z, -y, does, n, 3);
    addSheet(surface, top, -x, -z, does, n, 4);
    addSheet(surface, top, -y, -x, does, n, 5);
    return surface;
}


//- Where a point that is reflected between 0 and the edge is at last
double folded(double x, double edge)
{
    x = std::fmod(std::abs(x), 2*edge);
    return x > edge ? 2*edge - x : x;
}

} // End namespace


TEST(reflection, mirrorsTheWayInARoom)
{
    // Steps of 0.37 to and fro; the velocity is the water's, which does not
    // turn: each step is mirrored by itself
    const vector velocity(3, -1, 2);
    const double deltaT = 0.1;
    const periodicBox space;

    for (const int n : {1, 4})
    {
        engine system
        (
            space, room(1, action::reflect, n), std::make_shared<noForce>(),
            settings(deltaT), MPI_COMM_WORLD
        );
        system.load(one(vector(0.5, 0.5, 0.5), velocity));

        vector expected(0.5, 0.5, 0.5);
        for (int step = 0; step < 50; ++step)
        {
            system.advance(deltaT);
            for (int axis = 0; axis < 3; ++axis)
            {
                expected[axis] =
                    folded(expected[axis] + deltaT*velocity[axis], 1);
            }
            const vector place
            (
                gather(system.local(), system.local().position, 1)[0]
            );
            EXPECT_LT((place - expected).norm(), 1e-13) << step;
        }
    }
}


TEST(reflection, holdsAPlateletThatIsPressedIntoACorner)
{
    const periodicBox space;
    engine system
    (
        space, room(1, action::reflect, 3), std::make_shared<noForce>(),
        settings(0.01), MPI_COMM_WORLD
    );
    system.load(one(vector(0.5, 0.4, 0.3), vector(-1, -1, -1)));
    system.advance(10);

    const vector place(gather(system.local(), system.local().position, 1)[0]);
    EXPECT_GE(place.minCoeff(), 0);
    EXPECT_LE(place.maxCoeff(), 0.011);
}


TEST(reflection, actsThroughAPeriodicSeam)
{
    // Across the seam in x while the floor at z = 0 reflects
    const periodicBox space(cube(2, true, true, false));
    boundarySurface floor;
    addSheet
    (
        floor, vector::Zero(), vector(2, 0, 0), vector(0, 2, 0),
        action::reflect, 2
    );
    engine system
    (
        space, floor, std::make_shared<noForce>(), settings(0.2),
        MPI_COMM_WORLD
    );
    system.load(one(vector(1.9, 1, 0.1), vector(1, 0, -1)));
    system.advance(0.2);

    const vector place(gather(system.local(), system.local().position, 1)[0]);
    EXPECT_LT((place - vector(0.1, 1, 0.1)).norm(), 1e-14);
}


TEST(absorption, takesAPlateletOutWhereItCrosses)
{
    const periodicBox space;
    engine system
    (
        space, room(2, action::absorb, 3), std::make_shared<noForce>(),
        settings(0.05), MPI_COMM_WORLD
    );
    system.load(one(vector(1, 1.2, 0.7), vector(0, 1, 0.1)));
    system.advance(0.5);
    EXPECT_TRUE(system.departures().empty());

    system.advance(10);
    EXPECT_TRUE(system.local().id.empty());

    if (myRank() == nRanks() - 1)
    {
        ASSERT_EQ(system.departures().size(), 1u);
        const auto& left = system.departures()[0];
        EXPECT_EQ(left.id, 7);
        EXPECT_EQ(left.tag, 0);
        EXPECT_EQ(left.patch, 4);
        EXPECT_LT((left.position - vector(1, 2, 0.78)).norm(), 1e-13);
    }

    // Only those of the last call
    system.advance(1);
    EXPECT_TRUE(system.departures().empty());
}


TEST(absorption, takesPlaceAtTheFirstOfTwoBoundaries)
{
    const periodicBox space;
    for (const bool reversed : {false, true})
    {
        boundarySurface sheets;
        for (const int patch : {1, 2})
        {
            const double x = reversed ? 0.1*patch : 0.3 - 0.1*patch;
            addSheet
            (
                sheets, vector(x, -5, -5), vector(0, 0, 10), vector(0, 10, 0),
                action::absorb, 1, patch
            );
        }
        engine system
        (
            space, sheets, std::make_shared<noForce>(), settings(0.5),
            MPI_COMM_WORLD
        );
        system.load(one(vector(0, 0, 0), vector(1, 0.1, 0)));
        system.advance(0.5);

        if (myRank() == nRanks() - 1)
        {
            ASSERT_EQ(system.departures().size(), 1u);
            EXPECT_EQ(system.departures()[0].patch, reversed ? 1 : 2);
            EXPECT_NEAR(system.departures()[0].position[0], 0.1, 1e-15);
        }
    }
}


namespace
{

//- A crowd that bursts: expects that what came in is inside or has left, and
//  that what is left feels only what is left, to a bound relative to the
//  largest force. Returns the places of what is left
std::vector<vector> burst(engineSettings::kernel kernel, double bound)
{
    const periodicBox space;
    const platelets all(scatter(300, vector(2, 2, 2)));
    auto chosen = settings(0);
    chosen.thickness = 0.1;
    chosen.integrator = "AdamsBashforth2";
    chosen.pairKernel = kernel;

    // Many leave while the same lists are in use
    chosen.skin = 0.5;
    const auto law = std::make_shared<repulsion>();

    engine system(space, room(2, action::absorb), law, chosen, MPI_COMM_WORLD);
    system.load(share(all));

    std::vector<int> left(all.size(), 0);
    for (int call = 0; call < 5; ++call)
    {
        system.advance(0.1);
        for (const auto& gone : system.departures())
        {
            ++left[gone.tag];
            EXPECT_EQ(gone.id, all.id[gone.tag]);
        }
    }
    for (const int tag : system.local().tag)
    {
        ++left[tag];
    }

    MPI_Allreduce
    (
        MPI_IN_PLACE, left.data(), int(left.size()), MPI_INT, MPI_SUM,
        MPI_COMM_WORLD
    );
    for (const int times : left)
    {
        EXPECT_EQ(times, 1);
    }

    double remaining = double(system.local().size());
    MPI_Allreduce
    (
        MPI_IN_PLACE, &remaining, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD
    );
    EXPECT_GT(remaining, 50);
    EXPECT_LT(remaining, 250);

    system.evaluate();
    const auto position = gather(system.local(), system.local().position, 300);
    const auto force = gather(system.local(), system.local().force, 300);
    platelets inside;
    std::vector<vector> forceInside;
    for (std::size_t k = 0; k < all.size(); ++k)
    {
        if (position[k].norm() > 0)
        {
            inside.append(k, position[k]);
            forceInside.push_back(force[k]);
        }
    }
    const auto expected = doubleSum(inside, space, *law, chosen);
    EXPECT_LT
    (
        largestDifference(forceInside, expected), bound*largest(expected)
    )   << system.kernelName();
    return position;
}

} // End namespace


TEST(absorption, losesNone)
{
    const auto exact = burst(engineSettings::kernel::exact, 1e-12);

    // The same paths in vectors, but for their error over the burst
    const auto fast = burst(engineSettings::kernel::fast, 1e-5);
    EXPECT_LT(largestDifference(fast, exact), 1e-3);
}


TEST(boundaries, aPlateletMayComeInThroughTheirBacks)
{
    const periodicBox space;
    engine system
    (
        space, room(1, action::absorb), std::make_shared<noForce>(),
        settings(0.1), MPI_COMM_WORLD
    );
    system.load(one(vector(-0.5, 0.5, 0.5), vector(1, 0, 0)));
    system.advance(1);

    const vector place(gather(system.local(), system.local().position, 1)[0]);
    EXPECT_LT((place - vector(0.5, 0.5, 0.5)).norm(), 1e-14);
}
