/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Platelets that pass through surfaces are counted: what passed adds up
    exactly to what is on the other side. Many ways go through edges and corners
    of triangles, along their planes, or end there: points on a lattice on which
    the corners are.
\*---------------------------------------------------------------------------*/

#include "surfaceCounters.H"
#include "testSurfaces.H"

#include <gtest/gtest.h>

#include <map>

using plateletDynamics::countedSurface;
using plateletDynamics::passages;
using plateletDynamics::surfaceCounters;

namespace
{

//- The triangles of a boundary, to be counted
countedSurface counted(const boundarySurface& from)
{
    countedSurface surface;
    for (const auto& triangle : from.triangles)
    {
        surface.triangles.push_back(triangle.corners);
    }
    return surface;
}


//- A cuboid whose triangles look outwards
countedSurface cuboid(const vector& a, const vector& b, int n)
{
    boundarySurface rock;
    addRock(rock, a, b, action::reflect, n);
    return counted(rock);
}


//- |x| + |y| + |z| = radius around a centre, seen from outside
countedSurface octahedron(const vector& centre, double radius)
{
    countedSurface surface;
    for (const double x : {-radius, radius})
    {
        for (const double y : {-radius, radius})
        {
            for (const double z : {-radius, radius})
            {
                std::array<vector, 3> corners
                {
                    vector(centre + vector(x, 0, 0)),
                    vector(centre + vector(0, y, 0)),
                    vector(centre + vector(0, 0, z))
                };
                if (x*y*z < 0)
                {
                    std::swap(corners[1], corners[2]);
                }
                surface.triangles.push_back(corners);
            }
        }
    }
    return surface;
}


countedSurface sheet
(
    const vector& origin,
    const vector& a,
    const vector& b,
    int n = 1
)
{
    boundarySurface surface;
    addSheet(surface, origin, a, b, action::reflect, n);
    return counted(surface);
}


std::int64_t net(const passages& through)
{
    return through.forward - through.backward;
}


//- Passages of all ranks
std::vector<passages> ofAllRanks(std::vector<passages> sums)
{
    for (passages& sum : sums)
    {
        std::int64_t both[2] = {sum.forward, sum.backward};
        MPI_Allreduce
        (
            MPI_IN_PLACE, both, 2, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD
        );
        sum = {both[0], both[1]};
    }
    return sums;
}


//- Whole random numbers from 0 to n - 1
class dice
{
    std::mt19937 numbers_;

public:

    explicit dice(unsigned seed)
    :
        numbers_(seed)
    {}

    int operator()(int n)
    {
        return int(numbers_() % unsigned(n));
    }
};


engineSettings settings(const std::string& integrator, double thermalEnergy)
{
    engineSettings chosen;
    chosen.cutOff = 1;
    chosen.spacing = 0.5;
    chosen.integrator = integrator;
    chosen.thermalEnergy = thermalEnergy;
    chosen.thermalStep = 0.1;
    return chosen;
}

} // End namespace


TEST(passages, throughAClosedSurfaceAddUpToWhatIsInside)
{
    const std::vector<countedSurface> surfaces
    {
        cuboid({0, 0, 0}, {1, 1, 1}, 1),
        cuboid({0, 0, 0}, {1, 1, 1}, 4),
        octahedron({0.5, 0.5, 0.5}, 0.5)
    };
    const auto isIn = [](std::size_t i, const vector& x)
    {
        const vector r((x - vector(0.5, 0.5, 0.5)).cwiseAbs());
        return (i < 2 ? r.maxCoeff() : r.sum()) < 0.5;
    };

    surfaceCounters counters(surfaces, periodicBox(), 1);
    dice random(1);
    int wentIn = 0;

    for (int way = 0; way < 3000; ++way)
    {
        // Begins and ends apart from all surfaces, and is on them in between
        const auto apart = [&]
        {
            return vector
            (
                (random(12) - 3.5)/8 + 1/64.0,
                (random(12) - 3.5)/8 + 1/256.0,
                (random(12) - 3.5)/8 + 1/1024.0
            );
        };
        const vector start(apart());
        const vector end(apart());
        vector x(start);
        counters.clear();

        for (int step = random(12); step >= 0; --step)
        {
            const vector next
            (
                step == 0
              ? end
              : vector(random(9) - 2, random(9) - 2, random(9) - 2)/4
            );
            counters.count(x, next - x, next);
            x = next;
        }
        for (std::size_t i = 0; i < surfaces.size(); ++i)
        {
            ASSERT_EQ
            (
                net(counters.counted()[i]), isIn(i, start) - isIn(i, end)
            ) << way << ' ' << i;
            wentIn += isIn(i, end) && !isIn(i, start);
        }
    }
    EXPECT_GT(wentIn, 500);
}


