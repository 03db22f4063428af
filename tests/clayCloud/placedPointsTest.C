/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxMesh.H"
#include "placedPoints.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace Foam;

namespace
{

const vector size(1e-6, 7e-7, 5e-7);


//- All pairs: distances up to the reach of the points and their images from x
std::vector<scalar> plainNear
(
    const std::vector<point>& points,
    const std::array<bool, 3>& periodic,
    const scalar reach,
    const point& x
)
{
    std::vector<scalar> distances;
    for (const point& p : points)
    {
        for (label i = -periodic[0]; i <= label(periodic[0]); ++i)
        {
            for (label j = -periodic[1]; j <= label(periodic[1]); ++j)
            {
                for (label k = -periodic[2]; k <= label(periodic[2]); ++k)
                {
                    const vector image(i*size.x(), j*size.y(), k*size.z());
                    const scalar distance = mag(x - p - image);
                    if (distance < reach)
                    {
                        distances.push_back(distance);
                    }
                }
            }
        }
    }
    std::sort(distances.begin(), distances.end());
    return distances;
}


//- Points in a box, and before and behind it where it is not periodic, looked at
//  after each that is put in; how many were near
label comparePlaced(const std::array<bool, 3>& periodic, const scalar reach)
{
    boxSettings box;
    box.n = {{4, 4, 4}};
    box.size = size;
    box.periodic = periodic;
    const boxMesh made(box);
    const periodicAxes axes(made.mesh());

    placedPoints placed(axes, reach);
    std::vector<point> points;
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto somewhere = [&]
    {
        point p;
        for (direction axis = 0; axis < 3; ++axis)
        {
            p[axis] =
                size[axis]
               *(periodic[axis] ? uniform(engine) : 3*uniform(engine) - 1);
        }
        return p;
    };

    label near = 0;
    for (label n = 0; n < 300; ++n)
    {
        const point x(somewhere());
        const auto expected = plainNear(points, periodic, reach, x);

        std::vector<scalar> found;
        placed.forNear(x, [&](const vector& d){ found.push_back(mag(d)); });
        std::sort(found.begin(), found.end());

        EXPECT_EQ(found.size(), expected.size()) << "at " << n;
        for (std::size_t i = 0; i < min(found.size(), expected.size()); ++i)
        {
            EXPECT_NEAR(found[i], expected[i], 1e-20);
        }
        const scalar nearest = expected.empty() ? reach : expected[0];
        EXPECT_NEAR(placed.nearest(x, 0), nearest, 1e-20);

        // Not where it need not be known
        for (const scalar enough : {0.3*reach, reach})
        {
            if (nearest < enough)
            {
                EXPECT_LT(placed.nearest(x, enough), enough);
            }
            else
            {
                EXPECT_NEAR(placed.nearest(x, enough), nearest, 1e-20);
            }
        }
        near += expected.size();

        points.push_back(x);
        placed.add(x);
    }
    return near;
}

} // End anonymous namespace


TEST(placedPoints, areThoseOfAllPairs)
{
    EXPECT_GT(comparePlaced({{false, false, false}}, 2e-7), 50);
}


TEST(placedPoints, areNearAcrossPeriodicBoundaries)
{
    EXPECT_GT(comparePlaced({{true, false, true}}, 1.3e-7), 50);
    EXPECT_GT(comparePlaced({{true, true, true}}, 1.3e-7), 50);
}


TEST(placedPoints, areNearTwiceWhereThePeriodIsTheReach)
{
    EXPECT_GT(comparePlaced({{true, false, true}}, 5e-7), 1000);
}


TEST(placedPoints, pointAwayFromThePoint)
{
    const boxMesh made{boxSettings()};
    const periodicAxes axes(made.mesh());
    placedPoints placed(axes, 0.5);
    placed.add(point(0.1, 0.2, 0.3));

    vector away(Zero);
    placed.forNear(point(0.2, 0.2, 0.1), [&](const vector& d){ away += d; });

    EXPECT_NEAR(mag(away - vector(0.1, 0, -0.2)), 0, 1e-15);
}
