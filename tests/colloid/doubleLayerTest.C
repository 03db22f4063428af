/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "compressionDoubleLayer.H"
#include "exponentialDoubleLayer.H"
#include "weakOverlapDoubleLayer.H"
#include "physicalConstants.H"
#include "referenceTable.H"

#include "IStringStream.H"
#include "error.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::colloid;

namespace
{

const scalar concentrations[] = {1e-4, 1e-3, 0.01, 0.1, 1, 10, 100, 1000};

water waterOf(const scalar concentration)
{
    water solution;
    solution.concentration = concentration;
    return solution;
}

dictionary parse(const char* text)
{
    IStringStream stream(text);
    return dictionary(stream);
}

autoPtr<doubleLayer> newModel(const char* text, const scalar concentration)
{
    return doubleLayer::New(parse(text), platelet(), waterOf(concentration));
}

const char* const models[] =
{
    "model compression;",
    "model weakOverlap;",
    "model exponential; P0 1500; kappa 7.34e6;",
    "model exponential; P0 1500; kappa 7.34e6; distance centres;"
};


// The formulas of eq. 3-8 to 3-13 as they are written, in long double: slow,
// and 1 - t^2 cancels four digits of nineteen
struct plainCompression
{
    long double kappa, g, scale;

    plainCompression(const platelet& clay, const scalar concentration)
    {
        using namespace physicalConstants;

        const water w = waterOf(concentration);
        const long double RT = gas*w.temperature;
        const long double permittivity =
            vacuumPermittivity*w.relativePermittivity;

        kappa = sqrtl
        (
            2.0L*concentration*Faraday*Faraday*w.valence*w.valence
           /(permittivity*RT)
        );

        const long double y0 = 2*asinhl
        (
            w.valence*Faraday*clay.surfaceCharge/(2*permittivity*kappa*RT)
        );

        g = tanhl(y0/4);
        scale = 2*concentration*RT*clay.faceArea();
    }

    long double S(const long double h) const
    {
        const long double t = g*expl(-kappa*h/2);
        const long double s = g*expl(-kappa*h);

        return
            8*t*(1 + t*t)/((1 - t*t)*(1 - t*t))
          + 8*s/(kappa*h*(1 - s*s));
    }

    long double slopeOfS(const long double h) const
    {
        const long double t = g*expl(-kappa*h/2);
        const long double s = g*expl(-kappa*h);

        return
          - 4*kappa*t*(1 + 6*t*t + t*t*t*t)/powl(1 - t*t, 3)
          - 8*s/(kappa*h*h*(1 - s*s))
          - 8*s*(1 + s*s)/(h*(1 - s*s)*(1 - s*s));
    }

    // S^2 rather than cosh(y_m) - 1, which would cancel
    scalar force(const scalar h) const
    {
        const long double s = S(h);
        return scale*s*s/(1 + sqrtl(1 + s*s));
    }

    scalar slope(const scalar h) const
    {
        const long double s = S(h);
        return scale*s*slopeOfS(h)/sqrtl(1 + s*s);
    }
};

} // End anonymous namespace


TEST(water, agreesWithTheReference)
{
    for (const referenceRow& row : referenceTable("colloid.csv"))
    {
        const water w = waterOf(row.at("c"));
        EXPECT_LT
        (
            relativeError(w.inverseDebyeLength(), row.at("kappa")), 1e-10
        );
        EXPECT_LT
        (
            relativeError(w.surfacePotential(platelet()), row.at("y0")), 1e-10
        );
    }
}


// kappa grows with the valence and y0 does not depend on it at first order:
// a 2:2 salt has the Debye length of a 1:1 salt of four times the
// concentration
TEST(water, doubledValenceIsFourfoldConcentration)
{
    water two = waterOf(1);
    two.valence = 2;

    EXPECT_DOUBLE_EQ
    (
        two.inverseDebyeLength(), waterOf(4).inverseDebyeLength()
    );
}


