/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fracturePlane.H"
#include "HeleShawFlow.H"
#include "surfaceFields.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using fractureFlows::HeleShawFlow;

//- What leaves through the outlet [m3/s]
static scalar outflow(const fractureFlow& flow)
{
    return gSum(flow.phi().boundaryField()[1]);
}

static scalar largestError
(
    const fractureFlow& flow,
    const std::function<vector(const vector&)>& exact
)
{
    scalar error = 0;
    forAll(flow.U(), i)
    {
        error = max(error, mag(flow.U()[i] - exact(flow.mesh().C()[i])));
    }
    return returnReduce(error, maxOp<scalar>());
}


// Water of 1e-6 m2/s, 1 m2/s2 over 2 m: U = b^2/(12 nu)/2, whatever the mesh's
// thickness
TEST(HeleShaw, parallelPlatesFollowTheCubicLaw)
{
    for (const scalar b : {1e-3, 2e-3})
    {
        for (const scalar ratio : {1., 7.})
        {
            fracturePlane c;
            c.setViscosity([&](const vector&) { return ratio; });
            auto flow = c.HeleShaw("aperture " + Foam::name(b) + ";");
            flow->solve();

            const vector U(sqr(b)/(12e-6*ratio)/2, 0, 0);

            // The residual; setViscosity is exact to 1e-13
            EXPECT_LT
            (
                largestError(*flow, [&](const vector&) { return U; }),
                1e-9*U.x()
            );
            EXPECT_NEAR(outflow(*flow), b*U.x(), 1e-9*b*U.x());
            EXPECT_NEAR
            (
                gMax(mag(flow->apertureRatio().primitiveField() - b/0.01)()),
                0,
                1e-12
            );
        }
    }
}


// Each half takes the part of p that its resistance is; the discharge is the
// same in both, and U follows the aperture
TEST(HeleShaw, twoAperturesInSeriesAreExact)
{
    const auto b = [](const vector& x) { return x.x() < 1 ? 1e-3 : 2e-3; };
    const scalar discharge = 1/(12e-6*(1/pow3(1e-3) + 1/pow3(2e-3)));

    for (const word folder : {"0", "constant"})
    {
        fracturePlane c;
        c.writePlaneField("b", "[0 1 0 0 0 0 0]", b, folder);
        auto flow = c.HeleShaw("aperture b;");
        flow->solve();

        EXPECT_NEAR(outflow(*flow), discharge, 1e-9*discharge);
        EXPECT_LT
        (
            largestError
            (
                *flow,
                [&](const vector& x) { return vector(discharge/b(x), 0, 0); }
            ),
            1e-9*discharge/1e-3
        );
    }
}


// T = g b^3/(12 nu)
TEST(HeleShaw, transmissivityIsThatOfItsAperture)
{
    const scalar b = std::cbrt(12e-6*1e-5/9.80665);

    fracturePlane c;
    c.writePlaneField
    (
        "T", "[0 2 -1 0 0 0 0]", [](const vector&) { return 1e-5; }, "0"
    );

    for (const string given : {"1e-5", "T"})
    {
        auto flow = c.HeleShaw("transmissivity " + given + ";");
        flow->solve();

        // Head gradient 1/(2 g), width 1 m
        EXPECT_NEAR(outflow(*flow), 1e-5/(2*9.80665), 1e-14);
        EXPECT_NEAR
        (
            gMax(mag(flow->apertureRatio().primitiveField() - b/0.01)()),
            0,
            1e-12
        );
    }
}


TEST(HeleShaw, apertureOfAFieldIsWrittenForTheRestart)
{
    fracturePlane c;
    c.writePlaneField
    (
        "b", "[0 1 0 0 0 0 0]", [](const vector&) { return 1e-3; }, "constant"
    );
    auto flow = c.HeleShaw("aperture b;");
    EXPECT_EQ
    (
        c.mesh().lookupObject<volScalarField>("b").writeOpt(),
        IOobject::AUTO_WRITE
    );
    EXPECT_EQ
    (
        c.mesh().lookupObject<volScalarField>("b").instance(),
        c.time().timeName()
    );
}


