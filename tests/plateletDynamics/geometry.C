/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Triangles, trees of boxes and welded points against plain searches.
\*---------------------------------------------------------------------------*/

#include "boxTree.H"
#include "surfaceTriangle.H"
#include "testSystems.H"
#include "vertexWeld.H"

#include <gtest/gtest.h>

using plateletDynamics::bounds;
using plateletDynamics::boxTree;
using plateletDynamics::surfaceTriangle;
using plateletDynamics::vertexWeld;

TEST(surfaceTriangle, findsItsNearestPoint)
{
    const std::vector<vector> points(scatter(400, vector(3, 3, 3)).position);
    const std::vector<surfaceTriangle> triangles
    {
        surfaceTriangle({vector(1, 1, 1), vector(2, 1, 1), vector(1, 2, 1)}),
        // Obtuse
        surfaceTriangle({vector(1, 1, 1), vector(2.5, 1, 1), vector(0, 1.2, 2)})
    };

    for (const surfaceTriangle& t : triangles)
    {
        for (const vector& x : points)
        {
            // Sampled at 45 000 points
            double sampled = 1e300;
            const int n = 300;
            for (int i = 0; i <= n; ++i)
            {
                for (int j = 0; i + j <= n; ++j)
                {
                    const vector p
                    (
                        t.corners[0]
                      + (t.corners[1] - t.corners[0])*i/n
                      + (t.corners[2] - t.corners[0])*j/n
                    );
                    sampled = std::min(sampled, (x - p).norm());
                }
            }

            const surfaceTriangle::foot foot(t.nearest(x));
            const double distance = (foot.point - x).norm();

            // Samples are up to 0.005 from the foot: at distances above 0.05
            // that is 0.005^2/(2 0.05) longer at most
            EXPECT_LE(distance, sampled + 1e-14);
            EXPECT_GE(distance, sampled - (distance > 0.05 ? 3e-4 : 5e-3));
            EXPECT_TRUE(t.contains(foot.point, 1e-12));

            if (foot.feature == surfaceTriangle::foot::face)
            {
                EXPECT_NEAR(distance, std::abs(t.height(x)), 1e-14);
            }
        }
    }
}


TEST(surfaceTriangle, tellsWhichLinesPassThroughIt)
{
    const surfaceTriangle t
    (
        {vector(0, 0, 0), vector(1, 0, 0), vector(0, 1, 0)}
    );

    EXPECT_TRUE(t.between(vector(0.2, 0.2, 1), vector(0.3, 0.3, -1)));
    EXPECT_TRUE(t.between(vector(0.2, 0.2, -1), vector(0.3, 0.3, 1)));
    EXPECT_FALSE(t.between(vector(0.2, 0.2, 1), vector(0.3, 0.3, 0.1)));
    EXPECT_FALSE(t.between(vector(0.6, 0.6, 1), vector(0.6, 0.6, -1)));

    // On an edge, and ending on the triangle
    EXPECT_TRUE(t.between(vector(0.5, 0.5, 1), vector(0.5, 0.5, -1)));
    EXPECT_FALSE(t.between(vector(0.2, 0.2, 1), vector(0.2, 0.2, 0)));
}


TEST(boxTree, findsWhatAPlainSearchFinds)
{
    const std::vector<vector> corner(scatter(300, vector(5, 5, 5), 3).position);
    const std::vector<vector> probe(scatter(50, vector(6, 6, 6), 4).position);

    std::vector<bounds> all(corner.size());
    for (std::size_t i = 0; i < corner.size(); ++i)
    {
        all[i].include(corner[i]);
        all[i].include(corner[i] + vector(0.1, 0.5*(i % 2), 0.2));
    }
    const boxTree tree(all);

    for (const vector& x : probe)
    {
        std::vector<int> found;
        const double reach = 1.2;
        tree.near(x, reach, [&](int i) { found.push_back(i); });
        std::sort(found.begin(), found.end());

        bounds around;
        around.include(x);
        std::vector<int> overlapping;
        tree.near(around, 1, [&](int i) { overlapping.push_back(i); });
        std::sort(overlapping.begin(), overlapping.end());

        std::vector<int> expected;
        std::vector<int> expectedOverlapping;
        for (std::size_t i = 0; i < all.size(); ++i)
        {
            const vector outside
            (
                x - x.cwiseMax(all[i].lower).cwiseMin(all[i].upper)
            );
            if (outside.squaredNorm() <= reach)
            {
                expected.push_back(int(i));
            }
            if (outside.cwiseAbs().maxCoeff() <= 1)
            {
                expectedOverlapping.push_back(int(i));
            }
        }
        EXPECT_EQ(found, expected);
        EXPECT_EQ(overlapping, expectedOverlapping);
    }
}


TEST(vertexWeld, joinsPointsThatDifferByRounding)
{
    std::vector<vector> points(scatter(100, vector(1, 1, 1)).position);
    std::vector<double> tolerance(100, 1e-6);

    // Each again nearby, and one too far for its own tolerance
    for (int i = 0; i < 100; ++i)
    {
        points.push_back(points[i] + vector(3e-7, -2e-7, 1e-7));
        tolerance.push_back(1e-6);
    }
    tolerance[150] = 1e-7;

    const std::vector<int> number(vertexWeld(points, tolerance));
    for (int i = 0; i < 100; ++i)
    {
        EXPECT_EQ(number[i] == number[100 + i], i != 50);
        for (int j = 0; j < i; ++j)
        {
            EXPECT_NE(number[i], number[j]);
        }
    }
}