TEST(doubleLayer, compressionAgreesWithTheReference)
{
    const platelet clay;

    for (const referenceRow& row : referenceTable("colloid.csv"))
    {
        const compressionDoubleLayer layer(clay, waterOf(row.at("c")));
        const scalar h = row.at("h");

        EXPECT_LT(relativeError(layer.force(h), row.at("F_DDL")), 1e-10);
        EXPECT_LT(relativeError(layer.slope(h), row.at("dF_DDL")), 1e-10);
        EXPECT_LT(relativeError(layer.midPotential(h), row.at("ym")), 1e-10);
    }

    for (const referenceRow& row : referenceTable("suspension.csv"))
    {
        const compressionDoubleLayer layer(clay, waterOf(row.at("c")));
        const scalar reference = row.at("F_DDL");

        // Below the smallest double a force is zero
        if (reference > VSMALL)
        {
            EXPECT_LT
            (
                relativeError(layer.force(row.at("h")), reference), 1e-10
            );
        }
    }
}


// exp(-kappa h) turns a rounding of kappa h, up to 700, into 1e-13. Charges
// from nearly none to ten times montmorillonite's
TEST(doubleLayer, compressionAgreesWithItsPlainTwin)
{
    for (const scalar c : concentrations)
    for (const scalar charge : {1e-5, 1e-3, 0.02, 0.131, 1.0})
    {
        platelet clay;
        clay.surfaceCharge = charge;

        const compressionDoubleLayer layer(clay, waterOf(c));
        const plainCompression plain(clay, c);

        for (scalar h = 1e-10; h < 1.1e-4; h *= 1.21)
        {
            if (plain.force(h) > 1e-250)
            {
                ASSERT_LT(relativeError(layer.force(h), plain.force(h)), 1e-12)
                    << c << ' ' << h;
                ASSERT_LT(relativeError(layer.slope(h), plain.slope(h)), 1e-12)
                    << c << ' ' << h;
            }
        }
    }
}


// F falls with every step of 0.1 % until it is zero. Floating-point traps are
// on in this program
TEST(doubleLayer, isFiniteAndFallsMonotonically)
{
    for (const char* model : models)
    {
        for (const scalar c : concentrations)
        {
            const auto layer = newModel(model, c);
            scalar previous = GREAT;

            for (scalar h = 1e-10; h < 1.001e-4; h *= 1.001)
            {
                const scalar force = layer->force(h);
                const scalar slope = layer->slope(h);

                ASSERT_TRUE(std::isfinite(force) && std::isfinite(slope));
                ASSERT_LE(slope, 0);

                // Subnormal numbers have few digits
                if (force > 1e-300)
                {
                    ASSERT_LT(force, previous) << model << c << ' ' << h;
                    ASSERT_LT(slope, 0);
                }
                else
                {
                    ASSERT_LE(force, previous);
                    ASSERT_GE(force, 0);
                }

                previous = force;
            }

            for (const scalar h : {1e-3, 1.0, 1e15})
            {
                EXPECT_GE(layer->force(h), 0);
                EXPECT_LT(layer->force(h), 1e-100);
                EXPECT_LT(mag(layer->slope(h)), 1e-100);
                EXPECT_LT(layer->energy(h), 1e-100);
            }
        }
    }
}


// Differences of fourth order: (d/h)^4 and (kappa d)^4 times numbers below
// 100, and rounding over d
TEST(doubleLayer, slopeIsTheDerivativeOfTheForce)
{
    for (const char* model : models)
    {
        for (const scalar c : concentrations)
        {
            const auto layer = newModel(model, c);

            for (scalar h = 1e-10; h < 1e-5; h *= 2.3)
            {
                if (layer->force(h) < 1e-250)
                {
                    continue;
                }

                const scalar d = 1e-3*min(h, layer->decayLength());
                const scalar difference =
                (
                    8*(layer->force(h + d) - layer->force(h - d))
                  - (layer->force(h + 2*d) - layer->force(h - 2*d))
                )/(12*d);

                EXPECT_LT(relativeError(layer->slope(h), difference), 1e-8)
                    << model << c << ' ' << h;
            }
        }
    }
}


// As above: the energy's quadrature is exact to rounding
TEST(doubleLayer, forceIsMinusGradientOfEnergy)
{
    for (const char* model : models)
    {
        for (const scalar c : {1e-4, 0.1, 100.0})
        {
            const auto layer = newModel(model, c);

            for (scalar h = 1e-10; h < 1e-5; h *= 5.7)
            {
                if (layer->force(h) < 1e-250)
                {
                    continue;
                }

                const scalar d = 3e-3*min(h, layer->decayLength());
                const scalar difference =
                (
                    8*(layer->energy(h + d) - layer->energy(h - d))
                  - (layer->energy(h + 2*d) - layer->energy(h - 2*d))
                )/(12*d);

                EXPECT_LT(relativeError(layer->force(h), -difference), 1e-8)
                    << model << c << ' ' << h;
            }
        }
    }
}


