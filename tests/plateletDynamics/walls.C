/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Forces of walls that act as platelets.
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
double planeForce(double distance)
{
    return pairForce(mixedForce(), settings(), distance + 0.05);
}


const periodicBox openSpace;

} // End namespace


TEST(walls, actAsAPlateletAtTheSameGap)
{
    boundarySurface floor;
    addSheet
    (
        floor, vector(-5, -5, 0), vector(10, 0, 0), vector(0, 10, 0),
        action::platelet
    );

    const std::vector<double> heights{0.01, 0.06, 0.5, 0.88, 0.94, 0.96};
    std::vector<vector> places;
    for (const double height : heights)
    {
        places.push_back(vector(0.3, 0.2, height));
    }

    const auto force =
        wallForcesAt(places, openSpace, floor, mixedForce(), settings());

    for (std::size_t k = 0; k < places.size(); ++k)
    {
        // Rounding of the height
        const vector expected(0, 0, planeForce(heights[k]));
        EXPECT_LT((force[k] - expected).norm(), 1e-14) << heights[k];
    }
}


TEST(walls, pushAPlateletBehindThemBackToTheWater)
{
    boundarySurface floor;
    addSheet
    (
        floor, vector(-5, -5, 0), vector(10, 0, 0), vector(0, 10, 0),
        action::platelet, 3
    );

    const auto force = wallForcesAt
    (
        {vector(0.3, 0.2, -0.02), vector(0.3, 0.2, 0)},
        openSpace, floor, mixedForce(), settings()
    );

    EXPECT_LT((force[0] - vector(0, 0, planeForce(-0.02))).norm(), 1e-14);
    EXPECT_LT((force[1] - vector(0, 0, planeForce(0))).norm(), 1e-14);
}


TEST(walls, actOnceHoweverTheyAreDivided)
{
    const auto forces = [](int n, action otherHalf)
    {
        boundarySurface floor;
        addSheet
        (
            floor, vector(-2, -2, 0.3), vector(2, 0, 0), vector(0, 4, 0),
            action::platelet, n, 1
        );
        addSheet
        (
            floor, vector(0, -2, 0.3), vector(2, 0, 0), vector(0, 4, 0),
            otherHalf, n, 2
        );
        std::vector<vector> places;
        for (int k = 0; k < 40; ++k)
        {
            // Over edges and corners of the division too
            places.push_back(vector(-1 + k*0.05, -1 + k*0.04, 0.4 + 0.01*k));
        }
        return
            wallForcesAt(places, openSpace, floor, mixedForce(), settings());
    };

    const auto whole = forces(1, action::platelet);
    const auto divided = forces(10, action::platelet);

    EXPECT_GT(largest(whole), 0.1);

    // Rounding of the distance
    EXPECT_LT(largestDifference(whole, divided), 1e-14);
    EXPECT_GT(largestDifference(whole, forces(1, action::absorb)), 0.01);
}


TEST(walls, inACornerActOneByOne)
{
    boundarySurface corner;
    addSheet
    (
        corner, vector(0, 0, 0), vector(3, 0, 0), vector(0, 3, 0),
        action::platelet, 3
    );
    addSheet
    (
        corner, vector(0, 0, 0), vector(0, 3, 0), vector(0, 0, 3),
        action::platelet, 5
    );

    const auto force = wallForcesAt
    (
        {vector(0.2, 1, 0.4), vector(-0.02, 1, -0.03)},
        openSpace, corner, mixedForce(), settings()
    );

    EXPECT_LT
    (
        (force[0] - vector(planeForce(0.2), 0, planeForce(0.4))).norm(), 1e-14
    );

    // In the rock beyond the corner both push towards it
    const double depth = std::hypot(0.02, 0.03);
    const vector back
    (
        2*planeForce(-depth)*vector(0.02, 0, 0.03)/depth
    );
    EXPECT_LT((force[1] - back).norm(), 1e-14);
}


TEST(walls, ofAPeriodicBoxHaveNoSeam)
{
    // A floor as wide as the box: on the seam too it acts as one plane
    const periodicBox space(cube(2.5, true, true, false));
    boundarySurface floor;
    addSheet
    (
        floor, vector(0, 0, 0), vector(2.5, 0, 0), vector(0, 2.5, 0),
        action::platelet, 4
    );

    const auto force = wallForcesAt
    (
        {
            vector(0, 0, 0.5), vector(1e-9, 2.5 - 1e-9, 0.5),
            vector(0.1, 1.2, 0.5), vector(2.4, 2.4, 0.5)
        },
        space, floor, mixedForce(), settings()
    );

    for (const vector& f : force)
    {
        EXPECT_LT((f - vector(0, 0, planeForce(0.5))).norm(), 1e-14);
    }
}


