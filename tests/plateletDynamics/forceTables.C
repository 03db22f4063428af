/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The table kernel against the exact one.
\*---------------------------------------------------------------------------*/

#include "testSystems.H"

#include "forceTable.H"
#include "registerTable.H"

#include <gtest/gtest.h>

using plateletDynamics::forceTable;
using plateletDynamics::registerTable;
using plateletDynamics::taperedForce;

TEST(forceTable, keepsItsToleranceAtEveryDistance)
{
    engineSettings settings;
    settings.thickness = 0.05;
    settings.cutOff = 2;

    for (const double tolerance : {1e-3, 1e-6, 1e-8})
    {
        for (const auto& law :
            {
                std::shared_ptr<const gapForce>(new repulsion(5)),
                std::shared_ptr<const gapForce>(new mixedForce)
            })
        {
            const taperedForce tapered
            (
                law, settings.thickness, settings.cutOff
            );
            const forceTable table(tapered, tolerance);

            // From the cut-off inwards, so that the largest force at that
            // distance or beyond is known
            double largestBeyond = 0;
            double error = 0;
            for (int i = 1; i < 20000; ++i)
            {
                const double r = 2*(1 - i/20000.0);
                const double exact = pairForce(*law, settings, r);
                largestBeyond = std::max(largestBeyond, std::abs(exact));

                if (r < 1.8)
                {
                    error = std::max
                    (
                        error,
                        std::abs(table.forceOverDistance(r*r)*r - exact)
                       /largestBeyond
                    );
                }
                if (r < table.begin())
                {
                    EXPECT_NEAR
                    (
                        table.forceOverDistance(r*r)*r, exact,
                        1e-14*std::abs(exact)
                    );
                }
            }

            // Checked at four places of an interval: the largest is near one
            EXPECT_LT(error, 1.05*tolerance);
        }
    }
}


TEST(forceTable, changesNetForcesByItsTolerance)
{
    engineSettings settings;
    settings.thickness = 0.1;
    settings.cutOff = 1;

    const periodicBox space(cube(3));
    const platelets all(scatter(400, vector::Constant(3)));

    for (const double tolerance : {1e-4, 1e-7})
    {
        settings.tableTolerance = tolerance;
        engine system
        (
            space, {}, std::make_shared<mixedForce>(), settings, MPI_COMM_WORLD
        );
        system.load(share(all));
        system.evaluate();

        const auto expected = doubleSum(all, space, mixedForce(), settings);
        EXPECT_LT
        (
            largestDifference
            (
                gather(system.local(), system.local().force, 400), expected
            ),
            tolerance*largest(expected)
        );
    }
}


TEST(forceTable, refusesWhatItCannotTabulate)
{
    // A force that oscillates a hundred times within the cut-off
    struct wild
    :
        repulsion
    {
        double force(double gap) const override
        {
            return std::sin(600*gap);
        }

        double slope(double gap) const override
        {
            return 600*std::cos(600*gap);
        }
    };

    EXPECT_THROW
    (
        forceTable(taperedForce(std::make_shared<wild>(), 0, 1), 1e-14),
        userError
    );
}


TEST(registerTable, keepsItsToleranceAtEveryDistance)
{
    engineSettings settings;
    settings.thickness = 0.05;
    settings.cutOff = 2;
    const double spacing = 0.8;

    for (const int intervals : {8, 16})
    {
        for (const double tolerance : {1e-3, 1e-5})
        {
            for (const auto& law :
                {
                    std::shared_ptr<const gapForce>(new repulsion(5)),
                    std::shared_ptr<const gapForce>(new mixedForce)
                })
            {
                const taperedForce tapered
                (
                    law, settings.thickness, settings.cutOff
                );
                const registerTable table
                (
                    tapered, spacing, intervals, tolerance
                );
                ASSERT_TRUE(table.valid());

                // From the cut-off inwards: the largest force there or beyond
                double scale = std::max
                (
                    std::abs(pairForce(*law, settings, spacing)),
                    std::abs(pairForce(*law, settings, 0.9*settings.cutOff))
                );
                double error = 0;
                const double begin = std::sqrt(table.beginSquared());

                for (int i = 1; i < 20000; ++i)
                {
                    const double r = begin + (2 - begin)*(1 - i/20000.0);
                    const double exact = pairForce(*law, settings, r);
                    scale = std::max(scale, std::abs(exact));

                    error = std::max
                    (
                        error,
                        std::abs(table.forceOverDistance(r*r)*r - exact)/scale
                    );
                }

                // Checked at 64 places of an interval
                EXPECT_LT(error, 1.05*tolerance);
                EXPECT_LT(begin, 0.28*settings.cutOff);
            }
        }
    }
}


TEST(registerTable, isRefusedWhereItWouldBeWrong)
{
    struct steep
    :
        repulsion
    {
        double force(double gap) const override
        {
            return std::exp(-200*gap);
        }
    };
    const taperedForce tapered(std::make_shared<steep>(), 0, 2);

    // A force that falls by e in a four-hundredth of the cut-off
    EXPECT_FALSE(registerTable(tapered, 1, 16, 1e-5).valid());

    // Where contact, with its kink, lies within the table
    const taperedForce thick(std::make_shared<repulsion>(), 0.9, 2);
    EXPECT_FALSE(registerTable(thick, 1, 16, 1e-5).valid());
}
