/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusivity.H"
#include "KozenyCarmanFriction.H"
#include "compressionDoubleLayer.H"
#include "constantFriction.H"
#include "referenceTable.H"
#include "weakOverlapDoubleLayer.H"

#include "error.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::colloid;

namespace
{

diffusivity diffusivityOf
(
    const scalar concentration,
    const scalar Kozeny = 5,
    const platelet& clay = platelet()
)
{
    water solution;
    solution.concentration = concentration;

    return diffusivity
    (
        clay,
        solution,
        compressionDoubleLayer(clay, solution),
        KozenyCarmanFriction(clay, solution, Kozeny)
    );
}

} // End anonymous namespace


TEST(diffusivity, agreesWithTheReference)
{
    for (const char* table : {"colloid.csv", "suspension.csv"})
    {
        for (const referenceRow& row : referenceTable(table))
        {
            const auto D = diffusivityOf(row.at("c")).terms(row.at("phi"));

            // D itself may be a small difference of large terms
            EXPECT_LT(mag(D.sum() - row.at("D")), 1e-10*D.magnitude());

            if (row.count("D_thermal"))
            {
                EXPECT_LT
                (
                    relativeError(D.thermal, row.at("D_thermal")), 1e-10
                );
            }
        }
    }
}


TEST(diffusivity, isThatOfFreePlateletsWhereThereAreNone)
{
    const diffusivity D = diffusivityOf(0.1);

    // kT/(6 pi eta C), from numbers computed independently
    EXPECT_LT
    (
        relativeError(D.value(0), 1.380649e-23*298.15/1.20381688e-9), 1e-8
    );

    // F(phi) at 1e-19 is nothing, and its friction differs by 1e-18
    EXPECT_EQ(D.value(1e-19), D.value(0));
    EXPECT_EQ(D.value(1e-300), D.value(0));
}


// The report's Kozeny constant: D = 0.3e-9 m2/s at phi = 0.1, at every low
// concentration, with the digit that it prints
TEST(diffusivity, KozenyConstantOfKTHReproducesTheirDiffusivity)
{
    EXPECT_NEAR(diffusivityOf(0.1, 14.12).value(0.1), 0.3e-9, 0.005e-9);
}


TEST(diffusivity, doubleLayerSpreadsAndVanDerWaalsGathers)
{
    for (const scalar c : {0.01, 1.0, 100.0})
    {
        for (const scalar phi : {1e-4, 0.01, 0.1, 0.5})
        {
            const auto D = diffusivityOf(c).terms(phi);
            EXPECT_GT(D.thermal, 0);
            EXPECT_GE(D.doubleLayer, 0);
            EXPECT_LE(D.vanDerWaals, 0);
        }
    }
}


// Computed independently: +19 % at c = 0.1, +123 % at c = 0.01, nothing at
// c = 1, with the digits that these numbers have
TEST(diffusivity, farNeighboursAddWhatWasComputedForThem)
{
    const auto excess = [](const scalar c)
    {
        const diffusivity D = diffusivityOf(c);
        const auto terms = D.terms(0.01);

        return
            D.stackWithAllNeighbours(0.01)
           /(terms.doubleLayer + terms.vanDerWaals)
          - 1;
    };

    EXPECT_NEAR(excess(0.1), 0.19, 0.005);
    EXPECT_NEAR(excess(0.01), 1.23, 0.005);

    // Second neighbours' van der Waals is 1e-4 of the whole
    EXPECT_LT(mag(excess(1)), 2e-4);
}


// F = F0 exp(-kappa gap) has F' = -kappa F, so that both lattices are known:
// uniaxial kappa L^2 F/xi, isotropic L F (kappa L + 2)/(3 xi)
TEST(diffusivity, ofTheCubicLatticeIsThatOfItsPressure)
{
    platelet clay;
    clay.Hamaker = 0;
    water solution;
    solution.concentration = 0.1;

    const weakOverlapDoubleLayer layer(clay, solution);
    const diffusivity D(clay, solution, layer, constantFriction(2e-9));

    const scalar phi = 0.003;
    const scalar L = clay.cubicSpacing(phi);
    const scalar F = layer.force(L - clay.thickness);
    const scalar kappaL = solution.inverseDebyeLength()*L;

    EXPECT_LT(relativeError(D.cubicUniaxial(phi), kappaL*L*F/2e-9), 1e-13);
    EXPECT_LT
    (
        relativeError(D.cubicIsotropic(phi), L*F*(kappaL + 2)/6e-9), 1e-13
    );

    // dp/dn of p = F/L^2 by differences of second order
    const auto pressure = [&](const scalar n)
    {
        const scalar spacing = std::cbrt(1/n);
        return layer.force(spacing - clay.thickness)/(spacing*spacing);
    };

    const scalar n = phi/clay.volume();
    const scalar d = 1e-4*n;

    EXPECT_LT
    (
        relativeError
        (
            D.cubicIsotropic(phi),
            (pressure(n + d) - pressure(n - d))/(2*d)/2e-9
        ),
        1e-6
    );
}


TEST(diffusivity, timesFrictionNeedsNoFriction)
{
    EXPECT_LT
    (
        relativeError
        (
            diffusivityOf(1, 5).timesFriction(0.05),
            diffusivityOf(1, 50).timesFriction(0.05)
        ),
        1e-14
    );
}


TEST(diffusivity, refusesFractionsBeyondOne)
{
    const diffusivity D = diffusivityOf(0.1);
    EXPECT_THROW(D.value(1), Foam::error);
    EXPECT_THROW(D.value(-0.1), Foam::error);
    EXPECT_THROW(D.terms(1.2), Foam::error);
}


// ************************************************************************* //
