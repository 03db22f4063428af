/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Net forces against a plain double sum, on any number of ranks, of every
    kernel on every set of vector instructions that the processor has.
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"

#include "vectorLoops.H"

#include <gtest/gtest.h>

namespace
{

//- A kernel, and the error of net forces over the largest that it may have
struct choice
{
    engineSettings::kernel kernel;
    std::string instructions;
    double bound;
};


//- 1e-12: a sum of some hundred terms in another order. Tables: a tolerance of
//  1e-5 for each pair, of which the largest do not add up
std::vector<choice> allChoices()
{
    std::vector<choice> all
    {
        {engineSettings::kernel::exact, "best", 1e-12},
        {engineSettings::kernel::table, "best", 1e-5}
    };
    for (const std::string& instructions : allInstructions())
    {
        all.push_back({engineSettings::kernel::fast, instructions, 1e-5});
    }
    return all;
}


engineSettings settingsOf(const choice& chosen)
{
    engineSettings settings;
    settings.thickness = 0.1;
    settings.cutOff = 1;

    // What the tolerance is relative to where forces are less
    settings.spacing = 0.5;
    settings.pairKernel = chosen.kernel;
    settings.instructions = chosen.instructions;
    settings.tableTolerance = 1e-5;
    return settings;
}


//- Else the vector loops would not have been tried
void expectVectorsWhereChosen(const engine& system, const choice& chosen)
{
    EXPECT_EQ
    (
        system.kernelName().find("polynomials") != std::string::npos,
        chosen.kernel == engineSettings::kernel::fast
     && chosen.instructions != "plain"
    )   << system.kernelName();
}


//- Expect these forces of every kernel, for platelets shared in every way
void expectForces
(
    const platelets& all,
    const periodicBox& space,
    const boundarySurface& walls,
    const std::vector<vector>& expected
)
{
    for (const choice& chosen : allChoices())
    for (const sharing how : {sharing::slabs, sharing::dealt})
    {
        engine system
        (
            space, walls, std::make_shared<mixedForce>(), settingsOf(chosen),
            MPI_COMM_WORLD
        );
        system.load(share(all, how));
        system.evaluate();
        expectVectorsWhereChosen(system, chosen);

        EXPECT_LT
        (
            largestDifference
            (
                gather(system.local(), system.local().force, all.size()),
                expected
            ),
            chosen.bound*largest(expected)
        )   << system.kernelName();
    }
}


//- Expect the double sum
void expectDoubleSum(const platelets& all, const periodicBox& space)
{
    // Lengths are the same for all kernels
    const engineSettings settings(settingsOf(allChoices().front()));

    expectForces
    (
        all, space, {}, doubleSum(all, space, mixedForce(), settings)
    );
}

} // End namespace


TEST(netForce, isTheDoubleSumInAnOpenBox)
{
    expectDoubleSum
    (
        scatter(300, vector(4, 3, 2)), cube(4, false, false, false)
    );
}


TEST(netForce, isTheDoubleSumInAPeriodicBox)
{
    expectDoubleSum(scatter(300, vector(3.3, 3.3, 3.3)), cube(3.3));
}


TEST(netForce, isTheDoubleSumInABoxOfTwoCutOffs)
{
    for (const double edge : {2.0, 2.1})
    {
        expectDoubleSum(scatter(120, vector::Constant(edge)), cube(edge));
    }
}


TEST(netForce, isTheDoubleSumWhereOneAxisIsPeriodic)
{
    expectDoubleSum
    (
        scatter(300, vector(4, 2.5, 2)), cube(2.5, false, true, false)
    );
}


// Far from the origin, where single precision would lose the differences
TEST(netForce, isTheDoubleSumFarFromTheOrigin)
{
    platelets all(scatter(300, vector(4, 3, 2)));
    for (vector& x : all.position)
    {
        x += vector(3e5, -2e6, 1e4);
    }
    expectDoubleSum(all, cube(4, false, false, false));
}


// Hundreds of neighbours each, and most with none
TEST(netForce, isTheDoubleSumWhereDenseAndWhereThin)
{
    for (const double edge : {1.4, 25.0})
    {
        expectDoubleSum
        (
            scatter(400, vector::Constant(edge)),
            cube(edge, false, false, false)
        );
    }
}


