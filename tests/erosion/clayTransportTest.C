/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "transportCase.H"
#include "coexistence.H"
#include "diffusivity.H"
#include "KozenyCarmanFriction.H"
#include "rimSimilarity.H"
#include "mathematicalConstants.H"
#include "OFstream.H"
#include "simpson.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using constant::mathematical::pi;


// * * * * * * * * * * * * * * * * The rim  * * * * * * * * * * * * * * * * //

namespace
{

constexpr scalar edgeFraction = 0.005;
constexpr scalar waterVelocity = 1e-5;
constexpr scalar rimLength = 0.01;

//- Largest error of the loss of a gel's edge against (C), relative, over
//  x/Lx from 0.25 to 0.9. The rim begins at 0.1 Lx with the profile of (C)
scalar errorOfRim
(
    const label nx,
    const label ny,
    const bool streamwiseDiffusion
)
{
    const scalar first = 0.1*rimLength;

    boxSpec spec;
    spec.size = vector(1, 1, 1e-3);
    spec.cells = {nx, ny, 1};
    spec.patches = {"inlet", "outlet", "gel", "water", "back", "front"};
    spec.types = {"patch", "patch", "patch", "patch", "empty", "empty"};
    spec.map = [=](const vector& unit)
    {
        // Columns get wider downstream, layers outwards
        return vector
        (
            first*std::pow(rimLength/first, unit.x()),
            3e-3*(std::exp(3*unit.y()) - 1)/(std::exp(3.0) - 1),
            unit.z()
        );
    };

    transportCase::texts text;
    text.flow =
        "model localViscosity; localViscosityCoeffs"
        " { U (1e-5 0 0); gelPatch gel; }";
    text.erosion = string("diffusivity { model Liu; }")
      + (streamwiseDiffusion ? "" : "withoutDiffusionAlong (1 0 0);");
    text.ddt = "steadyState";
    text.controls = "residual 1e-8;";

    transportCase t(spec, {"gel", "inlet"}, text);

    const colloid::water water(t.matter.waterAt(0));
    const dictionary model(dictionaryOf("model Liu;"));
    const auto liu = fractionDiffusivity::New(model, t.matter);
    const auto D = liu->at(water);
    const auto eta = t.matter.viscosity(water);

    const scalar D0 = D->value(0);
    const rimSimilarity rim
    (
        rimSimilarity::form::conservative,
        {
            [&](const scalar a) { return D->value(a); },
            [&](const scalar a) { return eta.relativeViscosity(a); },
            D0
        },
        edgeFraction,
        1600
    );

    t.patch("gel") = edgeFraction;
    scalarField& inlet = t.patch("inlet");
    forAll(inlet, i)
    {
        const vector& at = t.faceCentres("inlet")[i];
        const scalar z = at.y()/(2*std::sqrt(D0*at.x()/waterVelocity));

        scalar low = 1e-12;
        scalar high = edgeFraction;
        for (label k = 0; k < 60; ++k)
        {
            const scalar middle = 0.5*(low + high);
            (rim.distance(middle) > z ? low : high) = middle;
        }
        inlet[i] = z > rim.distance(1e-9) ? 0 : low;
    }

    t.makeTransport();
    EXPECT_GT(t.solveSteady(), 0);

    const label gel = t.c.mesh().boundaryMesh().findPatchID("gel");
    const scalarField& flux = t.clay->alphaPhi().boundaryField()[gel];
    scalar worst = 0;

    forAll(flux, i)
    {
        const scalar x = t.faceCentres("gel")[i].x();

        if (x > 0.25*rimLength && x < 0.9*rimLength)
        {
            const scalar area =
                t.c.mesh().magSf().boundaryField()[gel][i];
            const scalar q0 =
                -2*flux[i]/area*std::sqrt(x/(D0*waterVelocity));

            worst = max(worst, mag(q0/rim.edgeLoss() - 1));
        }
    }
    return returnReduce(worst, maxOp<scalar>());
}

} // End anonymous namespace


