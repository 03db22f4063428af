/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The bound of the stiffness against the eigenvalues of the Jacobian.
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"

#include <Eigen/Eigenvalues>

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


//- Fastest rate of decay by central differences of the double sum
double fastestDecay
(
    const platelets& all,
    const periodicBox& space,
    const gapForce& law
)
{
    const int n = int(all.size());
    Eigen::MatrixXd jacobian(3*n, 3*n);
    const double step = 1e-5;

    for (int column = 0; column < 3*n; ++column)
    {
        platelets moved(all);
        moved.position[column/3][column%3] += step;
        const auto plus = doubleSum(moved, space, law, settings());
        moved.position[column/3][column%3] -= 2*step;
        const auto minus = doubleSum(moved, space, law, settings());

        for (int row = 0; row < 3*n; ++row)
        {
            // Symmetric form: friction on either side
            jacobian(row, column) =
                (plus[row/3] - minus[row/3])[row%3]/(2*step)
               /std::sqrt(all.friction[row/3]*all.friction[column/3]);
        }
    }
    const Eigen::MatrixXd symmetric
    (
        0.5*(jacobian + jacobian.transpose())
    );

    return
       -Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>
        (
            symmetric, Eigen::EigenvaluesOnly
        ).eigenvalues()[0];
}


double bound
(
    const platelets& all,
    const periodicBox& space,
    std::shared_ptr<const gapForce> law
)
{
    engine system(space, {}, std::move(law), settings(), MPI_COMM_WORLD);
    system.load(share(all, sharing::dealt));
    return system.stiffness();
}

} // End namespace


TEST(stiffness, boundsTheFastestDecayByAtMostTwice)
{
    for (const unsigned seed : {1, 2, 3})
    {
        const periodicBox space(cube(2.5, true, true, false));
        const platelets all(scatter(20, vector(2.5, 2.5, 2.5), seed));

        for (const auto& law :
            {
                std::shared_ptr<const gapForce>(new repulsion(6)),
                std::shared_ptr<const gapForce>(new mixedForce)
            })
        {
            const double exact = fastestDecay(all, space, *law);
            const double bounded = bound(all, space, law);

            // Differences of the double sum to 1e-8
            EXPECT_GE(bounded, exact*(1 - 1e-7));
            EXPECT_LE(bounded, 2*exact);
        }
    }
}


TEST(stiffness, isTheSameWithAllInstructions)
{
    const periodicBox space(cube(6, true, true, false));
    const platelets all(scatter(400, vector(6, 6, 6)));
    const auto law = std::make_shared<repulsion>(6);

    auto chosen = settings();
    double first = -1;
    for (const std::string& instructions : allInstructions())
    {
        chosen.instructions = instructions;
        engine system(space, {}, law, chosen, MPI_COMM_WORLD);
        system.load(share(all, sharing::dealt));
        const double found = system.stiffness();

        first = first < 0 ? found : first;
        EXPECT_NEAR(found/first, 1, 1e-12) << instructions;
    }
    EXPECT_GT(first, 1);
}


TEST(stiffness, isExactBetweenHeldPlatelets)
{
    // A wall and a fixed platelet do not move: F'/xi of each
    boundarySurface wall;
    addSheet
    (
        wall, vector(0, -5, -5), vector(0, 10, 0), vector(0, 0, 10),
        action::platelet
    );

    platelets all;
    all.append(0, vector(0.4, 0, 0));
    all.append(1, vector(1.0, 0, 0));
    all.friction[0] = 2.5;
    all.fixed[1] = 1;

    const auto law = std::make_shared<repulsion>();
    engine system(periodicBox(), wall, law, settings(), MPI_COMM_WORLD);
    system.load(share(all, sharing::dealt));

    EXPECT_NEAR
    (
        system.stiffness(),
        -(law->slope(0.35) + law->slope(0.5))/2.5,
        1e-13
    );
}


TEST(stiffness, isThatOfTheSpringsAmidFixedPlatelets)
{
    // In general directions, with each coupling of two axes the strongest once
    const auto law = std::make_shared<repulsion>(6);
    const vector diagonals[] =
        {vector(1, 0.9, 0.2), vector(0.9, -0.2, -1), vector(0.1, 1, 0.8)};

    for (const vector& diagonal : diagonals)
    {
        platelets all;
        all.append(0, vector::Zero());
        all.append(1, 0.5*diagonal.normalized());
        all.append(2, -0.55*diagonal.normalized());
        all.append(3, 0.7*vector(0.3, -0.5, 0.9).normalized());
        all.fixed = {0, 1, 1, 1};
        all.friction[0] = 1.7;

        Eigen::Matrix3d springs(Eigen::Matrix3d::Zero());
        for (int j = 1; j < 4; ++j)
        {
            const vector& d = all.position[j];
            const double gap = d.norm() - settings().thickness;

            // Repelled: held along, not across
            ASSERT_GT(law->force(gap), 0);
            springs -= law->slope(gap)*d*d.transpose()/d.squaredNorm();
        }

        engine system(periodicBox(), {}, law, settings(), MPI_COMM_WORLD);
        system.load(share(all, sharing::dealt));

        const double largest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>
        (
            springs, Eigen::EigenvaluesOnly
        ).eigenvalues()[2];
        EXPECT_NEAR(system.stiffness()/(largest/1.7), 1, 1e-12);
    }
}


TEST(stiffness, countsWhatAttractionHoldsSideways)
{
    // Attracted from either side along x, more weakly the nearer: along x that
    // does not hold, across it does, each with -F/r
    platelets all;
    all.append(0, vector(0, 0, 0));
    all.append(1, vector(1.7, 0, 0));
    all.append(2, vector(-1.7, 0, 0));
    all.fixed = {0, 1, 1};

    auto chosen = settings();
    chosen.cutOff = 3;
    const auto law = std::make_shared<mixedForce>();
    ASSERT_GT(law->slope(1.6), 0);

    engine system(periodicBox(), {}, law, chosen, MPI_COMM_WORLD);
    system.load(share(all, sharing::dealt));

    EXPECT_NEAR(system.stiffness(), -2*law->force(1.6)/1.7, 1e-14);
}