//- Half a ring between radii 1 and 4, the water given as uniform on the outer
static boxSpec halfRing(const label n)
{
    boxSpec spec;
    spec.cells = {n, n, 1};
    spec.patches = {"inner", "outer", "end0", "end1", "back", "front"};
    spec.types = {"wall", "patch", "wall", "wall", "empty", "empty"};
    spec.map = [](const vector& x)
    {
        const scalar r = std::pow(4, x.x());
        const scalar angle = constant::mathematical::pi*x.y();
        return vector(r*std::cos(angle), r*std::sin(angle), 0.1*x.z());
    };
    return spec;
}

// Potential flow with the radial velocity cos(theta) at r = 4:
//     u_r = A (1 - 1/r^2) cos(theta), u_theta = -A (1 + 1/r^2) sin(theta),
// A = 1/(1 - 1/16), slip 2 A sin(theta)
static scalar ringError(const label n)
{
    flowCase c(halfRing(n));
    c.writeU
    ({
        {"inner", "type noSlip;"},
        {"outer", "type fixedValue; value uniform (1 0 0);"},
        {"end0", "type slip;"},
        {"end1", "type slip;"}
    });
    c.writeP
    ({
        {"inner", "type zeroGradient;"},
        {"outer", "type fixedFluxPressure;"},
        {"end0", "type zeroGradient;"},
        {"end1", "type zeroGradient;"}
    });
    auto flow = c.newFlow("model HeleShaw; HeleShawCoeffs { aperture 1e-3; }");
    flow->solve();

    EXPECT_LT(relativeDivergence(*flow), 1e-10);

    return largestError
    (
        *flow,
        [](const vector& x)
        {
            const scalar r = std::hypot(x.x(), x.y());
            const scalar a = 1/(1 - 1./16);
            const vector radial(x.x()/r, x.y()/r, 0);
            const vector along(-radial.y(), radial.x(), 0);
            return
                a*(1 - 1/sqr(r))*radial.x()*radial
              - a*(1 + 1/sqr(r))*radial.y()*along;
        }
    );
}


TEST(HeleShaw, slipRoundAnObstacleIsTwiceTheSine)
{
    const scalar coarse = ringError(16);
    const scalar fine = ringError(32);

    // Of a slip of 32/15. Second order; 3.99 from 64 to 128 cells
    EXPECT_LT(fine, 0.005);
    EXPECT_GT(coarse/fine, 3.6);
}


// A disc of gel, radius 0.1, in a plane of water, in steps of cells: at twice
// the radius beside it the water is faster by 1/4
static scalar speedBesideGel(const label n)
{
    boxSpec spec = fracturePlane::spec(n);
    spec.cells[0] = n;
    spec.size.x() = 1;
    fracturePlane c(spec);
    c.writeInlet
    (
        "type fixedValue; value uniform (1e-5 0 0);", "type zeroGradient;"
    );

    const auto radius = [](const vector& x)
    {
        return std::hypot(x.x() - 0.5, x.y());
    };
    c.setViscosity([&](const vector& x) { return radius(x) < 0.1 ? 1e6 : 1; });

    auto flow = c.HeleShaw("aperture 1e-3;");
    flow->solve();
    EXPECT_LT(relativeDivergence(*flow), 1e-10);

    scalar inGel = 0;
    scalar beside = 0;
    scalar number = 0;
    forAll(flow->U(), i)
    {
        const vector x = c.mesh().C()[i];
        if (radius(x) < 0.1 - 2./n)
        {
            inGel = max(inGel, mag(flow->U()[i]));
        }
        if (mag(x.x() - 0.5) < 1.01/n && mag(x.y() - 0.2) < 0.75/n)
        {
            beside += flow->U()[i].x();
            number += 1;
        }
    }
    EXPECT_LT(returnReduce(inGel, maxOp<scalar>()), 1e-5*1e-5);

    return
        returnReduce(beside, sumOp<scalar>())
       /returnReduce(number, sumOp<scalar>())/1e-5;
}