TEST(clayTransport, rimLosesWhatSimilarityHasAndConvergesAtSecondOrder)
{
    const scalar coarse = errorOfRim(20, 40, false);
    const scalar medium = errorOfRim(40, 80, false);
    const scalar fine = errorOfRim(80, 160, false);

    Info<< "Errors of q0 over x/Lx 0.25 ... 0.9: " << coarse << ", " << medium
        << ", " << fine << ", orders " << std::log2(coarse/medium) << ", "
        << std::log2(medium/fine) << endl;

    EXPECT_LT(fine, 0.01);
    EXPECT_GT(std::log2(medium/fine), 1.7);
}


TEST(clayTransport, streamwiseDiffusionIsThere)
{
    // Neglected in (C): of the order of D/(u0 x)
    const scalar without = errorOfRim(40, 80, false);
    const scalar with = errorOfRim(40, 80, true);

    Info<< "Without and with streamwise diffusion: " << without << ", " << with
        << endl;
    EXPECT_GT(with, without);
    EXPECT_LT(with, 0.05);
}


// * * * * * * * * * * * * * * Diffusion alone * * * * * * * * * * * * * * * //

namespace
{

//- D = a alpha as a table
string linearDiffusivity(transportCase& t, const scalar a)
{
    const fileName file(t.c.time().globalPath()/"linear.dat");
    if (Pstream::master())
    {
        OFstream os(file);
        os.precision(12);
        os  << "# solidFraction[-] D[m2/s]" << nl;
        for (const scalar alpha : {1e-7, 1e-3, 0.1, 0.6})
        {
            os  << alpha << tab << a*alpha << nl;
        }
    }
    label written = 1;
    reduce(written, sumOp<label>());

    return "diffusivity { model table; file \"" + file + "\"; }";
}


//- Spreading from a point with D = a alpha (Barenblatt 1952)
scalar Barenblatt(const scalar x, const scalar t, const scalar a)
{
    const scalar C = 0.4;
    return max(C - sqr(x)/(6*a)*std::pow(t, -2.0/3), 0.0)*std::pow(t, -1.0/3);
}

} // End anonymous namespace


TEST(clayTransport, spreadsAsBarenblattsSolutionAndKeepsTheClayTo1em12)
{
    const scalar a = 0.01;
    transportCase t(bar(400, 1), {}, {});
    t.erosion = dictionaryOf(linearDiffusivity(t, a));

    const vectorField& C = t.c.mesh().C();
    scalarField& alpha = t.alpha->primitiveFieldRef();
    forAll(alpha, celli)
    {
        alpha[celli] = Barenblatt(C[celli].x(), 1, a);
    }
    t.c.time().setDeltaT(1e-3);
    t.makeTransport();

    const scalar before = t.clay->clay();
    t.advance(29);
    const scalar after = t.clay->clay();

    scalar wrong = 0;
    forAll(alpha, celli)
    {
        wrong += mag(alpha[celli] - Barenblatt(C[celli].x(), 30, a))
           *t.c.mesh().V()[celli];
    }
    reduce(wrong, sumOp<scalar>());

    Info<< "Barenblatt: wrong share " << wrong/before << ", clay gained "
        << after/before - 1 << endl;
    t.clay->report(Info);

    // First order in time: what the tolerance of 1e-3 per step leaves
    EXPECT_LT(wrong/before, 0.01);
    EXPECT_LT(mag(after/before - 1), 1e-12);
    EXPECT_GE(gMin(alpha), -1e-9);
}


