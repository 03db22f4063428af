/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    That results follow from the state: not from ranks, lists, order or
    restarts.
\*---------------------------------------------------------------------------*/

#include "testSystems.H"

#include "vectorLoops.H"

#include <gtest/gtest.h>

#include <cstring>

namespace
{

using kernel = engineSettings::kernel;

engineSettings settings(double skin = 0, kernel chosenKernel = kernel::exact)
{
    engineSettings chosen;
    chosen.thickness = 0.1;
    chosen.cutOff = 1;
    chosen.skin = skin;
    chosen.pairKernel = chosenKernel;
    return chosen;
}


const auto law = std::make_shared<repulsion>();


//- Else the vector loops would not have been tried
void expectVectorsIfFast(const engine& system, kernel chosen)
{
    const bool any = plateletDynamics::vectorLoops::choose().intervals;

    EXPECT_EQ
    (
        system.kernelName().find("polynomials") != std::string::npos,
        any && chosen == kernel::fast
    )   << system.kernelName();
}


//- Unwrapped places of all platelets
std::vector<vector> places
(
    const engine& system,
    const periodicBox& space,
    std::size_t total
)
{
    std::vector<vector> unwrapped(system.local().position);
    for (std::size_t k = 0; k < unwrapped.size(); ++k)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            unwrapped[k][axis] +=
                system.local().crossings[k][axis]*space.period(axis);
        }
    }

    // Alone on its communicator a rank holds all of them
    if (system.local().size() == total)
    {
        std::vector<vector> all(total);
        for (std::size_t k = 0; k < total; ++k)
        {
            all[system.local().tag[k]] = unwrapped[k];
        }
        return all;
    }
    return gather(system.local(), unwrapped, total);
}


//- Platelets that drift past each other, so that they cross boundaries and
//  change neighbours
platelets drifting(int count, double edge)
{
    platelets all(scatter(count, vector::Constant(edge)));
    for (std::size_t k = 0; k < all.size(); ++k)
    {
        all.waterVelocity[k] = (int(k % 3) - 1)*vector(1, 0.4, -0.7);
    }
    return all;
}


bool sameBits(const std::vector<vector>& a, const std::vector<vector>& b)
{
    return
        a.size() == b.size()
     && std::memcmp(a.data(), b.data(), a.size()*sizeof(vector)) == 0;
}

} // End namespace


TEST(results, doNotDependOnTheRanks)
{
    const periodicBox space(cube(3));
    const platelets all(drifting(200, 3));

    // Round-off, grown by the motion: it does not move 1e-11 of a cut-off, or
    // 1e-5 where forces are summed in single precision
    const std::pair<kernel, double> bounds[] =
    {
        {kernel::exact, 1e-11}, {kernel::fast, 1e-5}
    };

    for (const auto& [chosen, bound] : bounds)
    for (const sharing how : {sharing::slabs, sharing::dealt})
    {
        engine alone(space, {}, law, settings(0, chosen), MPI_COMM_SELF);
        alone.load(all);
        alone.advance(2);

        engine shared(space, {}, law, settings(0, chosen), MPI_COMM_WORLD);
        expectVectorsIfFast(shared, chosen);
        shared.load(share(all, how));
        shared.advance(2);

        EXPECT_EQ(shared.counters().steps, alone.counters().steps);
        EXPECT_GT(shared.counters().rebuilds, 2);

        EXPECT_LT
        (
            largestDifference
            (
                places(alone, space, 200), places(shared, space, 200)
            ),
            bound
        );
    }
}


TEST(results, doNotDependOnTheSkin)
{
    // Also in a box so small that the whole skin asked for does not fit
    for (const double edge : {3.0, 2.1})
    {
        const periodicBox space(cube(edge));
        const int count = int(7*edge*edge*edge);
        const platelets all(drifting(count, edge));

        const auto run = [&](double skin, std::int64_t& rebuilds)
        {
            auto chosen = settings(skin);
            chosen.deltaT = 0.005;
            engine system(space, {}, law, chosen, MPI_COMM_WORLD);
            EXPECT_LE(system.skin(), edge - 1);
            system.load(share(all));
            system.advance(2);
            rebuilds = system.counters().rebuilds;
            return places(system, space, count);
        };

        std::int64_t often;
        std::int64_t seldom;

        // Rounding, as above
        EXPECT_LT(largestDifference(run(0.01, often), run(1, seldom)), 1e-10);
        EXPECT_GT(often, 100);
        EXPECT_LT(seldom, 10);
    }
}


TEST(results, doNotDependOnTheOrderOfLoading)
{
    const periodicBox space(cube(3));
    platelets all(drifting(200, 3));

    const auto run = [&](const platelets& loaded)
    {
        engine system(space, {}, law, settings(), MPI_COMM_WORLD);
        system.load(share(loaded));
        system.advance(1);
        return places(system, space, 200);
    };

    const auto before = run(all);

    std::vector<int> shuffled(all.size());
    for (std::size_t k = 0; k < all.size(); ++k)
    {
        shuffled[k] = int((7*k + 3) % all.size());
    }
    all.reorder(shuffled);

    EXPECT_TRUE(sameBits(before, run(all)));
}


