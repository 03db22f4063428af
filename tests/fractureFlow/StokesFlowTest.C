/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowCase.H"
#include "stratifiedPoiseuille.H"
#include "OStringStream.H"
#include "StokesFlow.H"
#include "surfaceFields.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using fractureFlows::StokesFlow;

static const string noSlip("type noSlip;");
static const string zeroGradient("type zeroGradient;");

//- "type fixedValue" with the value
static string fixed(const string& value)
{
    return "type fixedValue; value uniform " + value + ";";
}

static label nIterations(const fractureFlow& flow)
{
    return refCast<const StokesFlow>(flow).residuals().size() - 1;
}


//- Plane channel with cyclic ends, n cells across, gel below the middle, driven
//  by 10 Pa/m
static boxSpec periodicChannel(const scalar height, const label n)
{
    boxSpec spec;
    spec.size = vector(4*height/n, height, height/n);
    spec.cells = {4, n, 1};
    spec.types = {"cyclic", "cyclic", "wall", "wall", "empty", "empty"};
    return spec;
}

static autoPtr<fractureFlow> layeredFlow
(
    flowCase& c,
    const scalar height,
    const scalar ratio
)
{
    c.setViscosity
    (
        [&](const vector& x) { return x.y() < height/2 ? ratio : 1; }
    );
    c.writeU({{"bottom", noSlip}, {"top", noSlip}});
    c.writeP({{"bottom", zeroGradient}, {"top", zeroGradient}});

    return c.newFlow
    (
        "model Stokes; StokesCoeffs { pressureGradient (-10 0 0); }"
    );
}

//- Largest error of the velocity in the gel and in the water, each over the
//  largest velocity there
struct layerErrors
{
    scalar gel = 0;
    scalar water = 0;
};

static layerErrors errorsOf
(
    const fractureFlow& flow,
    const stratifiedPoiseuille& exact
)
{
    const volVectorField& U = flow.U();

    scalar error[2] = {0, 0};
    scalar largest[2] = {0, 0};

    forAll(U, i)
    {
        const scalar y = U.mesh().C()[i].y();
        const int layer = y > exact.interface;
        const scalar u = exact.velocity(y);

        error[layer] = max(error[layer], mag(U[i] - vector(u, 0, 0)));
        largest[layer] = max(largest[layer], u);
    }

    layerErrors result;
    result.gel =
        returnReduce(error[0], maxOp<scalar>())
       /returnReduce(largest[0], maxOp<scalar>());
    result.water =
        returnReduce(error[1], maxOp<scalar>())
       /returnReduce(largest[1], maxOp<scalar>());
    return result;
}

static layerErrors stratifiedErrors(const label n, const scalar ratio)
{
    flowCase c(periodicChannel(1, n));
    auto flow = layeredFlow(c, 1, ratio);
    flow->solve();

    return errorsOf(*flow, {1, 0.5, 1e-3*ratio, 1e-3, 10});
}


TEST(Stokes, stratifiedPoiseuilleWithinOnePercentAt40Cells)
{
    for (const scalar ratio : {1., 10., 1e3, 1e6})
    {
        const layerErrors error = stratifiedErrors(40, ratio);

        // In each layer against its own largest velocity, 1e6 times apart
        EXPECT_LT(error.water, 0.01) << "viscosity ratio " << ratio;
        EXPECT_LT(error.gel, 0.01) << "viscosity ratio " << ratio;
    }
}


TEST(Stokes, stratifiedPoiseuilleConvergesAtSecondOrder)
{
    for (const scalar ratio : {10., 1e3, 1e6})
    {
        const layerErrors coarse = stratifiedErrors(20, ratio);
        const layerErrors fine = stratifiedErrors(40, ratio);

        // 4 where the cell is small; a cell of 1/20 is not that small
        EXPECT_NEAR(coarse.water/fine.water, 4, 0.2) << ratio;
        EXPECT_NEAR(coarse.gel/fine.gel, 4, 0.2) << ratio;
    }
}


// The balance of stress on each cell, solved along the one direction in which
// the flow varies: the same on any number of ranks
static scalarField plainTwin(const label n, const scalar ratio)
{
    const scalar h = 1./n;
    const auto viscosity = [&](label i)
    {
        return 1e-3*(i < n/2 ? ratio : 1);
    };

    // Conductance of the face below cell i; half a cell to the walls
    const auto conductance = [&](label i)
    {
        return
            i == 0 ? viscosity(0)/(0.5*h)
          : i == n ? viscosity(n - 1)/(0.5*h)
          : 2/(h/viscosity(i - 1) + h/viscosity(i));
    };

    // Elimination upwards, then back
    scalarField factor(n);
    scalarField u(n);
    for (label i = 0; i < n; ++i)
    {
        const scalar below = conductance(i);
        const scalar above = conductance(i + 1);
        const scalar pivot = below + above - (i ? below*factor[i - 1] : 0);

        factor[i] = above/pivot;
        u[i] = (10*h + (i ? below*u[i - 1] : 0))/pivot;
    }
    for (label i = n - 2; i >= 0; --i)
    {
        u[i] += factor[i]*u[i + 1];
    }

    return u;
}