TEST(clayTransport, radialSteadyFluxIsThatOfThePotential)
{
    // A sector of a ring; D of a gel and a sol that differ by a hundred
    const scalar inner = 0.01;
    const scalar outer = 0.1;
    const scalar angle = 0.5;

    boxSpec spec;
    spec.size = vector(1, 1, 1e-3);
    spec.cells = {80, 8, 1};
    spec.patches = {"gel", "water", "sides", "sides", "sides", "sides"};
    spec.types = {"patch", "patch", "wall", "wall", "wall", "wall"};
    spec.patches = {"gel", "water", "low", "high", "back", "front"};
    spec.types = {"patch", "patch", "symmetryPlane", "symmetryPlane", "empty", "empty"};
    spec.map = [=](const vector& unit)
    {
        const scalar r = inner*std::pow(outer/inner, unit.x());
        return vector
        (
            r*std::cos(angle*unit.y()), r*std::sin(angle*unit.y()), unit.z()
        );
    };

    transportCase::texts text;
    text.erosion =
        "diffusivity { model twoRange; gel 3e-10; sol 3e-12; fraction 0.005; }";
    text.ddt = "steadyState";
    transportCase t(spec, {"gel", "water"}, text);
    t.patch("gel") = 0.02;
    t.patch("water") = 0;
    t.makeTransport();
    ASSERT_GT(t.solveSteady(), 0);

    const scalar potential = 3e-10*(0.02 - 0.005) + 3e-12*0.005;
    const scalar expected = angle*1e-3*potential/std::log(outer/inner);

    EXPECT_NEAR(t.leaving("water")/expected, 1, 1e-3);
    EXPECT_NEAR(-t.leaving("gel")/expected, 1, 1e-3);
}


namespace
{

//- A hole of 10 mm radius with clay of 0.57, and the fracture around it: a
//  sector, so that what it has along the angle are copies
boxSpec sector(const label layers, const scalar width)
{
    boxSpec spec;
    spec.size = vector(1, 1, 1e-3);
    spec.cells = {layers, 4, 1};
    spec.patches = {"gel", "water", "low", "high", "back", "front"};
    spec.types =
    {
        "patch", "patch", "symmetryPlane", "symmetryPlane", "empty", "empty"
    };
    spec.map = [=](const vector& unit)
    {
        const scalar r = 0.01 + width*unit.x();
        return vector
        (
            r*std::cos(0.2*unit.y()), r*std::sin(0.2*unit.y()), unit.z()
        );
    };
    return spec;
}


//- Distance from the hole [mm] at which alpha passes the fraction
scalar frontAt(transportCase& t, const scalar fraction)
{
    const scalarField& alpha = t.alpha->primitiveField();
    const vectorField& C = t.c.mesh().C();

    scalar last = 0, next = GREAT;
    forAll(alpha, celli)
    {
        const scalar r = std::hypot(C[celli].x(), C[celli].y());
        alpha[celli] > fraction ? last = max(last, r) : next = min(next, r);
    }
    last = returnReduce(last, maxOp<scalar>());
    next = returnReduce(next, minOp<scalar>());

    scalar above = 0, below = 0;
    forAll(alpha, celli)
    {
        const scalar r = std::hypot(C[celli].x(), C[celli].y());
        above = mag(r - last) < 1e-9 ? alpha[celli] : above;
        below = mag(r - next) < 1e-9 ? alpha[celli] : below;
    }
    above = returnReduce(above, maxOp<scalar>());
    below = returnReduce(below, maxOp<scalar>());

    return 1e3*(last + (next - last)*(above - fraction)/(above - below) - 0.01);
}


//- The same in one dimension by explicit steps, with D itself: fronts [mm]
std::vector<scalar> frontsOfTwin
(
    const std::function<scalar(scalar)>& D,
    const scalar hours,
    const scalar cell
)
{
    const label n = label(0.28/cell + 0.5);
    std::vector<scalar> alpha(n + 1, 0), flux(n + 1, 0);
    alpha[0] = 0.57;

    const scalar most = 1e-9;
    const label steps = label(hours*3600/(0.4*sqr(cell)/most)) + 1;
    const scalar dt = hours*3600/steps;

    for (label step = 0; step < steps; ++step)
    {
        for (label i = 0; i < n; ++i)
        {
            const scalar a = alpha[i];
            const scalar b = alpha[i + 1];

            // Cell 0 is the hole's edge
            const scalar distance = i ? cell : 0.5*cell;
            flux[i] =
                (0.01 + i*cell)*(D(a) + 4*D(0.5*(a + b)) + D(b))/6
               *(a - b)/distance;
        }
        for (label i = 1; i <= n; ++i)
        {
            const scalar out = i < n ? flux[i] : 0;
            alpha[i] +=
                dt*(flux[i - 1] - out)/((0.01 + (i - 0.5)*cell)*cell);
        }
    }

    std::vector<scalar> fronts;
    for (const scalar fraction : {0.005, 0.02, 0.1})
    {
        label i = 1;
        while (alpha[i + 1] > fraction) ++i;
        fronts.push_back
        (
            1e3*cell
           *(i - 0.5 + (alpha[i] - fraction)/(alpha[i] - alpha[i + 1]))
        );
    }
    return fronts;
}

} // End anonymous namespace


