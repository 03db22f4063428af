/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Net forces against a plain double sum, on any number of ranks.
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"

#include <gtest/gtest.h>

namespace
{

engineSettings exactSettings()
{
    engineSettings settings;
    settings.thickness = 0.1;
    settings.cutOff = 1;
    settings.pairKernel = engineSettings::kernel::exact;
    return settings;
}


//- Largest difference from the double sum over the largest force
double netForceError
(
    const platelets& all,
    const periodicBox& space,
    const engineSettings& settings,
    sharing how
)
{
    const auto law = std::make_shared<mixedForce>();

    engine system(space, {}, law, settings, MPI_COMM_WORLD);
    system.load(share(all, how));
    system.evaluate();

    const std::vector<vector> expected(doubleSum(all, space, *law, settings));

    return
        largestDifference
        (
            gather(system.local(), system.local().force, all.size()), expected
        )
       /largest(expected);
}

} // End namespace


// 1e-12: a sum of some hundred terms in another order

TEST(netForce, isTheDoubleSumInAnOpenBox)
{
    const platelets all(scatter(300, vector(4, 3, 2)));

    for (const sharing how : {sharing::slabs, sharing::dealt})
    {
        EXPECT_LT
        (
            netForceError
            (
                all, cube(4, false, false, false), exactSettings(), how
            ),
            1e-12
        );
    }
}


TEST(netForce, isTheDoubleSumInAPeriodicBox)
{
    const platelets all(scatter(300, vector(3.3, 3.3, 3.3)));

    for (const sharing how : {sharing::slabs, sharing::dealt})
    {
        EXPECT_LT
        (
            netForceError(all, cube(3.3), exactSettings(), how), 1e-12
        );
    }
}


TEST(netForce, isTheDoubleSumInABoxOfTwoCutOffs)
{
    for (const double edge : {2.0, 2.1})
    {
        const platelets all(scatter(120, vector::Constant(edge)));

        EXPECT_LT
        (
            netForceError(all, cube(edge), exactSettings(), sharing::slabs),
            1e-12
        );
    }
}


TEST(netForce, isTheDoubleSumWhereOneAxisIsPeriodic)
{
    const platelets all(scatter(300, vector(4, 2.5, 2)));

    EXPECT_LT
    (
        netForceError
        (
            all, cube(2.5, false, true, false), exactSettings(), sharing::slabs
        ),
        1e-12
    );
}


TEST(netForce, isTheDoubleSumBetweenWalls)
{
    // A periodic slit and a pore that is open along x, the walls in 98 parts
    const platelets all(scatter(300, vector(3, 3, 2)));

    for (const bool pore : {false, true})
    {
        const periodicBox space(cube(3, !pore, !pore, false));
        const vector x(3, 0, 0);
        const vector y(0, 3, 0);
        const vector z(0, 0, 2);

        boundarySurface walls;
        addSheet(walls, vector(0, 0, 0), x, y, action::platelet, 7);
        addSheet(walls, z, y, x, action::platelet, 7);
        if (pore)
        {
            addSheet(walls, vector(0, 0, 0), z, x, action::platelet, 7);
            addSheet(walls, y, x, z, action::platelet, 7);
        }

        const engineSettings settings(exactSettings());
        const mixedForce law;

        // A wall at a distance acts as a platelet at the same gap
        std::vector<vector> expected(doubleSum(all, space, law, settings));
        const auto push = [&](double distance)
        {
            return
                pairForce(law, settings, distance + settings.thickness/2);
        };
        for (std::size_t k = 0; k < all.size(); ++k)
        {
            const vector& at = all.position[k];
            expected[k][2] += push(at[2]) - push(2 - at[2]);
            if (pore)
            {
                expected[k][1] += push(at[1]) - push(3 - at[1]);
            }
        }

        for (const sharing how : {sharing::slabs, sharing::dealt})
        {
            engine system
            (
                space, walls, std::make_shared<mixedForce>(), settings,
                MPI_COMM_WORLD
            );
            system.load(share(all, how));
            system.evaluate();

            EXPECT_LT
            (
                largestDifference
                (
                    gather(system.local(), system.local().force, all.size()),
                    expected
                ),
                1e-12*largest(expected)
            );
        }
    }
}
