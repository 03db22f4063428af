/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scales.H"
#include "KozenyCarmanFriction.H"
#include "compressionDoubleLayer.H"
#include "constantFriction.H"
#include "exponentialDoubleLayer.H"
#include "referenceTable.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::colloid;

namespace
{

scales scalesOf
(
    const scalar concentration,
    const platelet& clay = platelet()
)
{
    water solution;
    solution.concentration = concentration;

    return scales
    (
        clay,
        solution,
        compressionDoubleLayer(clay, solution),
        KozenyCarmanFriction(clay, solution, 5)
    );
}

} // End anonymous namespace


// The report's Fig. 3-4 and its characteristic case; five digits computed
// independently
TEST(scales, criticalTimeStepsAreThoseOfTheReport)
{
    EXPECT_LT
    (
        relativeError(scalesOf(0.01).criticalTimeStep(1e-7, 0.01), 1.3646e-5),
        5e-5
    );

    platelet clay;
    clay.Hamaker = 0;
    water solution;
    solution.concentration = 0.01;

    IStringStream stream
    (
        "model exponential; P0 1500; kappa 7.34e6; distance centres;"
    );
    const exponentialDoubleLayer layer(dictionary(stream), clay, solution);
    const scales threePlatelets
    (
        clay, solution, layer, constantFriction(1.2e-9)
    );
    const scalar critical = threePlatelets.criticalTimeStep(9.9e-8, 0);

    EXPECT_LT(relativeError(critical, 7.228e-6), 1e-4);

    // Growth of Euler per step, 1 - 2 dt/dt_crit
    EXPECT_NEAR(1 - 2*2e-6/critical, 0.447, 5e-4);
    EXPECT_NEAR(1 - 2*5e-6/critical, -0.384, 1e-3);
    EXPECT_NEAR(1 - 2*1e-5/critical, -1.77, 5e-3);
}


TEST(scales, inertiaIsNegligible)
{
    const scales s = scalesOf(0.01);

    // The report's order, and the value that its form was computed to have
    EXPECT_NEAR(s.StokesNumber(9.9e-8, 0.01), 7.8e-5, 0.05e-5);

    // m |F'|/xi^2 = (m/xi)/dt_crit
    EXPECT_LT
    (
        relativeError
        (
            s.inertiaNumber(1e-7, 0.01),
            s.inertialTime(0.01)/s.criticalTimeStep(1e-7, 0.01)
        ),
        1e-14
    );
}


// Spacing of phi = 0.01: 1.465e-7 m, the report's Fig. 3-2
TEST(scales, spacingIsThatOfACubicLattice)
{
    EXPECT_NEAR(scalesOf(0.1).spacing(0.01), 1.465e-7, 5e-11);
    EXPECT_NEAR(scalesOf(0.1).gapAtSpacing(0.01), 1.455e-7, 5e-11);
}


// Computed independently: 2 spacings at c = 0.1, 4 at 0.01, 10 (4200
// neighbours) at 1e-4
TEST(scales, rangeIsWhatWasComputedForIt)
{
    EXPECT_NEAR(scalesOf(0.1).rangeInSpacings(0.01, 0.01), 2, 0.1);
    EXPECT_NEAR(scalesOf(0.01).rangeInSpacings(0.01, 0.01), 4, 0.1);

    const scalar range = scalesOf(1e-4).rangeInSpacings(0.01, 0.01);
    EXPECT_NEAR(range, 10, 0.6);
}