TEST(clayTransport, plugExpandsOver720HoursWithoutAFailedStepAsItsTwinDoes)
{
    transportCase::texts text;
    text.erosion = "diffusivity { model Liu; }";
    transportCase t(sector(280, 0.28), {"gel"}, text);
    t.patch("gel") = 0.57;
    t.c.time().setDeltaT(1);
    t.makeTransport();

    const auto model = fractionDiffusivity::New
    (
        t.erosion.subDict("diffusivity"), t.matter
    );
    const auto law = model->at(t.matter.waterAt(0));

    scalar now = 0;
    for (const scalar hours : {10, 240})
    {
        t.advance(hours*3600 - now);
        now = hours*3600;

        const std::vector<scalar> twin = frontsOfTwin
        (
            [&](const scalar a) { return law->value(a); }, hours, 1e-3
        );
        const std::vector<scalar> fractions{0.005, 0.02, 0.1};
        for (label i = 0; i < 3; ++i)
        {
            const scalar at = frontAt(t, fractions[i]);
            Info<< "After " << hours << " h alpha " << fractions[i]
                << " is at " << at << " mm, twin " << twin[i] << endl;

            // Cells of 1 mm in both
            EXPECT_NEAR(at, twin[i], 0.4);
        }
    }
    t.advance(720*3600.0 - now);
    t.clay->report(Info);

    EXPECT_EQ(t.clay->failedSteps(), 0);
    EXPECT_LE(gMax(t.alpha->primitiveField()), 0.57*(1 + 1e-9));
    EXPECT_GE(gMin(t.alpha->primitiveField()), -1e-9);
}


TEST(clayTransport, planarFrontAtConstantDiffusivityIsTheErrorFunction)
{
    const scalar D = 0.3e-9;
    const scalar time = 240*3600;

    transportCase::texts text;
    text.erosion = "diffusivity { model constant; value 0.3e-9; }";
    transportCase t(bar(200, 0.2), {"left"}, text);
    t.patch("left") = 0.57;
    t.c.time().setDeltaT(1);
    t.makeTransport();
    t.advance(time);

    scalar worst = 0;
    forAll(t.alpha(), celli)
    {
        const scalar exact =
            0.57*std::erfc(t.c.mesh().C()[celli].x()/(2*std::sqrt(D*time)));
        worst = max(worst, mag(t.alpha()[celli] - exact));
    }
    // First order in time
    EXPECT_LT(returnReduce(worst, maxOp<scalar>()), 0.002*0.57);
}


