/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pairInteraction.H"
#include "compressionDoubleLayer.H"
#include "referenceTable.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::colloid;

namespace
{

water waterOf(const scalar concentration)
{
    water solution;
    solution.concentration = concentration;
    return solution;
}

pairInteraction pairOf
(
    const scalar concentration,
    const bool repels,
    const bool attracts,
    const scalar coarseGraining = 1,
    const platelet& clay = platelet()
)
{
    const compressionDoubleLayer layer(clay, waterOf(concentration));
    const vanDerWaals attraction(clay);

    return pairInteraction
    (
        clay,
        waterOf(concentration),
        repels ? &layer : nullptr,
        attracts ? &attraction : nullptr,
        coarseGraining
    );
}

const bool onOff[] = {false, true};

} // End anonymous namespace


TEST(pairInteraction, isRepulsionLessAttractionBeyondContact)
{
    const platelet clay;
    const compressionDoubleLayer layer(clay, waterOf(0.1));
    const vanDerWaals attraction(clay);

    for (const scalar h : {1e-10, 1e-9, 1e-7})
    {
        EXPECT_DOUBLE_EQ
        (
            pairOf(0.1, true, true).force(h),
            layer.force(h) - attraction.force(h)
        );
        EXPECT_DOUBLE_EQ(pairOf(0.1, true, false).force(h), layer.force(h));
        EXPECT_DOUBLE_EQ
        (
            pairOf(0.1, false, true).force(h), -attraction.force(h)
        );
        EXPECT_EQ(pairOf(0.1, false, false).force(h), 0);
        EXPECT_DOUBLE_EQ
        (
            pairOf(0.1, true, true).slope(h),
            layer.slope(h) - attraction.slope(h)
        );
    }
}


TEST(pairInteraction, isContinuousAtContact)
{
    for (const bool repels : onOff)
    {
        for (const bool attracts : onOff)
        {
            const pairInteraction pair = pairOf(0.1, repels, attracts);
            const scalar contact = pair.contactGap();
            const scalar d = 1e-9*contact;
            const scalar scale =
                max(mag(pair.force(contact)), pair.contactStiffness()*contact);

            EXPECT_NEAR
            (
                pair.force(contact - d), pair.force(contact + d), 1e-8*scale
            );
            EXPECT_NEAR
            (
                pair.energy(contact - d),
                pair.energy(contact + d),
                1e-8*scale*contact
            );
        }
    }
}


// The bound that the class promises, from pure water to brine and for an
// attraction a hundred times the default (the parameter set Kratos)
TEST(pairInteraction, contactStopsAThermalPair)
{
    for (const scalar c : {1e-4, 0.1, 1000.0})
    {
        for (const scalar Hamaker : {0.0, 1.0291e-20, 1e-18})
        {
            platelet clay;
            clay.Hamaker = Hamaker;

            for (const bool repels : onOff)
            {
                for (const bool attracts : onOff)
                {
                    const pairInteraction pair =
                        pairOf(c, repels, attracts, 1, clay);

                    // 1e-10: the terms are up to 1e7 kT
                    EXPECT_GT
                    (
                        pair.energy(0)/waterOf(c).thermalEnergy(),
                        10 - 1e-8
                    );

                    // Repels at h = 0 and ever more where faces overlap
                    EXPECT_GT(pair.force(0), 0);
                    EXPECT_GT(pair.force(-clay.thickness), pair.force(0));
                }
            }
        }
    }
}


// Linear in contact, else by differences of fourth order
TEST(pairInteraction, forceIsMinusGradientOfEnergy)
{
    const pairInteraction pair = pairOf(0.1, true, true);

    for (const scalar h : {-1e-9, -1e-10, 0.0, 5e-11, 9e-11})
    {
        const scalar d = 1e-12;
        const scalar difference =
            (pair.energy(h + d) - pair.energy(h - d))/(2*d);

        // The energies are 1e2 times their difference
        EXPECT_LT(relativeError(pair.force(h), -difference), 1e-10) << h;
    }

    for (const scalar h : {2e-10, 1e-9, 1e-8, 1e-7})
    {
        const scalar d = 3e-3*h;
        const scalar difference =
        (
            8*(pair.energy(h + d) - pair.energy(h - d))
          - (pair.energy(h + 2*d) - pair.energy(h - 2*d))
        )/(12*d);

        EXPECT_LT(relativeError(pair.force(h), -difference), 1e-7) << h;
    }
}


TEST(pairInteraction, energyVanishesFarAway)
{
    const pairInteraction pair = pairOf(0.1, true, true);
    EXPECT_LT(mag(pair.energy(1e-4))/waterOf(0.1).thermalEnergy(), 1e-12);
    EXPECT_LT(mag(pair.energy(1))/waterOf(0.1).thermalEnergy(), 1e-20);
}