TEST(HeleShaw, gelIsAnObstacle)
{
    // 1.25 without bounds. Images of the disc in the ends and the upper edge
    // add 2 (0.1/1)^2 and less, the steps of its rim a tenth of a cell or so
    EXPECT_NEAR(speedBesideGel(80), 1.25, 0.04);
}


//- An aperture that varies by 30 times, and pieces of gel, none of it aligned
static scalar roughAperture(const vector& x)
{
    return 1e-3*std::exp(1.7*std::sin(5*x.x() + 1)*std::cos(7*x.y() + x.x()));
}

static scalar gelPieces(const vector& x)
{
    return std::sin(9*x.x() + 1)*std::sin(11*x.y() + 0.3) > 0.3 ? 1e6 : 1;
}

//- What the outlet passes of n by 2n square cells by the same equations, solved
//  by elimination
static scalar plainTwin(const label n)
{
    const label nx = 2*n;
    const label size = nx*n;
    const auto conductance = [&](label i, label j)
    {
        const vector x((i + 0.5)/n, (j + 0.5)/n, 0);
        return pow3(roughAperture(x))/(12e-6*gelPieces(x));
    };

    // Band matrix: columns are numbered along y first
    List<scalarField> a(size, scalarField(2*n + 1, Zero));
    scalarField p(size, Zero);
    const auto join = [&](label row, label other, scalar k)
    {
        a[row][n] += k;
        a[row][n + other - row] -= k;
    };
    for (label i = 0; i < nx; ++i)
    for (label j = 0; j < n; ++j)
    {
        const label row = j + n*i;
        const scalar k = conductance(i, j);
        if (i == 0)
        {
            a[row][n] += 2*k;
            p[row] += 2*k;
        }
        if (i == nx - 1)
        {
            a[row][n] += 2*k;
        }
        if (i + 1 < nx)
        {
            const scalar face = 2/(1/k + 1/conductance(i + 1, j));
            join(row, row + n, face);
            join(row + n, row, face);
        }
        if (j + 1 < n)
        {
            const scalar face = 2/(1/k + 1/conductance(i, j + 1));
            join(row, row + 1, face);
            join(row + 1, row, face);
        }
    }

    for (label row = 0; row < size; ++row)
    {
        for (label below = row + 1; below <= min(row + n, size - 1); ++below)
        {
            const scalar factor = a[below][n + row - below]/a[row][n];
            for (label column = row; column <= min(row + n, size - 1); ++column)
            {
                a[below][n + column - below] -= factor*a[row][n + column - row];
            }
            p[below] -= factor*p[row];
        }
    }
    for (label row = size - 1; row >= 0; --row)
    {
        for (label column = row + 1; column <= min(row + n, size - 1); ++column)
        {
            p[row] -= a[row][n + column - row]*p[column];
        }
        p[row] /= a[row][n];
    }

    scalar result = 0;
    for (label j = 0; j < n; ++j)
    {
        result += 2*conductance(nx - 1, j)*p[j + n*(nx - 1)];
    }
    return result;
}


TEST(HeleShaw, flowOnAnyNumberOfRanksIsThatOfThePlainTwin)
{
    const label n = 20;
    fracturePlane c(fracturePlane::spec(n));
    c.writePlaneField("b", "[0 1 0 0 0 0 0]", roughAperture, "0");
    c.setViscosity(gelPieces);

    auto flow = c.HeleShaw("aperture b;");
    flow->solve();

    const scalar expected = plainTwin(n);

    // The viscosity's bisection, and 1e-10 at its condition number
    EXPECT_NEAR(outflow(*flow), expected, 1e-8*expected);
    EXPECT_NEAR(gSum(flow->phi().boundaryField()[0]), -expected, 1e-8*expected);
    EXPECT_LT(relativeDivergence(*flow), 1e-10);

    // What stands takes nothing
    flow->solve();
    EXPECT_EQ(refCast<const HeleShawFlow>(*flow).iterations(), 0);
}