// With w = exp(k x) and constant D, d(w alpha)/dt = d(w D dalpha/dx)/dx is what a
// velocity of -k D would do: a Gaussian that moves to where the aperture is less
TEST(clayTransport, spreadsInAnApertureThatWidensAndKeepsTheClayInIt)
{
    const scalar D = 1e-9;
    const scalar k = 50;
    const scalar begin = 1e4;
    const scalar end = 4e4;
    const auto Gaussian = [=](const scalar x, const scalar time)
    {
        return
            0.1*std::sqrt(begin/time)
           *std::exp(-sqr(x - 0.1 + k*D*(time - begin))/(4*D*time));
    };

    transportCase::texts text;
    text.erosion = "diffusivity { model constant; value 1e-9; }";
    transportCase t(bar(200, 0.2), {}, text);
    const fvMesh& mesh = t.c.mesh();
    const tmp<volScalarField> w
    (
        fieldOf
        (
            mesh,
            "w",
            dimless,
            [=](const vector& x) { return std::exp(k*(x.x() - 0.1)); }
        )
    );
    const auto clay = [&]
    {
        scalar sum = 0;
        forAll(t.alpha(), celli)
        {
            sum += w()[celli]*t.alpha()[celli]*mesh.V()[celli];
        }
        return returnReduce(sum, sumOp<scalar>());
    };

    forAll(t.alpha(), celli)
    {
        t.alpha->primitiveFieldRef()[celli] =
            Gaussian(mesh.C()[celli].x(), begin);
    }
    t.c.time().setDeltaT(1);
    t.makeTransport(nullptr, &w());
    const scalar before = clay();
    t.advance(end - begin);

    scalar worst = 0;
    forAll(t.alpha(), celli)
    {
        worst = max
        (
            worst,
            mag(t.alpha()[celli] - Gaussian(mesh.C()[celli].x(), end))
        );
    }
    worst = returnReduce(worst, maxOp<scalar>());
    Info<< "Gaussian in an aperture that widens: wrong by "
        << worst/Gaussian(0.1 - k*D*(end - begin), end) << endl;

    EXPECT_LT(worst, 0.01*Gaussian(0.1 - k*D*(end - begin), end));
    EXPECT_LT(mag(clay()/before - 1), 1e-12);
    EXPECT_LT(mag(t.clay->clay()/before - 1), 1e-12);
}


// A block that water carries, by a scheme that swings below 0 beside it, in steps
// over several cells: upwind there, so that no step fails
TEST(clayTransport, isByUpwindWhereTheSchemeLeavesTheBounds)
{
    transportCase::texts text;
    text.erosion = "diffusivity { model constant; value 1e-12; }";
    text.flow = "model uniform; uniformCoeffs { U (1e-4 0 0); }";
    text.advection = "linear";
    text.controls = "tolerance 1;";
    transportCase t(bar(200, 0.2), {}, text);

    forAll(t.alpha(), celli)
    {
        const scalar x = t.c.mesh().C()[celli].x();
        t.alpha->primitiveFieldRef()[celli] = x > 0.02 && x < 0.04 ? 0.1 : 0;
    }
    t.c.time().setDeltaT(20);
    t.flow->solve();
    t.makeTransport();
    const scalar before = t.clay->clay();
    for (label i = 0; i < 10; ++i)
    {
        ++t.c.time();
        t.clay->advance(20);
        EXPECT_GE(gMin(t.alpha->primitiveField()), -1e-9);
    }
    EXPECT_EQ(t.clay->failedSteps(), 0);
    EXPECT_LT(mag(t.clay->clay()/before - 1), 1e-9);
}


// * * * * * * * * * * * * * * * Two phases  * * * * * * * * * * * * * * * * //