TEST(pairInteraction, slopeIsTheDerivativeOfTheForce)
{
    const pairInteraction pair = pairOf(0.1, true, true);

    for (const scalar h : {-1e-9, 5e-11, 2e-10, 1e-8, 1e-7})
    {
        const scalar d = h > 1e-10 ? 1e-3*h : 1e-12;
        const scalar difference =
        (
            8*(pair.force(h + d) - pair.force(h - d))
          - (pair.force(h + 2*d) - pair.force(h - 2*d))
        )/(12*d);

        EXPECT_LT(relativeError(pair.slope(h), difference), 1e-8) << h;
    }
}


// Physics of coarse graining: F'(alpha h) = F(h), energies times alpha. The
// contact with it
TEST(pairInteraction, parcelsAreAnExactSimilarity)
{
    const pairInteraction platelets = pairOf(0.1, true, true);

    for (const scalar alpha : {10.0, 1000.0})
    {
        const pairInteraction parcels = pairOf(0.1, true, true, alpha);

        EXPECT_DOUBLE_EQ(parcels.contactGap(), alpha*platelets.contactGap());
        EXPECT_DOUBLE_EQ
        (
            parcels.contactStiffness(), platelets.contactStiffness()/alpha
        );

        for (const scalar h : {-1e-9, 3e-11, 2e-10, 1e-8, 1e-7})
        {
            // The gap's rounding, times kappa h below 10
            EXPECT_LT
            (
                relativeError(parcels.force(alpha*h), platelets.force(h)),
                1e-13
            );
            EXPECT_LT
            (
                relativeError
                (
                    parcels.slope(alpha*h), platelets.slope(h)/alpha
                ),
                1e-13
            );
            EXPECT_LT
            (
                relativeError
                (
                    parcels.energy(alpha*h), platelets.energy(h)*alpha
                ),
                1e-12
            );
        }
    }
}


// Where the double layer repels at contact the force goes on falling with the
// gap, at no smaller rate
TEST(pairInteraction, repulsionGoesOnInContact)
{
    const pairInteraction pair = pairOf(0.1, true, false);

    // The slope changes by 1e-7 of itself over 1e-7 of the gap
    EXPECT_LT
    (
        relativeError(pair.slope(5e-11), pair.slope(1.0000001e-10)), 1e-6
    );
}


TEST(pairInteraction, keepsItsForcesAlive)
{
    auto pair = std::make_unique<pairInteraction>(pairOf(0.1, true, true));
    const pairInteraction copy(*pair);
    const scalar force = pair->force(1e-8);
    pair.reset();

    EXPECT_EQ(copy.force(1e-8), force);
}


// Anywhere from deep overlap to a metre: traps are on
TEST(pairInteraction, isFiniteEverywhere)
{
    for (const scalar c : {1e-4, 1.0, 1000.0})
    {
        const pairInteraction pair = pairOf(c, true, true);

        for (const scalar h : {-1.0, -1e-6, 0.0, 1e-10, 1e-4, 1.0, 1e15})
        {
            EXPECT_TRUE(std::isfinite(pair.force(h))) << h;
            EXPECT_TRUE(std::isfinite(pair.slope(h))) << h;
            EXPECT_TRUE(std::isfinite(pair.energy(h))) << h;
        }

        EXPECT_LT(mag(pair.force(1)), 1e-30);
    }
}


// Whatever clayProperties accepts computes without a trap: every corner of
// the valid ranges (platelet.H, water.H)
TEST(pairInteraction, isFiniteAtTheCornersOfWhatIsValid)
{
    for (const scalar diameter : {1e-9, 1e-4})
    for (const scalar thickness : {1e-10, 0.5*diameter})
    for (const scalar charge : {1e-6, 10.0})
    for (const scalar Hamaker : {0.0, 1e-15})
    for (const scalar contactGap : {1e-12, diameter})
    for (const scalar concentration : {1e-6, 6100.0})
    for (const scalar valence : {1.0, 4.0})
    for (const scalar permittivity : {1.0, 300.0})
    for (const char* model : {"compression", "weakOverlap"})
    {
        platelet clay;
        clay.diameter = diameter;
        clay.thickness = thickness;
        clay.surfaceCharge = charge;
        clay.Hamaker = Hamaker;
        clay.contactGap = contactGap;

        water solution;
        solution.concentration = concentration;
        solution.valence = valence;
        solution.relativePermittivity = permittivity;

        dictionary dict;
        dict.add("model", word(model));
        const auto layer = doubleLayer::New(dict, clay, solution);
        const vanDerWaals attraction(clay);
        const pairInteraction pair(clay, solution, &layer(), &attraction);

        for (const scalar h : {-1e-3, 0.0, 1e-12, 1e-9, 1e-6, 1e-3, 1.0})
        {
            ASSERT_TRUE(std::isfinite(pair.force(h)));
            ASSERT_TRUE(std::isfinite(pair.slope(h)));
            ASSERT_TRUE(std::isfinite(pair.energy(h)));
        }

        ASSERT_GT(pair.contactStiffness(), 0);
    }
}


// ************************************************************************* //
