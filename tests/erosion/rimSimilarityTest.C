/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimSimilarity.H"

#include "LiusClay.H"

#include "error.H"
#include "interpolateXY.H"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace Foam;

namespace
{

using form = rimSimilarity::form;

constexpr form A = form::printed;
constexpr form C = form::conservative;

const scalar pi = std::acos(-1.0);

// Liu's clay in water of 0.1 mol/m3, with the default platelet
rimSimilarity::laws Liu(const bool gelStop)
{
    const LiusClay clay;
    const auto eta = clay.viscosity;
    const auto D = clay.D;

    return
    {
        [D](const scalar phi) { return D.value(phi); },
        [eta](const scalar phi) { return eta.uncappedViscosity(phi); },
        D.value(0),
        gelStop ? eta.gelFraction() : GREAT
    };
}


rimSimilarity::laws constantD(const scalar relative)
{
    return
    {
        [=](const scalar) { return relative*3e-12; },
        [](const scalar) { return 1; },
        3e-12
    };
}


// Clay that the profile carries past, in the unit of q0: the integral of
// 2 phi f' dz, which is 2 phi/eta_r dz
scalar carriedAway
(
    const rimSimilarity& rim,
    const rimSimilarity::laws& matter
)
{
    scalar sum = 0;
    const scalarField& phi = rim.fractions();
    const scalarField& z = rim.distances();

    for (label i = 1; i + 1 < phi.size(); ++i)
    {
        const scalar middle = 0.5*(phi[i] + phi[i + 1]);
        if (middle < matter.flowFraction)
        {
            sum += (z[i] - z[i + 1])*middle/matter.viscosity(middle);
        }
    }
    return sum;
}

} // End anonymous namespace


// The values of an independent program (50 digits), to 0.05 %
TEST(rimSimilarity, hasThePublishedLossOfLiusClay)
{
    const auto expectLoss = []
    (
        const form equation,
        const scalar edge,
        const bool gelStop,
        const scalar loss
    )
    {
        EXPECT_NEAR
        (
            rimSimilarity(equation, Liu(gelStop), edge).edgeLoss()/loss, 1, 2e-4
        ) << edge << ' ' << loss;
    };

    const scalar gel = 0.0054093;
    expectLoss(A, gel, false, 0.019867);
    expectLoss(C, gel, false, 0.012028);
    expectLoss(A, 0.01, false, 0.065730);
    expectLoss(C, 0.01, false, 0.028361);

    // The layer above the gel's fraction only conducts
    expectLoss(C, gel, true, 0.012028);
    expectLoss(C, 0.01, true, 0.012028);
    expectLoss(C, 0.1, true, 0.012028);
    expectLoss(A, 0.01, true, 0.019867);
}


// The D of spheres (doc/theory.md), of which 0.01685, and 0.01676 to 0.01724
// by the fit, was computed independently
TEST(rimSimilarity, hasThePublishedLossOfSpheres)
{
    rimSimilarity::laws matter(Liu(false));

    const scalarField phi
    (
        scalarList{0, 1e-4, 1e-3, 2e-3, 3.5e-3, 5.41e-3, 8e-3}
    );
    const scalarField D(scalarList{3.42, 4.1, 18, 52, 114, 180, 260});
    matter.diffusivity = [=](const scalar fraction)
    {
        return 1e-12*interpolateXY(fraction, phi, D);
    };

    const scalar loss = rimSimilarity(C, matter, 0.0054093).edgeLoss();
    EXPECT_GT(loss, 0.01676);
    EXPECT_LT(loss, 0.01724);
}


// Constant D, eta_r = 1: phi = phi_R erfc(z/sqrt(D_r))
TEST(rimSimilarity, ofConstantDIsTheErrorFunction)
{
    for (const form equation : {A, C})
    {
        for (const scalar relative : {0.01, 1.0, 100.0})
        {
            const rimSimilarity rim(equation, constantD(relative), 0.02);

            EXPECT_NEAR
            (
                rim.edgeLoss()/(0.02*2*std::sqrt(relative/pi)), 1, 1e-4
            );

            for (const scalar z : {0.1, 0.5, 1.0, 1.5})
            {
                EXPECT_NEAR
                (
                    rim.fraction(z*std::sqrt(relative)), 0.02*std::erfc(z),
                    2e-4*0.02
                ) << z;
            }
        }
    }
}


// (C): phi = exp(-z) solves it for D_r = eta_r (1 - ln phi)/2 (edge at 1),
// where q = phi (1 - ln phi); here with the edge at phi_R
TEST(rimSimilarity, conservativeFormHasTheSolutionOfAGivenD)
{
    const scalar edge = 0.03;
    const auto eta = [=](const scalar phi) { return 1 + 5*phi/edge; };

    const rimSimilarity rim
    (
        C,
        {
            [=](const scalar phi)
            {
                return 1e-11*eta(phi)*(1 - std::log(phi/edge))/2;
            },
            eta,
            1e-11
        },
        edge
    );

    EXPECT_NEAR(rim.edgeLoss()/edge, 1, 1e-4);
}