TEST(results, areTheSameBitsAfterARestart)
{
    for (const kernel chosen : {kernel::exact, kernel::fast})
    for
    (
        const char* integrator
      : {"AdamsBashforth2", "RKC2", "BogackiShampine", "auto"}
    )
    {
        auto how = settings(0, chosen);
        how.integrator = integrator;

        const periodicBox space(cube(3, true, true, false));
        const platelets all(drifting(200, 3));

        engine through(space, {}, law, how, MPI_COMM_WORLD);
        expectVectorsIfFast(through, chosen);
        through.load(share(all));
        through.advance(0.731);
        through.listsExpire();
        const platelets written(through.local());
        const double skinUse = through.skinUse();
        const auto memory = through.integratorMemory();
        through.clearCrossings();
        through.advance(0.9);

        // In another order, without what need not be written
        platelets read(written);
        std::vector<int> backwards(read.size());
        for (std::size_t k = 0; k < read.size(); ++k)
        {
            backwards[k] = int(read.size() - 1 - k);
        }
        read.reorder(backwards);

        engine restarted(space, {}, law, how, MPI_COMM_WORLD);
        restarted.setSkinUse(skinUse);
        restarted.setIntegratorMemory(memory);
        restarted.load(read);
        restarted.advance(0.9);

        EXPECT_TRUE
        (
            sameBits(places(through, space, 200), places(restarted, space, 200))
        )   << integrator;
        EXPECT_TRUE
        (
            sameBits
            (
                gather(through.local(), through.local().previousVelocity, 200),
                gather(restarted.local(), restarted.local().previousVelocity, 200)
            )
        );
    }
}


TEST(results, continueAcrossCallsWithoutNewLists)
{
    // Twice round the box; the wrapping at the end of a call must not disturb
    // the lists, nor a long call need it
    const periodicBox space(cube(3));
    platelets all(drifting(100, 3));
    for (vector& velocity : all.waterVelocity)
    {
        velocity *= 3;
    }
    auto chosen = settings(0.9);
    chosen.deltaT = 0.01;

    engine whole(space, {}, law, chosen, MPI_COMM_WORLD);
    whole.load(share(all));
    whole.advance(2);

    engine parts(space, {}, law, chosen, MPI_COMM_WORLD);
    parts.load(share(all));
    for (int part = 0; part < 200; ++part)
    {
        parts.advance(0.01);
    }

    EXPECT_EQ(whole.counters().rebuilds, parts.counters().rebuilds);

    // Rounding, as above
    EXPECT_LT
    (
        largestDifference
        (
            places(whole, space, 100), places(parts, space, 100)
        ),
        1e-11
    );
}


TEST(momentum, isZeroWithoutWalls)
{
    const periodicBox space(cube(3));
    const platelets all(scatter(400, vector::Constant(3)));

    for (const auto kernel :
        {engineSettings::kernel::exact, engineSettings::kernel::table})
    {
        auto chosen = settings();
        chosen.pairKernel = kernel;

        engine system(space, {}, law, chosen, MPI_COMM_WORLD);
        system.load(share(all));
        system.evaluate();
        const auto force = gather(system.local(), system.local().force, 400);

        vector sum(vector::Zero());
        for (const vector& f : force)
        {
            sum += f;
        }

        // Actions and reactions are equal bit by bit, but for the images
        EXPECT_LT(sum.norm(), 1e-12*400*largest(force));
    }
}


TEST(virial, isTheSumOverPairs)
{
    const periodicBox space(cube(2.4));
    const platelets all(scatter(100, vector::Constant(2.4)));

    double expected = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            vector d(all.position[i] - all.position[j]);
            for (int axis = 0; axis < 3; ++axis)
            {
                d[axis] -= 2.4*std::round(d[axis]/2.4);
            }
            expected += d.norm()*pairForce(*law, settings(), d.norm());
        }
    }

    engine system(space, {}, law, settings(), MPI_COMM_WORLD);
    system.load(share(all, sharing::dealt));
    EXPECT_NEAR(system.virial(), expected, 1e-12*expected);
}


TEST(crossings, countPassagesThroughPeriodicEnds)
{
    const periodicBox space(cube(3, true, true, false));
    engine system
    (
        space, {}, std::make_shared<noForce>(), settings(), MPI_COMM_WORLD
    );

    platelets some;
    if (myRank() == 0)
    {
        some.append(0, vector(1, 1, 1));
        some.waterVelocity[0] = vector(2.5, -1, 5);

        // Loaded outside: brought inside, and counted
        some.append(1, vector(-0.5, 7, -50));
    }
    system.load(some);
    system.advance(3);

    if (myRank() == 0)
    {
        const platelets& local = system.local();
        const int first = local.id[0] == 0 ? 0 : 1;
        const std::array<int, 3> twice{2, -1, 0};
        const std::array<int, 3> loaded{-1, 2, 0};

        EXPECT_EQ(local.crossings[first], twice);
        EXPECT_EQ(local.crossings[1 - first], loaded);
        EXPECT_LT((local.position[first] - vector(2.5, 1, 16)).norm(), 1e-13);
        EXPECT_LT
        (
            (local.position[1 - first] - vector(2.5, 1, -50)).norm(), 1e-13
        );

        system.clearCrossings();
        EXPECT_EQ(local.crossings[first], (std::array<int, 3>{0, 0, 0}));
    }
}