TEST(coexistence, solAndGelHaveThePressureAndPotentialOfEachOther)
{
    // At 800 mol/m3 the sol is below 1e-12, where its platelets are taken as an
    // ideal gas
    for (const scalar concentration : {100.0, 400.0, 800.0})
    {
        const colloid::clayProperties matter
        (
            dictionaryOf
            (
                "water { concentration " + Foam::name(concentration) + "; }"
            )
        );
        const colloid::water water(matter.waterAt(0));
        const colloid::diffusivity law
        (
            matter.clay(),
            water,
            *matter.newDoubleLayer(word("compression"), water),
            *matter.newFriction("KozenyCarman", water)
        );
        const auto A = [&](const scalar phi) { return law.timesFriction(phi); };
        const coexistence phases(A, 0.6);

        ASSERT_EQ(phases.kind(), coexistence::state::twoPhases);
        ASSERT_GT(phases.sol(), 0);
        EXPECT_LT(phases.sol(), phases.lower());
        EXPECT_GT(phases.gel(), phases.upper());

        // In ln phi
        const auto integral = [&](const std::function<scalar(scalar)>& f)
        {
            return simpson
            (
                [&](const scalar s) { return f(std::exp(s)); },
                std::log(phases.sol()), std::log(phases.gel()), 20000
            );
        };
        const scalar pressure =
            integral([&](const scalar phi) { return A(phi)*phi; });
        const scalar size =
            integral([&](const scalar phi) { return mag(A(phi))*phi; });
        const scalar potential = integral(A)/water.thermalEnergy();

        Info<< "At " << concentration << " mol/m3 a sol of " << phases.sol()
            << " beside a gel of " << phases.gel() << endl;
        EXPECT_LT(mag(pressure)/size, 1e-6);
        EXPECT_LT(mag(potential), 1e-5);
    }
}


TEST(coexistence, diluteWaterHasOnePhase)
{
    const coexistence phases([](const scalar phi) { return 1 + phi; }, 0.6);
    EXPECT_EQ(phases.kind(), coexistence::state::onePhase);
}


TEST(clayTransport, aboveTheCoagulationConcentrationTheGelStays)
{
    transportCase::texts text;
    text.clay = "water { concentration 100; }";
    text.erosion = "diffusivity { model Liu; }";
    transportCase t(bar(100, 0.1), {}, text);

    const scalar gel =
        potentialInWater
        (
            fractionDiffusivity::New
            (
                t.erosion.subDict("diffusivity"), t.matter
            )(),
            t.matter.waterAt(0),
            0.65
        ).phases().gel();

    scalarField& alpha = t.alpha->primitiveFieldRef();
    const vectorField& C = t.c.mesh().C();
    forAll(alpha, celli)
    {
        alpha[celli] = C[celli].x() < 0.03 ? gel : 0;
    }
    t.c.time().setDeltaT(1);
    t.makeTransport();
    const scalar before = t.clay->clay();
    t.advance(30*86400.0);

    // A sol leaves by diffusion of lone platelets, next to nothing
    scalar stayed = 0;
    forAll(alpha, celli)
    {
        if (C[celli].x() < 0.03)
        {
            stayed += alpha[celli]*t.c.mesh().V()[celli];
        }
    }
    reduce(stayed, sumOp<scalar>());
    Info<< "Of a gel of " << gel << " stayed " << stayed/before << endl;

    EXPECT_GT(stayed/before, 0.98);
    EXPECT_LT(stayed/before, 1);
    EXPECT_LT(mag(t.clay->clay()/before - 1), 1e-12);
    EXPECT_EQ(t.clay->failedSteps(), 0);
}


