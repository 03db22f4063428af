/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What users can get wrong, and systems with next to nothing in them: each is
    answered on all ranks alike.
\*---------------------------------------------------------------------------*/

#include "testSystems.H"

#include <gtest/gtest.h>

#include <limits>

namespace
{

const auto law = std::make_shared<repulsion>();

engineSettings settings()
{
    engineSettings chosen;
    chosen.thickness = 0.1;
    chosen.cutOff = 1;
    return chosen;
}


//- The error of an action, or nothing; every rank must meet it
template<class Action>
std::string errorOf(const Action& action)
{
    try
    {
        action();
    }
    catch (const userError& error)
    {
        return error.what();
    }
    return "";
}


void expectWords
(
    const std::string& message,
    const std::vector<std::string>& words
)
{
    for (const std::string& word : words)
    {
        EXPECT_NE(message.find(word), std::string::npos)
            << "\"" << word << "\" is not in \"" << message << "\"";
    }
}


//- The error of making an engine
std::string errorOfMaking(const engineSettings& chosen, const periodicBox& space = {})
{
    return errorOf
    (
        [&]{ engine(space, {}, law, chosen, MPI_COMM_WORLD); }
    );
}


//- Some platelets of which rank 0 can spoil one
platelets four()
{
    platelets all;
    for (int k = 0; k < 4; ++k)
    {
        all.append(10 + k, vector(k, 0.5, 0.5));
        all.tag[k] = k;
    }
    return share(all, sharing::dealt);
}

} // End namespace


TEST(errors, nameABoxThatIsTooSmall)
{
    expectWords
    (
        errorOfMaking(settings(), cube(1.9)),
        {"1.9", "along x", "cut-off", "at least 2", "at most 0.95"}
    );
    EXPECT_EQ(errorOfMaking(settings(), cube(2)), "");
}


TEST(errors, nameSettingsThatAreImpossible)
{
    auto chosen = settings();
    chosen.integrator = "Eulr";
    expectWords(errorOfMaking(chosen), {"Eulr", "AdamsBashforth2, BogackiShampine, Euler, LeimkuhlerMatthews, RKC2, auto"});

    chosen = settings();
    chosen.cutOff = 0.05;
    expectWords(errorOfMaking(chosen), {"cutOff", "0.05", "thickness"});

    chosen = settings();
    chosen.skin = -1;
    expectWords(errorOfMaking(chosen), {"skin", "-1"});

    chosen = settings();
    chosen.skin = 1.01*chosen.cutOff;
    expectWords(errorOfMaking(chosen), {"skin", "wider", "cutOff"});

    chosen = settings();
    chosen.deltaT = std::numeric_limits<double>::quiet_NaN();
    expectWords(errorOfMaking(chosen), {"deltaT"});

    chosen = settings();
    chosen.tableTolerance = 1e-17;
    expectWords(errorOfMaking(chosen), {"larger tolerance", "exact kernel"});
}


TEST(errors, nameAPlateletThatIsImpossible)
{
    const auto errorOfLoading = [](const auto& spoil)
    {
        engine system(cube(4), {}, law, settings(), MPI_COMM_WORLD);
        platelets some(four());
        if (myRank() == 0)
        {
            spoil(some);
        }
        return errorOf([&]{ system.load(some); });
    };

    expectWords
    (
        errorOfLoading([](platelets& p) { p.friction[0] = 0; }),
        {"10", "friction"}
    );
    expectWords
    (
        errorOfLoading
        (
            [](platelets& p)
            {
                p.position[0][1] = std::numeric_limits<double>::infinity();
            }
        ),
        {"10", "inf"}
    );
    expectWords
    (
        errorOfLoading([](platelets& p) { p.append(10, vector::Zero()); }),
        {"10", "Two platelets"}
    );
    expectWords
    (
        errorOfLoading([](platelets& p) { p.tag.pop_back(); }),
        {"length"}
    );
}


TEST(errors, nameTwoPlateletsAtOnePlace)
{
    engine system(cube(4), {}, law, settings(), MPI_COMM_WORLD);
    platelets some(four());

    // On two ranks, if there are two
    for (std::size_t k = 0; k < some.size(); ++k)
    {
        if (some.id[k] == 11)
        {
            some.position[k] = vector(2, 0.5, 0.5);
        }
    }
    system.load(some);
    expectWords(errorOf([&]{ system.evaluate(); }), {"11", "12", "same place"});

    system.load(some);
    expectWords(errorOf([&]{ system.advance(1); }), {"11", "12", "same place"});

    // The engine can be used again
    system.load(four());
    EXPECT_EQ(errorOf([&]{ system.advance(0.1); }), "");
}