TEST(Stokes, flowOnAnyNumberOfRanksIsThatOfTheOneDimensionalTwin)
{
    const label n = 40;
    flowCase c(periodicChannel(1, n));
    auto flow = layeredFlow(c, 1, 1e3);
    flow->solve();

    const scalarField u(plainTwin(n, 1e3));
    scalar error = 0;
    forAll(flow->U(), i)
    {
        const label row = label(c.mesh().C()[i].y()*n);
        error = max(error, mag(flow->U()[i] - vector(u[row], 0, 0)));
    }

    // The residual, 1e-8, at its condition number
    EXPECT_LT(returnReduce(error, maxOp<scalar>()), 1e-6*max(u));
}


TEST(Stokes, cellsOf10nmAndOf1mTakeTheSameIterationsToTheSameProfile)
{
    const label n = 40;
    List<scalarField> profiles(2);
    label iterations[2];

    label i = 0;
    for (const scalar cell : {1e-8, 1.})
    {
        const scalar height = n*cell;
        flowCase c(periodicChannel(height, n));
        auto flow = layeredFlow(c, height, 1e3);
        flow->solve();

        iterations[i] = nIterations(*flow);
        profiles[i] = flow->U().primitiveField().component(0);
        profiles[i] /= gMax(profiles[i]);
        ++i;
    }

    EXPECT_EQ(iterations[0], iterations[1]);
    EXPECT_LT(gMax(mag(profiles[0] - profiles[1])()), 1e-6);
}


TEST(Stokes, pressureDifferenceDrivesAsPressureGradientDoes)
{
    const label n = 16;

    boxSpec spec = periodicChannel(1, n);
    flowCase periodic(spec);
    auto expected = layeredFlow(periodic, 1, 10);
    expected->solve();

    // 10 Pa/m over 4/16 m of water of 1000 kg/m3
    spec.types[0] = spec.types[1] = "patch";
    flowCase open(spec);
    open.setViscosity([](const vector& x) { return x.y() < 0.5 ? 10 : 1; });
    open.writeU
    ({
        {"bottom", noSlip},
        {"top", noSlip},
        {"inlet", zeroGradient},
        {"outlet", zeroGradient}
    });
    open.writeP
    ({
        {"bottom", zeroGradient},
        {"top", zeroGradient},
        {"inlet", fixed("2.5e-3")},
        {"outlet", fixed("0")}
    });
    auto flow = open.newFlow("model Stokes;");
    flow->solve();

    const scalar throughput = gSum(flow->phi().boundaryField()[1]);
    const scalar throughputExpected = gSum(expected->phi().boundaryField()[1]);

    // 1e-6: the residuals of both, 1e-8, at their condition number
    EXPECT_NEAR(throughput/throughputExpected, 1, 1e-6);
    EXPECT_NEAR
    (
        gMax(mag(flow->U())().primitiveField())
       /gMax(mag(expected->U())().primitiveField()),
        1,
        1e-6
    );
}


// A sector between cylinders of radius 1 and 2, of which the inner one turns.
// With nu = r^2 the shear stress nu r d(u/r)/dr = C/r^2 gives
//     u = r (1/r^4 - 1/16)/(1 - 1/16).
// Without grad U^T in the stress another profile would balance
static scalar CouetteError(const label n)
{
    boxSpec spec;
    spec.cells = {n, n, 1};
    spec.patches = {"inner", "outer", "end0", "end1", "back", "front"};
    spec.types = {"wall", "wall", "patch", "patch", "empty", "empty"};
    spec.map = [](const vector& x)
    {
        const scalar r = 1 + x.x();
        return vector(r*std::cos(x.y()), r*std::sin(x.y()), 0.1*x.z());
    };
    flowCase c(spec);

    const auto exact = [](const vector& x)
    {
        const scalar r = std::hypot(x.x(), x.y());
        return
            (1/Foam::pow(r, 4) - 1./16)/(1 - 1./16)*vector(-x.y(), x.x(), 0);
    };

    std::map<word, string> U;
    std::map<word, string> p;
    for (const word name : {"inner", "outer", "end0", "end1"})
    {
        const fvPatch& patch =
            c.mesh().boundary()[c.mesh().boundaryMesh().findPatchID(name)];

        OStringStream os;
        os.precision(16);
        os  << "type fixedValue; value nonuniform List<vector> "
            << patch.size() << "(";
        for (const vector& x : patch.Cf())
        {
            os  << exact(x);
        }
        os  << ");";

        U[name] = os.str();
        p[name] = zeroGradient;
    }
    c.setViscosity
    (
        [](const vector& x) { return sqr(x.x()) + sqr(x.y()); }
    );
    c.writeU(U);
    c.writeP(p);

    auto flow = c.newFlow("model Stokes;");
    flow->solve();

    scalar error = 0;
    forAll(c.mesh().C(), i)
    {
        error = max(error, mag(flow->U()[i] - exact(c.mesh().C()[i])));
    }

    // The inner cylinder's velocity is 1
    return returnReduce(error, maxOp<scalar>());
}


TEST(Stokes, stressIsSymmetricSoThatVaryingViscosityTurnsWithTheCylinder)
{
    const scalar coarse = CouetteError(16);
    const scalar fine = CouetteError(32);

    EXPECT_LT(fine, 0.005);
    EXPECT_GT(coarse/fine, 3);
}
