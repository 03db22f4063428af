/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "erosionBracket.H"
#include "LiusClay.H"
#include "twoRegionRim.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

namespace
{

const scalar pi = std::acos(-1.0);
constexpr scalar constantD = 3e-10;

scalar D(const scalar)
{
    return constantD;
}

scalar noLoss(const scalar)
{
    return 0;
}

twoRegionRim::scene scene(const scalar holeFraction)
{
    return {0.5, 1e-3, 2700, holeFraction, GREAT, noLoss};
}

twoRegionRim::controls pseudoSteady()
{
    twoRegionRim::controls settings;
    settings.cells = 0;
    return settings;
}

// Of the clay, what does not add up
scalar imbalance(const twoRegionRim& rim)
{
    return
        (rim.clay() + rim.eroded() - rim.startClay() - rim.cameIn())
       /(rim.startClay() + rim.cameIn());
}


// Loss by rim (C) of Liu's clay, at 1e-5 m/s
std::function<scalar(scalar)> lossOfLiusClay(const LiusClay& clay)
{
    const auto E = erosionBracket
    (
        erosionBracket::matter::of
        (
            [D = clay.D](const scalar phi) { return D.value(phi); },
            clay.D.value(0),
            clay.viscosity
        ),
        clay.viscosity.gelFraction()
    ).conservative();

    return [E](const scalar radius)
    {
        return E.rate(erosionBracket::edge::around(radius, 1e-3, 1e-5), 2700);
    };
}

} // End anonymous namespace


// Of D = D1 phi^2: D1 (phi^3 - phi_R^3)/3; and back. The table's error is of
// fourth order
TEST(diffusionIntegral, isTheIntegralAndItsInverse)
{
    const auto square = [](const scalar phi) { return 1e-9*phi*phi; };
    const diffusionIntegral K(square, 0.005, 0.4);

    for (const scalar phi : {0.005, 0.00777, 0.1, 0.33, 0.4})
    {
        const scalar exact = 1e-9*(std::pow(phi, 3) - std::pow(0.005, 3))/3;
        EXPECT_NEAR(K.value(phi), exact, 1e-9*1e-9*0.0213);
        EXPECT_NEAR(K.slope(phi)/square(phi), 1, 1e-8);
        EXPECT_NEAR(K.fraction(exact)/phi, 1, 1e-7);
    }

    // With the ends' D beyond them
    EXPECT_NEAR(K.value(0.41) - K.value(0.4), 0.01*1e-9*0.16, 1e-18);
    EXPECT_NEAR(K.value(0.004), -0.001*1e-9*2.5e-5, 1e-20);
    EXPECT_NEAR(K.fraction(K.value(0.004)), 0.004, 1e-12);
    EXPECT_NEAR(K.fraction(K.value(0.41)), 0.41, 1e-12);
}


TEST(diffusionIntegral, refusesWhatDoesNotSpread)
{
    EXPECT_THROW(diffusionIntegral(D, 0.1, 0.1), Foam::error);
    EXPECT_THROW(diffusionIntegral(D, 0, 0.1), Foam::error);
    EXPECT_THROW
    (
        diffusionIntegral([](scalar phi) { return 0.3 - phi; }, 0.1, 0.4),
        Foam::error
    );
}