TEST(errors, nameAPlateletThatMovesTooFar)
{
    auto chosen = settings();
    chosen.deltaT = 0.1;
    engine system(cube(4), {}, law, chosen, MPI_COMM_WORLD);
    platelets some(four());
    if (myRank() == 0)
    {
        some.waterVelocity[0] = vector(0, 10.5, 0);
    }
    system.load(some);
    expectWords(errorOf([&]{ system.advance(1); }), {"10", "1.05", "cut-off"});

    // In the last step too
    system.load(some);
    expectWords(errorOf([&]{ system.advance(0.1); }), {"10", "cut-off"});

    // After that others can be loaded, more and elsewhere
    const platelets others(scatter(300, vector::Constant(4)));
    engine fresh(cube(4), {}, law, chosen, MPI_COMM_WORLD);
    for (engine* each : {&system, &fresh})
    {
        each->load(share(others));
        each->advance(0.2);
    }
    EXPECT_EQ
    (
        largestDifference
        (
            gather(system.local(), system.local().position, 300),
            gather(fresh.local(), fresh.local().position, 300)
        ),
        0
    );
}


TEST(errors, nameAPlateletWhoseVelocityIsNotANumber)
{
    for (const double wrong :
        {
            std::numeric_limits<double>::quiet_NaN(),
            std::numeric_limits<double>::infinity()
        })
    {
        engine system(cube(4), {}, law, settings(), MPI_COMM_WORLD);
        system.load(four());
        if (myRank() == 0)
        {
            system.local().waterVelocity[0][2] = wrong;
        }
        expectWords(errorOf([&]{ system.advance(1); }), {"10", "velocity"});
    }

    engine system(cube(4), {}, law, settings(), MPI_COMM_WORLD);
    system.load(four());
    if (myRank() == 0)
    {
        system.local().friction[0] = 0;
    }
    expectWords(errorOf([&]{ system.advance(1); }), {"10", "friction 0"});
}


TEST(errors, refuseARunWithoutEnd)
{
    auto chosen = settings();
    chosen.deltaT = 1e-20;
    engine system(cube(4), {}, law, chosen, MPI_COMM_WORLD);
    system.load(four());

    expectWords(errorOf([&]{ system.advance(1); }), {"1e-20", "steps"});
    expectWords(errorOf([&]{ system.advance(-1); }), {"-1"});
}


TEST(systems, mayBeEmpty)
{
    engine system(cube(4), {}, law, settings(), MPI_COMM_WORLD);
    system.load({});
    system.advance(1);

    EXPECT_EQ(system.local().size(), 0u);
    EXPECT_EQ(system.virial(), 0);
    EXPECT_EQ(system.stiffness(), 0);
    EXPECT_EQ(system.counters().listedPairs, 0);
}


TEST(systems, mayHoldOnePlatelet)
{
    engine system(cube(2), {}, law, settings(), MPI_COMM_WORLD);
    platelets one;
    if (myRank() == 0)
    {
        one.append(1, vector(0, 1, 2));
    }
    system.load(one);
    system.advance(1);

    // In a box of two cut-offs it does not feel its own images
    for (const vector& force : system.local().force)
    {
        EXPECT_EQ(force.norm(), 0);
    }
}


TEST(systems, mayLeaveRanksEmpty)
{
    const platelets all(scatter(50, vector::Constant(3)));
    const periodicBox space(cube(3));
    auto chosen = settings();
    chosen.pairKernel = engineSettings::kernel::exact;

    engine system(space, {}, law, chosen, MPI_COMM_WORLD);
    system.load(myRank() == nRanks() - 1 ? all : platelets());
    system.evaluate();

    const auto expected = doubleSum(all, space, *law, chosen);
    EXPECT_LT
    (
        largestDifference
        (
            gather(system.local(), system.local().force, 50), expected
        ),
        1e-12*largest(expected)
    );
    system.advance(1);
}


TEST(systems, mayBeSpreadOverVastSpaces)
{
    // Two pairs a billion cut-offs apart: lists do not grow with the space
    platelets all;
    all.append(0, vector(0, 0, 0));
    all.append(1, vector(0.5, 0, 0));
    all.append(2, vector(1e9, 1e9, 1e9));
    all.append(3, vector(1e9, 1e9 + 0.5, 1e9));
    for (int k = 0; k < 4; ++k)
    {
        all.tag[k] = k;
    }

    engine system(periodicBox(), {}, law, settings(), MPI_COMM_WORLD);
    system.load(share(all, sharing::dealt));
    system.evaluate();

    const auto force = gather(system.local(), system.local().force, 4);
    EXPECT_NEAR(force[1][0], law->force(0.4), 1e-6);
    EXPECT_NEAR(force[3][1], law->force(0.4), 1e-6);
}


TEST(counters, countContactsOnce)
{
    // Contact below a gap of 0.01: one pair of two
    platelets all;
    all.append(0, vector(0, 0, 0));
    all.append(1, vector(0.105, 0, 0));
    all.append(2, vector(0.6, 0, 0));

    engine system(periodicBox(), {}, law, settings(), MPI_COMM_WORLD);
    system.load(share(all, sharing::dealt));
    system.evaluate();

    int contacts = int(system.counters().contacts);
    MPI_Allreduce(MPI_IN_PLACE, &contacts, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_EQ(contacts, 1);
    EXPECT_EQ(system.counters().evaluations, 1);
    EXPECT_EQ(system.counters().rebuilds, 1);
}
