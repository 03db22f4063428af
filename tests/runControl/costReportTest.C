/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "OStringStream.H"
#include "Pstream.H"
#include "costReport.H"

#include <gtest/gtest.h>

#include <sstream>
#include <thread>

using namespace Foam;

namespace
{

void spend(const double seconds)
{
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}


std::string tableOf
(
    const costReport& cost,
    const double particleSteps = 0,
    const double simulatedTime = 0
)
{
    OStringStream os;
    cost.report(os, particleSteps, simulatedTime);
    return os.str();
}


//- The row of the table that begins with this
std::string row(const std::string& table, const std::string& name)
{
    std::istringstream lines(table);
    std::string line;
    while (std::getline(lines, line))
    {
        if (line.find(name) != std::string::npos)
        {
            return line;
        }
    }
    return "";
}

} // End anonymous namespace


TEST(costReport, countsUntilTheTimingEnds)
{
    costReport cost;
    {
        const auto timing = cost.start("flow");
        spend(0.02);
    }
    spend(0.02);
    {
        auto timing = cost.start("flow");
        spend(0.01);
        timing.stop();
        spend(0.02);
    }

    // Sleeping takes longer than asked for, never shorter
    EXPECT_GE(cost.seconds("flow"), 0.03);
    EXPECT_LT(cost.seconds("flow"), cost.totalSeconds() - 0.04);
    EXPECT_EQ(cost.seconds("filter"), 0);
}


TEST(costReport, showsTheSlowestRankAndTheMean)
{
    costReport cost;
    cost.add("platelets", Pstream::master() ? 100 : 300);

    const std::string line(row(tableOf(cost), "platelets"));
    const label n = Pstream::nProcs();

    std::istringstream words(line);
    std::string name;
    double slowest;
    double mean;
    words >> name >> slowest >> mean;
    EXPECT_NEAR(slowest, n > 1 ? 300 : 100, 1e-3);
    EXPECT_NEAR(mean, (100. + (n - 1)*300)/n, 1e-3);
}


TEST(costReport, listsPartsOfPartsWithoutAddingThem)
{
    costReport cost;
    spend(0.05);
    cost.add("platelets", 0.02);
    cost.add("write", 0.001);
    cost.add("forces", 0.01, "platelets");

    // Below its own part, not where it was added
    const std::string table(tableOf(cost));
    EXPECT_LT(table.find("platelets"), table.find("of it forces"));
    EXPECT_LT(table.find("of it forces"), table.find("the rest of it"));
    EXPECT_LT(table.find("the rest of it"), table.find("write"));

    // Against the table's own total: ranks measure their own
    std::istringstream otherWords(row(table, "other"));
    std::istringstream totalWords(row(table, "    total"));
    std::string name;
    double other;
    double total;
    otherWords >> name >> other;
    totalWords >> name >> total;
    // Printed to the millisecond
    EXPECT_NEAR(other, total - 0.021, 2e-3);
}


TEST(costReport, showsCostPerParticleStepOfAllRanks)
{
    costReport cost;
    const std::string table(tableOf(cost, 1000, 1e-3));
    const std::string steps(std::to_string(1000*Pstream::nProcs()));

    EXPECT_NE(row(table, "particle-steps").find(steps), std::string::npos);
    EXPECT_NE(row(table, "simulated").find("1 ms"), std::string::npos);
}


TEST(costReport, fitsInto80Columns)
{
    costReport cost;
    cost.add("a part with a name that is much too long for a table", 1e-3);
    cost.add
    (
        "a year", 31557600,
        "a part with a name that is much too long for a table"
    );

    std::istringstream lines(tableOf(cost, 1.23456789e15, 1.23456789e10));
    std::string line;
    while (std::getline(lines, line))
    {
        EXPECT_LE(line.size(), 80u) << line;
    }
}