// (A): q = sin(pi phi/2) with eta_r = 1 + phi^2, D from
// (eta_r q')' = -2 D_r/q, with phi over that of the edge
TEST(rimSimilarity, printedFormHasTheSolutionOfAGivenD)
{
    const scalar edge = 0.03;
    const rimSimilarity rim
    (
        A,
        {
            [=](const scalar fraction)
            {
                const scalar phi = fraction/edge;
                const scalar s = std::sin(pi*phi/2);
                const scalar c = std::cos(pi*phi/2);
                return
                    1e-11*s/2*((1 + phi*phi)*pi*pi/4*s - phi*pi*c);
            },
            [=](const scalar fraction) { return 1 + sqr(fraction/edge); },
            1e-11
        },
        edge
    );

    EXPECT_NEAR(rim.edgeLoss()/edge, 1, 1e-4);
}


// What leaves the edge is what the water carries, in form (C); 2.3 to 5.9
// times less in form (A) (physics of the report's clay)
TEST(rimSimilarity, conservativeFormConservesClay)
{
    for (const bool gelStop : {true, false})
    {
        const auto matter = Liu(gelStop);
        const rimSimilarity rim(C, matter, 0.01);
        EXPECT_NEAR(2*carriedAway(rim, matter)/rim.edgeLoss(), 1, 1e-3);
    }

    for (const scalar edge : {0.0054093, 0.01})
    {
        const auto matter = Liu(false);
        const rimSimilarity rim(A, matter, edge);
        const scalar ratio = rim.edgeLoss()/(2*carriedAway(rim, matter));
        EXPECT_GT(ratio, 2.2);
        EXPECT_LT(ratio, 6.0);
    }
}


// The unit of D is a matter of words
TEST(rimSimilarity, lossTimesRootOfTheUnitIsTheSame)
{
    auto matter = Liu(true);
    const scalar loss = rimSimilarity(C, matter, 0.0054).edgeLoss();
    matter.freeDiffusivity *= 100;
    EXPECT_NEAR
    (
        rimSimilarity(C, matter, 0.0054).edgeLoss()*10/loss, 1, 1e-9
    );
}


// Steps of D by decades, at fractions that are no nodes: the error of 400
// intervals against eight times as many
TEST(rimSimilarity, takesStepsOverDecades)
{
    rimSimilarity::laws matter(constantD(1));
    matter.diffusivity = [](const scalar phi)
    {
        return phi < 1.7e-4 ? 1e-12 : phi < 2.3e-3 ? 1e-15 : 1e-9;
    };

    for (const form equation : {A, C})
    {
        const scalar coarse = rimSimilarity(equation, matter, 0.01).edgeLoss();
        const scalar fine =
            rimSimilarity(equation, matter, 0.01, 3200).edgeLoss();
        EXPECT_NEAR(coarse/fine, 1, 1e-3);
    }
}


// D in ten random steps over eight decades, viscosity up to 1e6: what -sweep may
// meet. The clay still adds up, to what 400 intervals make of steps
TEST(rimSimilarity, findsTheProfileOfAnyD)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<scalar> decades(-8, 0), gel(0, 6);

    for (label trial = 0; trial < 200; ++trial)
    {
        scalarField D(10);
        for (scalar& value : D)
        {
            value = 1e-8*std::pow(10, decades(random));
        }
        const scalar stiff = gel(random);

        const rimSimilarity::laws matter
        {
            [=](const scalar phi) { return D[min(label(phi/0.002), label(9))]; },
            [=](const scalar phi) { return std::pow(10, stiff*phi/0.02); },
            1e-11
        };

        for (const form equation : {A, C})
        {
            const rimSimilarity rim(equation, matter, 0.02);
            const scalar lost = rim.edgeLoss();
            EXPECT_GT(lost, 0) << trial;
            EXPECT_NEAR
            (
                rimSimilarity(equation, matter, 0.02, 1600).edgeLoss()/lost,
                1, 0.02
            );

            if (equation == C)
            {
                EXPECT_NEAR(2*carriedAway(rim, matter)/lost, 1, 0.02) << trial;
            }
        }
    }
}


TEST(rimSimilarity, profileFallsFromTheEdge)
{
    const rimSimilarity rim(C, Liu(true), 0.01);

    EXPECT_NEAR(rim.fraction(0), 0.01, 1e-12);
    EXPECT_EQ(rim.distance(0.01), 0);
    EXPECT_EQ(rim.distance(0), GREAT);
    EXPECT_EQ(rim.fraction(GREAT), 0);

    for (const scalar phi : {1e-6, 1e-3, 0.0054, 0.007})
    {
        EXPECT_NEAR(rim.fraction(rim.distance(phi))/phi, 1, 1e-9);
    }

    for (label i = 1; i < rim.fractions().size(); ++i)
    {
        EXPECT_GT(rim.fractions()[i], rim.fractions()[i - 1]);
        EXPECT_LT(rim.distances()[i], rim.distances()[i - 1]);
    }
}


TEST(rimSimilarity, refusesWhatHasNoRim)
{
    auto matter = constantD(1);
    EXPECT_THROW(rimSimilarity(C, matter, 0), Foam::error);
    EXPECT_THROW(rimSimilarity(C, matter, 1), Foam::error);

    matter.diffusivity = [](const scalar phi) { return phi - 0.005; };
    EXPECT_THROW(rimSimilarity(C, matter, 0.01), Foam::error);
}


// ************************************************************************* //