// Gel in the upstream half, clear water from the left: out of the gel, and a while
// later out of the right side, comes phi times the fraction of the sol, whatever that
// of the gel. Diffusion adds D/(U dx) of that, 1e-4
TEST(clayTransport, waterCarriesTheSolOnlyAboveTheCoagulationConcentration)
{
    const scalar U = 1e-4;
    const scalar duration = 800;

    for (const scalar part : {1.0, 0.6})
    {
        transportCase::texts text;
        text.clay = "water { concentration 300; }";
        text.erosion = "diffusivity { model Liu; }";
        text.flow = "model uniform; uniformCoeffs { U (1e-4 0 0); }";
        transportCase t(bar(100, 0.1), {"left"}, text);

        const potentialInWater potential
        (
            fractionDiffusivity::New
            (
                t.erosion.subDict("diffusivity"), t.matter
            )(),
            t.matter.waterAt(0),
            0.65
        );
        const scalar sol = potential.phases().sol();
        const scalar gel = potential.phases().gel();

        // Also where gel fills a part of the cells only
        ASSERT_GT(part*gel, 2*sol);

        const auto inGel = [&]
        {
            scalar sum = 0;
            forAll(t.alpha(), celli)
            {
                if (t.c.mesh().C()[celli].x() < 0.05)
                {
                    sum += t.alpha()[celli]*t.c.mesh().V()[celli];
                }
            }
            return returnReduce(sum, sumOp<scalar>());
        };

        forAll(t.alpha(), celli)
        {
            t.alpha->primitiveFieldRef()[celli] =
                t.c.mesh().C()[celli].x() < 0.05 ? part*gel : 0;
        }
        t.c.time().setDeltaT(1);
        t.flow->solve();
        t.makeTransport();
        const scalar before = inGel();
        t.advance(duration);

        Info<< "Gel of " << part*gel << " beside a sol of " << sol << endl;
        EXPECT_NEAR(t.leaving("right")/(U*sol), 1, 1e-3);
        EXPECT_NEAR((before - inGel())/(U*sol*duration), 1, 1e-3);
        EXPECT_EQ(t.clay->failedSteps(), 0);
    }
}


TEST(potentialInWater, carriesAllOfASolAndOfAGelTheSolBesideIt)
{
    const dictionary Liu(dictionaryOf("model Liu;"));

    for (const scalar concentration : {0.1, 100.0})
    {
        const colloid::clayProperties matter
        (
            dictionaryOf
            (
                "water { concentration " + Foam::name(concentration) + "; }"
            )
        );
        const potentialInWater potential
        (
            fractionDiffusivity::New(Liu, matter)(), matter.waterAt(0), 0.65
        );
        const coexistence& phases = potential.phases();
        const bool two = concentration > 1;

        ASSERT_EQ(phases.kind() == coexistence::state::twoPhases, two);
        for (const scalar alpha : {0.0, 1e-6, 1e-3, 0.03, 0.06, 0.3, 0.65})
        {
            EXPECT_EQ
            (
                potential.carried(alpha),
                two && alpha > phases.sol() ? phases.sol() : alpha
            );
        }
    }
}


TEST(clayTransport, negativeDiffusionIsRefusedWithItsRange)
{
    transportCase::texts text;
    text.clay = "water { concentration 100; }";
    text.erosion = "diffusivity { model Liu; negative refuse; }";
    transportCase t(bar(10, 0.1), {}, text);

    EXPECT_TRUE
    (
        mentions
        (
            messageOf([&] { t.makeTransport(); }),
            {"negative between the solid fractions", "100 mol/m3"}
        )
    );
}


// * * * * * * * * * * * * * * * Settling  * * * * * * * * * * * * * * * * * //

TEST(clayTransport, settlingIsBalancedByDiffusion)
{
    const scalar D = 1e-11;

    transportCase::texts text;
    text.erosion = "diffusivity { model constant; value 1e-11; } gravity on;";
    text.ddt = "steadyState";
    text.controls = "residual 1e-9;";

    // No clay sinks through a wall
    boxSpec spec(bar(200, 0.02));
    spec.types[1] = "wall";
    transportCase t(spec, {"left"}, text);
    t.write
    (
        "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (-9.81 0 0);"
    );

    // Above a floor of fixed fraction, dilute: alpha = alpha0 exp(-v x/D)
    t.patch("left") = 1e-5;
    t.alpha->primitiveFieldRef() = 1e-6;
    t.makeTransport();
    t.solveSteady(100);

    const colloid::water water(t.matter.waterAt(0));
    const colloid::platelet& clay = t.matter.clay();
    const scalar velocity =
        clay.volume()*(clay.density - water.density)*9.81
       /t.matter.newFriction("KozenyCarman", water)->value(5e-6);

    scalar highest = 0;
    scalar there = 0;
    forAll(t.alpha(), celli)
    {
        const scalar x = t.c.mesh().C()[celli].x();
        if (x > highest)
        {
            highest = x;
            there = t.alpha()[celli];
        }
    }
    const scalar top = returnReduce(highest, maxOp<scalar>());
    there = returnReduce(highest == top ? there : 0, maxOp<scalar>());

    // Upwind adds half a cell's settling to D
    const scalar dx = 0.02/200;
    EXPECT_NEAR
    (
        std::log(1e-5/there), velocity*top/(D + 0.5*velocity*dx),
        0.01*velocity*top/D
    );
}