TEST(walls, andTheirImagesAreSeveralWalls)
{
    // A rock in a periodic box, the platelet between it and its image
    const periodicBox space(cube(2.2, true, false, false));
    boundarySurface rock;
    addRock
    (
        rock, vector(0.3, -3, -3), vector(1.9, 3, 3), action::platelet, 2
    );

    const auto force = wallForcesAt
    (
        {vector(0.1, 0.1, 0.2), vector(2.0, 0.1, 0.2)},
        space, rock, mixedForce(), settings()
    );

    const double near = planeForce(0.1);
    const double far = planeForce(0.5);
    EXPECT_LT
    (
        (force[1] - vector(near - far, 0, 0)).norm(), 1e-13
    );
    EXPECT_LT
    (
        (force[0] - vector(planeForce(0.4) - planeForce(0.2), 0, 0)).norm(),
        1e-13
    );
}


TEST(walls, ofASheetOfRockDoNotActThroughIt)
{
    boundarySurface sheet;
    addRock
    (
        sheet, vector(-5, -5, -0.2), vector(5, 5, 0), action::platelet, 6
    );

    const auto force = wallForcesAt
    (
        {vector(0.3, 0.2, 0.3), vector(0.3, 0.2, -0.6)},
        openSpace, sheet, mixedForce(), settings()
    );

    EXPECT_LT((force[0] - vector(0, 0, planeForce(0.3))).norm(), 1e-14);
    EXPECT_LT((force[1] + vector(0, 0, planeForce(0.4))).norm(), 1e-14);
}


TEST(walls, withoutThicknessActOnBothSides)
{
    // A baffle: two walls at the same place, back to back
    boundarySurface baffle;
    addSheet
    (
        baffle, vector(-5, -5, 0), vector(10, 0, 0), vector(0, 10, 0),
        action::platelet, 6
    );
    addSheet
    (
        baffle, vector(-5, -5, 0), vector(0, 10, 0), vector(10, 0, 0),
        action::platelet, 6
    );

    const auto force = wallForcesAt
    (
        {vector(0.3, 0.2, 0.3), vector(0.3, 0.2, -0.4), vector(0.3, 0.2, 0.01)},
        openSpace, baffle, mixedForce(), settings()
    );

    EXPECT_LT((force[0] - vector(0, 0, planeForce(0.3))).norm(), 1e-14);
    EXPECT_LT((force[1] + vector(0, 0, planeForce(0.4))).norm(), 1e-14);
    EXPECT_LT((force[2] - vector(0, 0, planeForce(0.01))).norm(), 1e-14);
}


TEST(walls, nearerThanAPlateletIsThickPushToTheMiddle)
{
    boundarySurface slit;
    addSheet
    (
        slit, vector(-5, -5, 0), vector(10, 0, 0), vector(0, 10, 0),
        action::platelet, 3
    );
    addSheet
    (
        slit, vector(-5, -5, 0.06), vector(0, 10, 0), vector(10, 0, 0),
        action::platelet, 3
    );

    const auto force = wallForcesAt
    (
        {vector(0.3, 0.2, 0.02), vector(0.3, 0.2, 0.03), vector(0.3, 0.2, 0.04)},
        openSpace, slit, mixedForce(), settings()
    );

    const double back = planeForce(0.02) - planeForce(0.04);
    EXPECT_GT(back, 0);
    EXPECT_LT((force[0] - vector(0, 0, back)).norm(), 1e-14);
    EXPECT_LT(force[1].norm(), 1e-14);
    EXPECT_LT((force[2] + vector(0, 0, back)).norm(), 1e-14);
}