// Planar, since the hole is wide: s = 2 lambda sqrt(D t) with
// sqrt(pi) lambda exp(lambda^2) erf(lambda) = phi_i/phi_R - 1 (Stefan). 0.5 %
// of growth in a step err by an eighth of that
TEST(twoRegionRim, swellsAsStefansSolution)
{
    for (const scalar ratio : {1.5, 4.0, 40.0})
    {
        scalar lower = 0, upper = 5;
        while (upper - lower > 1e-12)
        {
            const scalar l = 0.5*(lower + upper);
            const scalar left =
                std::sqrt(pi)*l*std::exp(l*l)*std::erf(l);
            (left < ratio - 1 ? lower : upper) = l;
        }

        auto place = scene(0.01*ratio);
        place.holeRadius = 1e4;
        twoRegionRim::controls settings;
        settings.startRadius = 1 + 1e-8;
        twoRegionRim rim(place, D, 0.01, settings);

        // 1000 times as wide as at the start
        const scalar width = 0.1;
        const scalar time = sqr(width/(2*lower))/constantD;
        EXPECT_TRUE(rim.advance(time));

        EXPECT_NEAR((rim.radius() - 1e4)/width, 1, 3e-3) << ratio;

        const scalarField r(rim.radii()), phi(rim.fractions());
        for (const label i : {50, 100, 150})
        {
            const scalar part = (r[i] - 1e4)/(rim.radius() - 1e4);
            const scalar exact =
                1 - (1 - 1/ratio)*std::erf(lower*part)/std::erf(lower);
            EXPECT_NEAR(phi[i]/(0.01*ratio), exact, 2e-3);
        }
    }
}


// A loss that does not depend on the radius, with constant D:
// r_R = r_i exp(2 pi delta rho_s D (phi_i - phi_R)/N), and phi linear in ln r
TEST(twoRegionRim, comesToRestWhereDiffusionFeedsTheLoss)
{
    const scalar feed = 2*pi*1e-3*2700*constantD*(0.05 - 0.01);

    for (const label cells : {0, 100})
    {
        auto place = scene(0.05);
        place.lossRate = [=](const scalar) { return feed/std::log(3.0); };
        twoRegionRim::controls settings;
        settings.cells = cells;
        twoRegionRim rim(place, D, 0.01, settings);

        EXPECT_NEAR(rim.steadyRadius(), 1.5, 1e-9);

        EXPECT_TRUE(rim.advance(1e13));
        EXPECT_NEAR(rim.radius(), 1.5, 1e-6) << cells;
        EXPECT_NEAR(rim.feedRate()/rim.lossRate(), 1, 1e-6);

        const scalarField r(rim.radii()), phi(rim.fractions());
        forAll(r, i)
        {
            EXPECT_NEAR
            (
                phi[i], 0.05 - 0.04*std::log(r[i]/0.5)/std::log(3.0), 1e-8
            );
        }
    }
}


// The same for Liu's D and rim (C): where it rests, the feed by the integral
// of D is the loss
TEST(twoRegionRim, comesToRestWithLiusClayToo)
{
    const LiusClay clay;
    const auto D = [&](const scalar phi) { return clay.D.value(phi); };
    auto place = scene(0.3);
    place.lossRate = lossOfLiusClay(clay);

    twoRegionRim rim
    (
        place, D, clay.viscosity.gelFraction(), twoRegionRim::controls()
    );
    const scalar steady = rim.steadyRadius();

    EXPECT_TRUE(rim.advance(1e14));
    EXPECT_NEAR(rim.radius()/steady, 1, 1e-4);

    // By trapezoids
    scalar integral = 0;
    const scalar low = clay.viscosity.gelFraction();
    const label n = 4000;
    for (label i = 0; i < n; ++i)
    {
        integral += D(low + (0.3 - low)*(i + 0.5)/n)*(0.3 - low)/n;
    }
    EXPECT_NEAR
    (
        2*pi*1e-3*2700*integral/std::log(steady/0.5)
       /place.lossRate(steady),
        1, 1e-5
    );
}