// * * * * * * * * * * * * * * Round a hole  * * * * * * * * * * * * * * * * //

TEST(clayTransport, holeLosesSqrt4OverPiTimesFormula22)
{
    // Potential flow round a hole, by its stream function at the points of the
    // mesh, so that the flux is free of divergence; half of the plane. Peclet's
    // number 7e4, as the formula neglects the rim's curvature
    const scalar R = 0.02;
    const scalar u0 = 1e-5;
    const scalar D = 3e-12;
    const scalar thickness = 1e-3;
    const label layers = 80;

    boxSpec spec;
    spec.size = vector(1, 1, thickness);
    spec.cells = {layers, 160, 1};
    spec.patches = {"gel", "water", "low", "high", "back", "front"};
    spec.types =
    {
        "patch", "patch", "symmetryPlane", "symmetryPlane", "empty", "empty"
    };
    spec.map = [=](const vector& unit)
    {
        // From downstream to upstream; layers from 2e-6 m on
        const scalar r = R + 1e-3*(std::exp(5*unit.x()) - 1)/(std::exp(5.0) - 1);
        return vector
        (
            r*std::cos(pi*unit.y()), r*std::sin(pi*unit.y()), unit.z()
        );
    };

    transportCase::texts text;
    text.erosion = "diffusivity { model constant; value 3e-12; }";
    text.ddt = "steadyState";
    text.controls = "residual 1e-5;";

    // Water comes in without clay, since there is none where it does
    transportCase t(spec, {"gel"}, text);
    const fvMesh& mesh = t.c.mesh();

    surfaceScalarField phi("phi", t.flow->phi());
    const auto stream = [=](const vector& x)
    {
        const scalar r2 = sqr(x.x()) + sqr(x.y());
        return u0*x.y()*(1 - sqr(R)/r2);
    };
    const auto fluxOf = [&](const face& f, const vector& S)
    {
        // Its edge at the bottom
        DynamicList<vector> low;
        for (const label pointi : f)
        {
            const vector& x = mesh.points()[pointi];
            if (x.z() < 0.5*thickness)
            {
                low.append(x);
            }
        }
        if (low.size() != 2)
        {
            return scalar(0);
        }
        const vector along = low[1] - low[0];
        const scalar side =
            sign(along.y()*S.x() - along.x()*S.y());
        return side*thickness*(stream(low[1]) - stream(low[0]));
    };
    forAll(mesh.owner(), facei)
    {
        phi[facei] = fluxOf(mesh.faces()[facei], mesh.Sf()[facei]);
    }
    forAll(phi.boundaryField(), patchi)
    {
        fvsPatchField<scalar>& patch = phi.boundaryFieldRef()[patchi];
        forAll(patch, i)
        {
            patch[i] = fluxOf
            (
                mesh.faces()[mesh.boundary()[patchi].start() + i],
                mesh.Sf().boundaryField()[patchi][i]
            );
        }
    }

    t.patch("gel") = 0.01;
    t.makeTransport(&phi);
    ASSERT_GT(t.solveSteady(), 0);

    const scalar formula =
        0.01*thickness*2/std::sqrt(pi)*std::sqrt(D*pi*R*u0);
    const scalar ratio = -t.leaving("gel")/formula;

    Info<< "Hole: " << ratio << " of formula 2-2, expected "
        << std::sqrt(4/pi) << endl;
    EXPECT_NEAR(ratio, std::sqrt(4/pi), 0.01);
}