TEST(passages, throughAnEdgeOrACornerAreCountedOnce)
{
    // 4 by 4 squares of two triangles: corners at the quarters
    surfaceCounters counters
    (
        {sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4)}, periodicBox(), 1
    );
    for (int i = 1; i < 32; ++i)
    {
        for (int j = 1; j < 32; ++j)
        {
            const vector at(i/32.0, j/32.0, 0);
            for (const double slant : {0.0, 0.25, -0.125})
            {
                const vector half(slant, 0.5*slant, 0.25);

                counters.clear();
                counters.count(at - half, 2*half, at + half);
                EXPECT_EQ(counters.counted()[0].forward, 1) << at.transpose();
                EXPECT_EQ(counters.counted()[0].backward, 0);

                // To the sheet, along it, and on
                const vector along(0, (j < 16 ? 1 : -1)/4.0, 0);
                counters.clear();
                counters.count(at + half, -half, at);
                counters.count(at, along, at + along);
                counters.count(at + along, -half, at + along - half);
                EXPECT_EQ(counters.counted()[0].forward, 0);
                EXPECT_EQ(counters.counted()[0].backward, 1) << at.transpose();
            }
        }
    }

    // Beside it, and in front
    counters.clear();
    counters.count({1.25, 0.5, -1}, {0, 0, 2}, {1.25, 0.5, 1});
    counters.count({0.5, 0.5, 0.1}, {0, 0, 0.8}, {0.5, 0.5, 0.9});
    EXPECT_EQ(counters.counted()[0].forward, 0);
    EXPECT_EQ(counters.counted()[0].backward, 0);
}


TEST(passages, roundAPeriodicBoxAreCountedOnce)
{
    // A width whose parts have no exact numbers. Sheets across it: within, at the
    // seam, and a body around the corner of the box, where eight images meet
    periodicBox space(cube(1));
    space.lower.setConstant(-0.3);
    space.upper.setConstant(0.9);
    const double edge = space.period(0);
    const auto at = [&](int i, int of)
    {
        return i == of ? space.upper[0] : space.lower[0] + edge*i/of;
    };

    const auto across = [&](int axis, int i)
    {
        vector origin(space.lower);
        vector a(vector::Zero()), b(vector::Zero());
        origin[axis] = at(i, 8);
        a[(axis + 1) % 3] = edge;
        b[(axis + 2) % 3] = edge;
        return sheet(origin, a, b, 2);
    };
    const std::vector<countedSurface> surfaces
    {
        across(0, 3), across(1, 0), across(2, 8),
        octahedron(space.upper, edge/4)
    };
    surfaceCounters counters(surfaces, space, 0.1*edge);

    dice random(2);
    std::int64_t counted = 0;
    for (int way = 0; way < 2000; ++way)
    {
        counters.clear();

        // In 64ths of the period, at odd ones at the begin and the end
        std::array<int, 3> place, start;
        for (int axis = 0; axis < 3; ++axis)
        {
            start[axis] = place[axis] = 2*random(32) + 1;
        }
        const auto position = [&]
        {
            vector x;
            for (int axis = 0; axis < 3; ++axis)
            {
                const int rest = ((place[axis] % 64) + 64) % 64;
                x[axis] = at(rest, 64);
            }
            return x;
        };

        vector x(position());
        for (int step = random(30); step >= 0; --step)
        {
            vector d;
            for (int axis = 0; axis < 3; ++axis)
            {
                int move = 8*(random(7) - 3);
                if (step == 0)
                {
                    move += 2*random(4) + 1;
                }
                // To the lattice of eighths after the first step
                move -= (place[axis] + 640) % 8;
                place[axis] += move;
                d[axis] = edge*move/64;
            }

            // Stored inside, or not yet
            const vector next(random(2) ? position() : vector(x + d));
            counters.count(x, d, next);
            x = next;
            space.wrap(x);
        }

        // How often the surface's images were passed
        const auto passed = [&](int axis, int i)
        {
            const auto images = [&](int p)
            {
                return std::int64_t(std::floor((p - 8*i)/64.0));
            };
            return images(place[axis]) - images(start[axis]);
        };
        ASSERT_EQ(net(counters.counted()[0]), passed(0, 3)) << way;
        ASSERT_EQ(net(counters.counted()[1]), passed(1, 0)) << way;
        ASSERT_EQ(net(counters.counted()[2]), passed(2, 8)) << way;
        counted += counters.counted()[2].forward;

        const auto isIn = [](const std::array<int, 3>& p)
        {
            int sum = 0;
            for (const int c : p)
            {
                const int rest = ((c % 64) + 64) % 64;
                sum += std::min(rest, 64 - rest);
            }
            return sum < 16;
        };
        ASSERT_EQ(net(counters.counted()[3]), isIn(start) - isIn(place)) << way;
    }
    EXPECT_GT(counted, 1000);
}