// Wider than what places tell apart, and than what cells do
TEST(netForce, isTheDoubleSumInAVeryLongBox)
{
    for (const double apart : {32.0, 3.2e7})
    {
        platelets all(scatter(300, vector(2, 2, 2)));
        for (std::size_t k = 0; k < all.size(); ++k)
        {
            all.position[k][0] += apart*(k % 3);
        }
        expectDoubleSum(all, cube(4, false, false, false));
    }
}


TEST(netForce, ofAllInstructionsIsTested)
{
    // The last are for any processor
    EXPECT_EQ(allInstructions().back(), "plain");
    EXPECT_THROW(plateletDynamics::vectorLoops::choose("AVX"), userError);
}


// A pair as near as a gap of a thousandth of the spacing, among others
TEST(netForce, ofAClosePairIsExact)
{
    platelets all(scatter(300, vector(4, 3, 2)));
    all.position[17] = all.position[42] + vector(0.1001, 0, 0);
    const periodicBox space(cube(4, false, false, false));

    // 1/gap^3: the pair's force is all that counts
    struct steep
    :
        repulsion
    {
        double force(double gap) const override
        {
            return 1e-9/(gap*gap*gap);
        }

        double slope(double gap) const override
        {
            return -3*force(gap)/gap;
        }

        double contactGap() const override
        {
            return 1e-5;
        }
    };
    const steep law;

    for (choice chosen : allChoices())
    {
        const engineSettings settings(settingsOf(chosen));
        const auto expected = doubleSum(all, space, law, settings);

        engine system
        (
            space, {}, std::make_shared<steep>(), settings, MPI_COMM_WORLD
        );
        system.load(share(all));
        system.evaluate();
        const auto force =
            gather(system.local(), system.local().force, all.size());

        for (const int k : {17, 42})
        {
            EXPECT_LT
            (
                (force[k] - expected[k]).norm(), 1e-10*expected[k].norm()
            )   << system.kernelName();
        }

        expectVectorsWhereChosen(system, chosen);
    }
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

        const engineSettings settings(settingsOf(allChoices().front()));
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

        expectForces(all, space, walls, expected);
    }
}


TEST(netForce, isTheDoubleSumOnEachSideOfARock)
{
    // A slab thinner than the range of the forces, wider than the suspension
    platelets all(scatter(300, vector(3, 2, 2)));
    for (vector& x : all.position)
    {
        x[2] += x[2] < 1 ? -0.05 : 0.05;
    }
    boundarySurface rock;
    addRock(rock, vector(-5, -5, 0.97), vector(8, 7, 1.03), action::platelet);

    const periodicBox space(cube(3, false, false, false));
    const engineSettings settings(settingsOf(allChoices().front()));

    std::vector<vector> expected
    (
        wallForcesAt(all.position, space, rock, mixedForce(), settings)
    );
    for (const bool above : {false, true})
    {
        std::vector<int> side;
        for (std::size_t k = 0; k < all.size(); ++k)
        {
            if ((all.position[k][2] > 1) == above)
            {
                side.push_back(int(k));
            }
        }
        platelets part(all);
        part.reorder(side);
        const auto force = doubleSum(part, space, mixedForce(), settings);
        for (std::size_t i = 0; i < side.size(); ++i)
        {
            expected[side[i]] += force[i];
        }
    }
    expectForces(all, space, rock, expected);
}


// Near equilibrium, where forces nearly cancel: 5e-5 (rms) of what is left, at
// the tolerance by which the engine is used
TEST(netForce, ofADisturbedLatticeIsAsExactAsAsked)
{
    const int n = 6;
    platelets all(scatter(n*n*n, vector::Constant(0.2)));
    for (std::size_t k = 0; k < all.size(); ++k)
    {
        all.position[k] += vector(k % n, k/n % n, k/(n*n));
    }
    const periodicBox space(cube(n));

    engineSettings settings;
    settings.cutOff = 2.5;
    settings.spacing = 1;
    const repulsion law;
    const auto expected = doubleSum(all, space, law, settings);

    for (const std::string& instructions : allInstructions())
    {
        settings.instructions = instructions;
        engine system
        (
            space, {}, std::make_shared<repulsion>(), settings, MPI_COMM_WORLD
        );
        system.load(share(all));
        system.evaluate();
        const auto force =
            gather(system.local(), system.local().force, all.size());

        double error = 0;
        double whole = 0;
        for (std::size_t k = 0; k < all.size(); ++k)
        {
            error += (force[k] - expected[k]).squaredNorm();
            whole += expected[k].squaredNorm();
        }
        EXPECT_LT(std::sqrt(error/whole), 5e-5) << system.kernelName();
    }
}