// Simpson's rule from h to where the force is 1e-17 of its value, in
// x = ln(gap), 40000 intervals; the rest is below 1e-13
TEST(doubleLayer, energyVanishesFarAway)
{
    for (const scalar c : {1e-4, 0.1, 100.0})
    {
        const auto layer = newModel("model compression;", c);
        const scalar h = 1e-9;
        const scalar end = h + 60*layer->decayLength();

        const label n = 40000;
        const scalar step = std::log(end/h)/n;
        scalar sum = 0;

        for (label i = 0; i <= n; ++i)
        {
            const scalar x = h*std::exp(i*step);
            const scalar weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
            sum += weight*layer->force(x)*x;
        }

        EXPECT_LT(relativeError(layer->energy(h), sum*step/3), 1e-10) << c;
    }
}


// Integrated with 50 digits by another program (default platelet)
TEST(doubleLayer, energyIsWhatWasComputedWith50Digits)
{
    const scalar known[][3] =
    {
        {1e-4, 1e-10, 6.3546658795515236e-16},
        {0.1, 1e-9, 1.9647911920421663e-16},
        {0.1, 1e-7, 5.2355625127420637e-19},
        {1000, 1e-10, 3.2509691547198642e-16},
        {1000, 1e-8, 1.6006316665277226e-30}
    };

    for (const auto& [c, h, energy] : known)
    {
        EXPECT_LT
        (
            relativeError
            (
                compressionDoubleLayer(platelet(), waterOf(c)).energy(h),
                energy
            ),
            1e-13
        ) << c << ' ' << h;
    }
}


// Apart, compression tends to weak overlap: their ratio differs from 1 by
// 2/(kappa h) exp(-kappa h/2)
TEST(doubleLayer, compressionTendsToWeakOverlap)
{
    for (const scalar c : concentrations)
    {
        const auto layer = newModel("model compression;", c);
        const auto weak = newModel("model weakOverlap;", c);
        const scalar h = 50*layer->decayLength();

        EXPECT_LT(relativeError(layer->force(h), weak->force(h)), 1e-9) << c;
    }
}


// F = P0 S_p exp(-kappa x) by hand: 1500 Pa, 100 nm, 3.14159e-14 m2
TEST(doubleLayer, exponentialIsItsFormulaOfGapOrCentres)
{
    const scalar face = platelet().faceArea();

    const auto gap = newModel("model exponential; P0 1500; kappa 7.34e6;", 1);
    EXPECT_DOUBLE_EQ
    (
        gap->force(1e-7), 1500*face*std::exp(-0.734)
    );

    const auto centres = newModel
    (
        "model exponential; P0 1500; kappa 7.34e6; distance centres;", 1
    );
    EXPECT_NEAR
    (
        centres->force(9.9e-8)/(1500*face*std::exp(-0.734)), 1, 1e-14
    );
}


TEST(doubleLayer, isCompressionByDefault)
{
    EXPECT_EQ(newModel("", 1)->type(), "compression");
}


TEST(doubleLayer, refusesUnknownModelsAndEntries)
{
    EXPECT_THROW(newModel("model compresion;", 1), Foam::error);
    EXPECT_THROW(newModel("model compression; P0 1;", 1), Foam::error);
    EXPECT_THROW(newModel("model weakOverlap; kappa 1;", 1), Foam::error);
    EXPECT_THROW(newModel("model exponential; P0 1;", 1), Foam::error);
    EXPECT_THROW(newModel("model exponential; kappa 1e7;", 1), Foam::error);
    EXPECT_THROW
    (
        newModel("model exponential; P0 1; kappa -1e7;", 1), Foam::error
    );
    EXPECT_THROW
    (
        newModel("model exponential; P0 1; kappa 1e7; distance middle;", 1),
        Foam::error
    );
}


TEST(doubleLayer, refusesGapsThatAreNotPositive)
{
    const auto layer = newModel("model compression;", 1);
    EXPECT_THROW(layer->force(0), Foam::error);
    EXPECT_THROW(layer->slope(-1e-9), Foam::error);
    EXPECT_THROW(layer->energy(0), Foam::error);
}


// ************************************************************************* //