// Cells sheared by 30 degrees: no smaller conservation, and the flow of plates
TEST(HeleShaw, shearedCellsConserveToo)
{
    boxSpec spec = fracturePlane::spec();
    spec.map = [](const vector& x)
    {
        return vector(x.x() + 0.2887*(x.y() - 0.5), x.y(), x.z());
    };
    spec.types[0] = spec.types[1] = "cyclic";
    flowCase c(spec);
    c.writeU({{"bottom", "type slip;"}, {"top", "type slip;"}});
    c.writeP({{"bottom", "type zeroGradient;"}, {"top", "type zeroGradient;"}});
    c.setViscosity([](const vector& x) { return x.y() < 0.5 ? 1 : 3; });
    auto flow = c.newFlow
    (
        "model HeleShaw; HeleShawCoeffs"
        "{ aperture 1e-3; pressureGradient (-500 0 0); }"
    );
    flow->solve();

    EXPECT_LT(relativeDivergence(*flow), 1e-10);

    // 500 Pa/m over 1000 kg/m3
    const scalar U = 1e-6/12e-6*0.5;
    EXPECT_LT
    (
        largestError
        (
            *flow,
            [&](const vector& x) { return vector(x.y() < 0.5 ? U : U/3, 0, 0); }
        ),
        1e-8*U
    );
}


TEST(HeleShaw, inflowIsWhatTheInletSays)
{
    // 1e-5 m/s over 1e-3 m by 1 m; the same by the gradient of p
    const scalar expected = 1e-5*1e-3;

    fracturePlane c;
    for (const auto& [U, p] : std::map<string, string>
    {
        {"type fixedValue; value uniform (1e-5 0 0);", "type zeroGradient;"},
        {
            "type zeroGradient;",
            "type fixedGradient; gradient uniform 1.2e-4;"
        },
        {
            "type surfaceNormalFixedValue; refValue uniform -1e-5;",
            "type fixedFluxPressure;"
        }
    })
    {
        c.writeInlet(U, p);
        auto flow = c.HeleShaw("aperture 1e-3;");
        flow->solve();
        EXPECT_NEAR(outflow(*flow), expected, 1e-9*expected) << U;
        EXPECT_NEAR
        (
            gSum(flow->phi().boundaryField()[0]), -expected, 1e-9*expected
        ) << U;

        // p rises against the flow, to the inlet's value too: 2 m of it
        EXPECT_NEAR
        (
            gMax(refCast<const HeleShawFlow>(*flow).p().primitiveField()),
            1.2e-4*1.95,
            1e-9
        ) << U;
    }
}


TEST(HeleShaw, nothingThatDrivesIsWaterAtRest)
{
    fracturePlane c;
    c.writeInlet("type zeroGradient;", "type fixedValue; value uniform 0;");
    auto flow = c.HeleShaw("aperture 1e-3;");
    flow->solve();
    EXPECT_EQ(gMax(mag(flow->U())().primitiveField()), 0);
    EXPECT_EQ(max(mag(flow->phi())).value(), 0);
}


// OpenFOAM adds 1e-20 to the norm of every linear system
TEST(HeleShaw, fracturesOfNanometresAreFractures)
{
    boxSpec spec = fracturePlane::spec();
    spec.size *= 1e-7;
    fracturePlane c(spec);
    c.setViscosity([](const vector& x) { return x.x() < 1e-7 ? 1 : 5; });
    auto flow = c.HeleShaw("aperture 1e-9;");
    flow->solve();

    // b^3/(12 nu) W/(L (1 + 5)/2), L/W = 2
    const scalar expected = 1e-27/12e-6/6;
    EXPECT_NEAR(outflow(*flow), expected, 1e-9*expected);
}