// At c = 2 the net force passes through zero at 1.02 spacings and comes back
// as an attraction of 0.8 of it at 1.12
TEST(scales, nothingBeyondTheRangeExceedsTheTolerance)
{
    const scalar cases[][2] =
    {
        {1e-3, 1e-3}, {0.1, 1e-3}, {1, 1e-3}, {2, 0.1}, {30, 1e-3}
    };

    for (const auto& [c, tolerance] : cases)
    {
        const platelet clay;
        water solution;
        solution.concentration = c;
        const compressionDoubleLayer layer(clay, solution);
        const vanDerWaals attraction(clay);
        const pairInteraction pair(clay, solution, &layer, &attraction);

        const scales s = scalesOf(c);
        const scalar spacing = s.spacing(0.01);
        const scalar range = s.rangeInSpacings(tolerance, 0.01);
        const scalar small =
            tolerance*mag(pair.force(spacing - clay.thickness));

        for (scalar r = range*1.0001; r < 500; r *= 1.01)
        {
            ASSERT_LE(mag(pair.force(r*spacing - clay.thickness)), small)
                << c << ' ' << r;
        }

        // The last step of the scan: 0.35 %
        EXPECT_GT
        (
            mag(pair.force(range*0.9999*spacing - clay.thickness)), 0.99*small
        ) << c;
    }
}


// Next neighbours alone at c = 1 (the others add 1e-3), F/L^2; 53.8 Pa at c = 0.1 by
// an independent calculation with a cut-off
TEST(scales, latticePressureIsThatOfACubicLattice)
{
    const platelet clay;
    water solution;

    const auto pressure = [&](const scalar c, const scalar spacing)
    {
        solution.concentration = c;
        const compressionDoubleLayer layer(clay, solution);
        const pairInteraction pair(clay, solution, &layer, nullptr);
        return std::make_pair
        (
            scales::latticePressure(pair, spacing, clay.thickness),
            pair.force(spacing - clay.thickness)/sqr(spacing)
        );
    };

    const auto near = pressure(1, std::cbrt(clay.volume()/0.005));
    EXPECT_NEAR(near.first, near.second, 2e-3*near.second);

    const auto far = pressure(0.1, std::cbrt(clay.volume()/0.0054093));
    EXPECT_NEAR(far.first, 53.8, 0.015*53.8);
}


// Against the sum over a simple cubic lattice, of shells beyond the distance.
// The integral spreads the shells evenly: a third either way
TEST(scales, pressureBeyondTheCutOffIsThatOfALattice)
{
    for (const scalar c : {0.01, 0.1})
    {
        for (const scalar tolerance : {1e-1, 1e-2, 1e-3})
        {
            const platelet clay;
            water solution;
            solution.concentration = c;
            const compressionDoubleLayer layer(clay, solution);
            const pairInteraction pair(clay, solution, &layer, nullptr);
            const scalar spacing = scalesOf(c).spacing(0.01);

            const scalar cutOff = scales::cutOffInSpacings
            (
                pair, spacing, clay.thickness, tolerance
            );
            EXPECT_NEAR
            (
                scales::pressureBeyond
                (
                    cutOff, pair, spacing, clay.thickness
                ),
                tolerance,
                0.02*tolerance
            );

            scalar all = 0;
            scalar beyond = 0;
            const int n = 25;
            for (int i = -n; i <= n; ++i)
            for (int j = -n; j <= n; ++j)
            for (int k = -n; k <= n; ++k)
            {
                const scalar r = std::sqrt(scalar(i*i + j*j + k*k));
                if (r > 0 && r < n)
                {
                    const scalar part =
                        r*pair.force(r*spacing - clay.thickness);
                    all += part;
                    beyond += r > cutOff ? part : 0;
                }
            }
            EXPECT_NEAR(beyond/all/tolerance, 1, 0.35) << c << ' ' << cutOff;
        }
    }
}


TEST(scales, rangeIsOneSpacingWhereEverythingIsTolerated)
{
    EXPECT_NEAR(scalesOf(0.1).rangeInSpacings(1, 0.01), 1, 1e-12);
}


TEST(scales, latticeStiffnessIsTwiceThatOfThreePlatelets)
{
    const scales s = scalesOf(0.1);
    const scalar lambda =
        2/s.criticalTimeStep(s.gapAtSpacing(0.01), 0.01);

    EXPECT_LT(relativeError(s.latticeStiffness(0.01), 2*lambda), 1e-14);
}