TEST(passages, throughTheEngineAddUpWithEachIntegrator)
{
    const periodicBox space(cube(3));
    const int n = 400;
    const double plane = 1.1;
    const vector centre(0.2, 1.5, 2.9);
    const double radius = 0.7;

    const auto isIn = [&](const vector& x)
    {
        vector r(x - centre);
        for (int axis = 0; axis < 3; ++axis)
        {
            r[axis] -= 3*std::round(r[axis]/3);
        }
        return r.cwiseAbs().sum() < radius;
    };

    for
    (
        const auto& [name, thermalEnergy]
      : std::map<std::string, double>
        {
            {"Euler", 0}, {"AdamsBashforth2", 0}, {"RKC2", 0},
            {"BogackiShampine", 0}, {"LeimkuhlerMatthews", 0.5}
        }
    )
    {
        platelets all(scatter(n, space.upper));
        for (int k = 0; k < n; ++k)
        {
            // Round the box in different ways
            all.waterVelocity[k] = vector(2, k % 3 - 1, 1);
        }
        const auto began = all.position;

        engine system
        (
            space, {}, std::make_shared<repulsion>(2),
            settings(name, thermalEnergy), MPI_COMM_WORLD
        );
        system.load(share(all, sharing::dealt));
        system.setCountedSurfaces
        ({
            sheet({plane, 0, 0}, {0, 3, 0}, {0, 0, 3}),
            octahedron(centre, radius)
        });

        std::vector<std::int64_t> through(2);
        std::int64_t backward = 0;
        std::vector<vector> periods(n, vector::Zero());
        for (int part = 0; part < 12; ++part)
        {
            system.advance(0.4);

            const auto counted = ofAllRanks(system.counted());
            for (int i = 0; i < 2; ++i)
            {
                through[i] += net(counted[i]);
            }
            backward += counted[1].backward;

            std::vector<vector> wrapped;
            for (const auto& crossings : system.local().crossings)
            {
                wrapped.emplace_back(crossings[0], crossings[1], crossings[2]);
            }
            const auto crossed = gather(system.local(), wrapped, n);
            for (int k = 0; k < n; ++k)
            {
                periods[k] += crossed[k];
            }

            // As after a restart, in another order
            if (part % 3 == 1)
            {
                platelets again(system.local());
                std::vector<int> order;
                for (int k = int(again.size()) - 1; k >= 0; --k)
                {
                    order.push_back(k);
                }
                again.reorder(order);
                system.load(again);
            }
            system.clearCrossings();
        }

        const auto ended = gather(system.local(), system.local().position, n);
        std::int64_t passed = 0;
        std::int64_t left = 0;
        for (int k = 0; k < n; ++k)
        {
            passed +=
                std::int64_t(std::floor((ended[k][0] - plane)/3) + periods[k][0])
              - std::int64_t(std::floor((began[k][0] - plane)/3));
            left += isIn(began[k]) - isIn(ended[k]);
        }
        EXPECT_EQ(through[0], passed) << name;
        EXPECT_EQ(through[1], left) << name;

        // There was something to count: 3.2 rounds
        EXPECT_GT(passed, 3*n) << name;
        EXPECT_GT(backward, 100) << name;
    }
}


TEST(passages, areThoseOfTheWayThatIsReflectedOrAbsorbed)
{
    // Down to the floor at z = 0 and up again from x = 0.5: at x = 0.7 it is at
    // a height of 0.12, its ends are at 0.3
    for (const action does : {action::reflect, action::absorb})
    {
        for (const char* name : {"Euler", "BogackiShampine"})
        {
            boundarySurface floor;
            addSheet(floor, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, does, 2);

            auto chosen = settings(name, 0);
            chosen.cutOff = 2;
            chosen.deltaT = 1;
            engine system
            (
                periodicBox(), floor, std::make_shared<noForce>(), chosen,
                MPI_COMM_WORLD
            );
            platelets one;
            if (myRank() == 0)
            {
                one.append(1, {0, 0, 0.3});
                one.tag[0] = 0;
                one.waterVelocity[0] = vector(1, 0, -0.6);
            }
            system.load(one);

            const vector side(0, 2, 0);
            const auto standing = [&](double x, double from, double to)
            {
                return sheet({x, -1, from}, side, {0, 0, to - from});
            };
            system.setCountedSurfaces
            ({
                standing(0.7, 0, 0.2), standing(0.7, 0.2, 1),
                standing(0.3, 0, 0.2), standing(0.3, 0.2, 1)
            });
            system.advance(1);

            const auto counted = ofAllRanks(system.counted());
            EXPECT_EQ(net(counted[0]), does == action::reflect) << name;
            EXPECT_EQ(net(counted[1]), 0) << name;
            EXPECT_EQ(net(counted[2]), 1) << name;
            EXPECT_EQ(net(counted[3]), 0) << name;

            // Only those of the last call
            system.advance(0);
            EXPECT_EQ(net(ofAllRanks(system.counted())[2]), 0) << name;
        }
    }
}
