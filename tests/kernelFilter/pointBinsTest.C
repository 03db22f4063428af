/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointBins.H"

#include <gtest/gtest.h>

#include <random>

using namespace Foam;

namespace
{

pointField randomPoints(const label count, const vector& size)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<> uniform;

    pointField points(count);
    for (point& p : points)
    {
        for (direction axis = 0; axis < 3; ++axis)
        {
            p[axis] = size[axis]*uniform(random);
        }
    }
    return points;
}


//- How often each point was visited
labelList visits(const pointBins& bins, const point& p, const scalar radius)
{
    labelList count(bins.order().size(), 0);
    bins.forRows(p, radius, [&](const label begin, const label end)
    {
        for (label i = begin; i < end; ++i)
        {
            ++count[bins.order()[i]];
        }
    });
    return count;
}

} // End anonymous namespace


TEST(pointBins, findAllPointsWithinTheRadiusOnce)
{
    const vector size(1e-6, 3e-7, 2e-6);
    const pointField points(randomPoints(3000, size));
    // Within, at the edge and outside of the box; radii below and above a bin
    for (const scalar radius : {2e-8, 1e-7, 5e-7})
    {
        const pointBins bins(points, 1e-7);
        for (const point& p : randomPoints(50, 1.3*size))
        {
            const labelList count(visits(bins, p, radius));
            forAll(points, i)
            {
                EXPECT_LE(count[i], 1);
                if (mag(points[i] - p) < radius)
                {
                    EXPECT_EQ(count[i], 1);
                }
            }
        }
    }
}


TEST(pointBins, visitFewPointsBeyondTheRadius)
{
    const pointField points(randomPoints(100000, vector::one));
    const scalar radius = 0.2;
    const pointBins bins(points, radius/2);
    const point middle(0.5*vector::one);

    label within = 0;
    for (const point& p : points)
    {
        within += mag(p - middle) < radius;
    }
    EXPECT_LT(sum(visits(bins, middle, radius)), 2*within);
}


TEST(pointBins, takePointsOnALatticeAndFarApart)
{
    // On the faces of bins
    pointField points(1000);
    forAll(points, i)
    {
        points[i] = 0.1*vector(i%10, i/10%10, i/100);
    }
    // One so far that bins of the width would not fit into memory
    points.append(1e9*vector::one);

    const pointBins bins(points, 0.2);
    forAll(points, i)
    {
        EXPECT_EQ(visits(bins, points[i], 0.05)[i], 1);
    }
}


TEST(pointBins, takeNoPoints)
{
    const pointBins bins(pointField(), 0.1);
    EXPECT_TRUE(visits(bins, point(Zero), 1).empty());
}


TEST(pointBins, takePointsInAPlane)
{
    const pointField points(randomPoints(500, vector(1, 1, 0)));
    const pointBins bins(points, 0.1);
    forAll(points, i)
    {
        EXPECT_EQ(visits(bins, points[i], 0.1)[i], 1);
    }
}