TEST(scales, engineStepsAreStableAndResolveThermalMotion)
{
    // Repulsion decides at c = 0.1, thermal motion where it has vanished
    const scales strong = scalesOf(0.1);
    EXPECT_LT
    (
        relativeError
        (
            strong.engineTimeStep(0.01)*strong.latticeStiffness(0.01), 0.5
        ),
        1e-14
    );

    platelet clay;
    clay.Hamaker = 0;
    const scales weak = scalesOf(1000, clay);
    const scalar dt = weak.engineTimeStep(1e-4);
    const scalar D =
        1.380649e-23*298.15
       /KozenyCarmanFriction(clay, water(), 5).value(1e-4);

    EXPECT_LT
    (
        relativeError(std::sqrt(2*D*dt), 0.1*weak.spacing(1e-4)), 1e-12
    );
}


// By hand: 1700 kg/m3 x 3.14159e-23 m3 x 9.80665 m/s2 / 1.20381688e-9 N s/m
TEST(scales, settlingVelocityIsWeightOverFriction)
{
    EXPECT_LT
    (
        relativeError
        (
            scalesOf(0.1).settlingVelocity(0),
            1700*3.14159265359e-23*9.80665/1.20381688e-9
        ),
        1e-8
    );

    platelet light;
    light.density = 900;
    EXPECT_LT(scalesOf(0.1, light).settlingVelocity(0), 0);
}


TEST(scales, measuresOfAutoAreTheirRatios)
{
    const platelet clay;
    water solution;
    solution.concentration = 0.1;
    const compressionDoubleLayer layer(clay, solution);
    const vanDerWaals attraction(clay);
    const scales s = scalesOf(0.1);

    EXPECT_DOUBLE_EQ
    (
        s.vanDerWaalsOverDoubleLayer(1e-8),
        attraction.force(1e-8)/layer.force(1e-8)
    );

    // xi(0.01)/xi(0) - 1 of the reference
    EXPECT_NEAR
    (
        s.KozenyCarmanOverStokes(5, 0.01), 7.743e-9/1.20382e-9 - 1, 1e-3
    );
    EXPECT_NEAR(s.KozenyCarmanOverStokes(5, 0), 0, 1e-15);

    const scalar L = s.spacing(0.01);
    EXPECT_LT
    (
        relativeError
        (
            s.thermalOverForce(0.01),
            1.380649e-23*298.15
           /(L*(layer.force(L - 1e-9) - attraction.force(L - 1e-9)))
        ),
        1e-12
    );

    EXPECT_LT
    (
        relativeError
        (
            s.settlingOverFlow(0.01, 1e-5), s.settlingVelocity(0.01)/1e-5
        ),
        1e-14
    );
}


// Traps are on: no division by a force that has underflowed
TEST(scales, measuresOfNothingAreGreat)
{
    const scales s = scalesOf(1000);

    EXPECT_EQ(s.vanDerWaalsOverDoubleLayer(1e-4), GREAT);
    EXPECT_EQ(s.settlingOverFlow(0.01, 0), GREAT);

    platelet clay;
    clay.Hamaker = 0;
    EXPECT_EQ(scalesOf(1000, clay).thermalOverForce(1e-6), GREAT);
    EXPECT_EQ(scalesOf(1000, clay).criticalTimeStep(1e-4, 0), GREAT);
}


// Physics of the characteristic case: x = 1 cm, u0 = 1e-5 m/s, eta_r = 8.2
// at the gel's edge, D = 1e-10
TEST(scales, rimOfTheCharacteristicCase)
{
    const scalar thickness = scales::rimThickness(0.01, 1e-5, 1e-10, 8.2);

    EXPECT_NEAR(thickness, 9.055e-3, 1e-6);
    EXPECT_NEAR(scales::rimDiffusionTime(thickness, 1e-10), 8.2e5, 1e3);
    EXPECT_NEAR(scales::rimSteadyTime(0.01, 1e-5, 8.2), 5740, 1);
}


// ************************************************************************* //
