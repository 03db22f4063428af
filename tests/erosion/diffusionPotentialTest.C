/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusionPotential.H"
#include "flowCase.H"
#include "simpson.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

namespace
{

constexpr scalar largest = 0.65;

const dictionary& Liu()
{
    static const dictionary dict(dictionaryOf("model Liu;"));
    return dict;
}

} // End anonymous namespace


// Between tables, of which there are 40 to a decade: nearer to the one than to
// the other, where the wrong share would show
TEST(diffusionPotential, isBetweenTablesAsATableMadeThere)
{
    const colloid::clayProperties matter
    (
        dictionaryOf("water { concentration 1; }")
    );
    const auto model = fractionDiffusivity::New(Liu(), matter);

    diffusionPotential potential(Liu(), matter, largest);
    potential.setVarying();

    scalar worst = 0;
    scalar apart = 0;
    for (const scalar place : {-39.9, -20.25, 0.1, 10.75})
    {
        const auto tableAt = [&](const scalar number)
        {
            colloid::water water(matter.waterAt(0));
            water.concentration = std::pow(10, number/40);
            return potentialInWater(model(), water, largest);
        };
        const potentialInWater exact(tableAt(place));
        const potentialInWater lower(tableAt(std::floor(place)));
        const auto between = potential.at(std::pow(10, place/40));

        for (const scalar alpha : {1e-4, 1e-3, 0.01, 0.05, 0.2})
        {
            const scalar Phi = exact.at(alpha).potential;

            worst = max(worst, mag(between.at(alpha).potential/Phi - 1));
            apart = max(apart, mag(lower.at(alpha).potential/Phi - 1));
            EXPECT_NEAR
            (
                between.at(alpha).diffusivity/exact.at(alpha).diffusivity,
                1,
                0.01
            );
        }
    }
    Info<< "Potential between tables is wrong by up to " << worst
        << ", that of the table below by up to " << apart << endl;
    EXPECT_LT(worst, 2e-3);
    EXPECT_GT(apart, 0.02);
}


// A gel beside a sol: the potential is the same from the one to the other, and
// just beyond them what D adds, by Simpson's rule
TEST(potentialInWater, isTheIntegralOfDToEitherSideOfThePhases)
{
    const colloid::clayProperties matter
    (
        dictionaryOf("water { concentration 100; }")
    );
    const colloid::water water(matter.waterAt(0));
    const auto model = fractionDiffusivity::New(Liu(), matter);
    const auto D = model->at(water);
    const potentialInWater potential(model(), water, largest);

    const scalar sol = potential.phases().sol();
    const scalar gel = potential.phases().gel();
    ASSERT_GT(sol, 0);
    ASSERT_LT(gel, 0.6);

    const auto integral = [&](const scalar from, const scalar to)
    {
        return simpson
        (
            [&](const scalar a) { return D->value(a); }, from, to, 2000
        );
    };
    const scalar ofSol = integral(0, sol);

    // Beyond the panels that the phases are in, 0.6 % wide
    for (const scalar alpha : {1.01*sol, std::sqrt(sol*gel), 0.99*gel})
    {
        EXPECT_NEAR(potential.at(alpha).potential/ofSol, 1, 1e-6);
    }
    for (const scalar beyond : {0.01, 0.02, 0.1})
    {
        const scalar alpha = (1 + beyond)*gel;
        EXPECT_NEAR
        (
            (potential.at(alpha).potential - ofSol)/integral(gel, alpha),
            1,
            1e-6
        );
    }
}