TEST(walls, letNoForceOfPairsThrough)
{
    // Two platelets on either side of a thin rock, and two on the same side
    boundarySurface sheet;
    addRock
    (
        sheet, vector(-0.5, -0.5, -0.01), vector(0.5, 0.5, 0.01),
        action::reflect
    );

    platelets all;
    all.append(0, vector(0, 0, 0.3));
    all.append(1, vector(0, 0.1, -0.3));
    all.append(2, vector(0, 0.7, 0.2));
    all.append(3, vector(0, 0.8, -0.2));
    for (int k = 0; k < 4; ++k)
    {
        all.tag[k] = k;
    }

    const auto law = std::make_shared<repulsion>();
    engine system(openSpace, sheet, law, settings(), MPI_COMM_WORLD);
    system.load(share(all, sharing::dealt));
    system.evaluate();
    const auto force = gather(system.local(), system.local().force, 4);

    // 0 and 1 see 2 and 3 respectively, and these see each other
    const auto pair = [&](int i, int j)
    {
        const vector d(all.position[i] - all.position[j]);
        return vector(pairForce(*law, settings(), d.norm())*d/d.norm());
    };

    EXPECT_LT((force[0] - pair(0, 2)).norm(), 1e-14);
    EXPECT_LT((force[1] - pair(1, 3)).norm(), 1e-14);
    EXPECT_LT((force[2] - pair(2, 0) - pair(2, 3)).norm(), 1e-14);
    EXPECT_LT((force[3] - pair(3, 1) - pair(3, 2)).norm(), 1e-14);
}


TEST(walls, ofOneSideLetNoForceOfPairsThrough)
{
    // As beside a layer behind the mesh: only those below are behind it. Far from
    // each other, clusters are of those above or of those below
    boundarySurface sheet;
    addSheet
    (
        sheet, vector(-5, -5, 0), vector(10, 0, 0), vector(0, 10, 0),
        action::reflect, 6
    );
    boundarySurface opening;
    addSheet
    (
        opening, vector(-5, -5, 0), vector(10, 0, 0), vector(0, 10, 0),
        action::absorb, 6
    );

    const auto law = std::make_shared<repulsion>();
    const auto forceOn = [&]
    (
        const boundarySurface& between,
        const std::vector<double>& heights
    )
    {
        platelets all;
        for (const double z : heights)
        {
            for (int i = 0; i < 4; ++i)
            {
                all.append(all.size(), vector(0.1*(i % 2), 0.1*(i/2), z));
                all.tag.back() = int(all.size()) - 1;
            }
        }
        engine system(openSpace, between, law, settings(), MPI_COMM_WORLD);
        system.load(share(all, sharing::dealt));
        system.evaluate();
        return gather(system.local(), system.local().force, int(all.size()));
    };

    // Near to each other they are in clusters together
    for (const double height : {0.43*settings().cutOff, 0.05})
    {
        const auto above = forceOn(sheet, {height});
        const auto both = forceOn(sheet, {height, -height});
        const auto without = forceOn({}, {height, -height});
        const auto open = forceOn(opening, {height, -height});
        EXPECT_GT((without[0] - above[0]).norm(), 1e-3);

        for (int i = 0; i < 4; ++i)
        {
            EXPECT_LT((both[i] - above[i]).norm(), 1e-13);
            EXPECT_LT((both[i + 4] - above[i]).norm(), 1e-13);

            // Where they would be absorbed they act
            EXPECT_LT((open[i] - without[i]).norm(), 1e-13);
        }
    }
}


TEST(change, isAsIfItHadBeenSoFromTheStart)
{
    // A rock whose image is too far away for the first cut-off
    const periodicBox space(cube(4, true, true, false));
    boundarySurface rock;
    addRock
    (
        rock, vector(2.5, 0.5, -1), vector(2.7, 2.5, 3), action::platelet
    );
    const platelets all(scatter(60, vector(0.4, 4, 2)));

    auto wide = settings();
    wide.cutOff = 2;
    const auto soft = std::make_shared<repulsion>(0.5);

    engine fresh(space, rock, soft, wide, MPI_COMM_WORLD);
    fresh.load(share(all));
    fresh.advance(0.2);

    engine changed
    (
        space, rock, std::make_shared<repulsion>(), settings(), MPI_COMM_WORLD
    );
    changed.load(share(all));
    changed.evaluate();
    const auto before = gather(changed.local(), changed.local().force, 60);

    changed.change(soft, wide);
    changed.advance(0.2);

    EXPECT_EQ(fresh.skin(), changed.skin());
    const auto expected = gather(fresh.local(), fresh.local().position, 60);
    const auto found = gather(changed.local(), changed.local().position, 60);
    EXPECT_EQ(largestDifference(expected, found), 0);
    EXPECT_GT
    (
        largestDifference
        (
            before, gather(changed.local(), changed.local().force, 60)
        ),
        0.1
    );

    wide.cutOff = 2.01;
    EXPECT_THROW(changed.change(soft, wide), userError);
}
