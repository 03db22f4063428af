/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Net forces against a plain double sum, on any number of ranks.
\*---------------------------------------------------------------------------*/

#include "testSystems.H"

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
    const box& space,
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