// Slow, since the profile stores little beyond phi_R: 1 % of it, where phi_i
// is 1.02 phi_R
TEST(twoRegionRim, isPseudoSteadyWhereItIsSlow)
{
    auto place = scene(0.0102);
    place.lossRate = [](const scalar r) { return 2e-12*std::sqrt(r); };

    for (const scalar time : {1e10, 1e11})
    {
        twoRegionRim full(place, D, 0.01, twoRegionRim::controls());
        twoRegionRim steady(place, D, 0.01, pseudoSteady());
        full.advance(time);
        steady.advance(time);

        EXPECT_GT(full.radius(), 0.52);
        EXPECT_NEAR((full.radius() - 0.5)/(steady.radius() - 0.5), 1, 0.01);
        EXPECT_NE(full.radius(), steady.radius());
    }

    // And not where the profile stores much: by Stefan's solution, the
    // pseudo-steady front, s^2 = 2 D t (phi_i/phi_R - 1), is too fast
    twoRegionRim full(scene(0.04), D, 0.01, twoRegionRim::controls());
    twoRegionRim steady(scene(0.04), D, 0.01, pseudoSteady());
    full.advance(1e6);
    steady.advance(1e6);
    EXPECT_GT(steady.radius() - 0.5, 1.2*(full.radius() - 0.5));
}


// Clay in the gel and eroded is what came in, held or out of a plug, while
// the gel swells and while it is taken
TEST(twoRegionRim, conservesClay)
{
    const LiusClay clay;
    const auto D = [&](const scalar phi) { return clay.D.value(phi); };
    const scalar edge = clay.viscosity.gelFraction();

    auto place = scene(0.3);
    place.lossRate = lossOfLiusClay(clay);
    twoRegionRim held(place, D, edge, twoRegionRim::controls());
    EXPECT_TRUE(held.advance(1e10));
    EXPECT_GT(held.eroded(), 0.01*held.cameIn());
    EXPECT_LT(mag(imbalance(held)), 1e-10);

    place.plugVolume = 1e-4;
    twoRegionRim plug(place, D, edge, twoRegionRim::controls());
    scalar largest = 0;
    while (plug.advance(plug.time() + 2e6) && plug.time() < 1e10)
    {
        largest = max(largest, plug.radius());
        EXPECT_LT(mag(imbalance(plug)), 1e-10);

        // What the plug gave
        EXPECT_NEAR
        (
            plug.cameIn(), 2700*1e-4*(0.3 - plug.holeFraction()),
            1e-10*plug.cameIn()
        );
    }

    // It was spent: the rim came back
    EXPECT_LT(plug.time(), 1e10);
    EXPECT_LT(plug.radius(), 0.9*largest);
    EXPECT_GT(plug.eroded()/(plug.startClay() + plug.cameIn()), 0.9);
}


// Steps of half the size halve the error
TEST(twoRegionRim, isOfFirstOrderInTime)
{
    const auto radius = [](const scalar growth)
    {
        twoRegionRim::controls settings;
        settings.growth = growth;
        twoRegionRim rim(scene(0.05), D, 0.01, settings);
        rim.advance(1e7);
        return rim.radius();
    };

    const scalar fine = radius(0.00125);
    EXPECT_NEAR
    (
        (radius(0.02) - fine)/(radius(0.01) - fine), (0.02 - 0.00125)/0.00875,
        0.15
    );
    EXPECT_NEAR(radius(0.005)/fine, 1, 5e-4);
}


// A plug too small to move the rim: its fraction falls to the edge's over
// V ln(r_R/r_i)/(2 pi delta D). Steps of 0.5 % of it err by some thousandth
TEST(twoRegionRim, followsASmallPlugThatRunsEmpty)
{
    auto place = scene(0.05);
    place.plugVolume = 1e-12;
    twoRegionRim::controls settings(pseudoSteady());
    settings.startRadius = 2;
    twoRegionRim rim(place, D, 0.01, settings);

    const scalar time =
        place.plugVolume*std::log(2)/(2*pi*1e-3*constantD);

    for (const scalar part : {0.5, 1.0, 2.0})
    {
        EXPECT_TRUE(rim.advance(part*time));
        EXPECT_NEAR
        (
            (rim.holeFraction() - 0.01)/(0.04*std::exp(-part)), 1, 0.01
        );
    }
    EXPECT_NEAR(rim.radius(), 1, 1e-6);
}


// ************************************************************************* //
