/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowCase.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "mathematicalConstants.H"
#include "surfaceFields.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

//- Gel at the bottom, water flowing along x past it
static boxSpec rim(const label nx, const label ny, const scalar size = 1)
{
    boxSpec spec;
    spec.size = vector(2*size, size, size/ny);
    spec.cells = {nx, ny, 1};
    spec.patches = {"inlet", "outlet", "gel", "water", "back", "front"};
    spec.types = {"patch", "patch", "patch", "patch", "empty", "empty"};
    return spec;
}

//- 1/eta_r = (1.5 + sin(3x))/2.5 y/H, and the velocities that follow for
//  u0 = (1 0 0): u = 1/eta_r, v = -1.2 cos(3x) y^2/(2 H), X = x/H
static scalar mobility(const scalar x, const scalar y)
{
    return (1.5 + std::sin(3*x))/2.5*y;
}

static vector exactVelocity(const scalar x, const scalar y)
{
    return vector(mobility(x, y), -1.2*std::cos(3*x)*sqr(y)/2, 0);
}

static autoPtr<fractureFlow> solvedFlow
(
    flowCase& c,
    const string& coeffs = "U (1 0 0); gelPatch gel;",
    const scalar size = 1
)
{
    c.setViscosity
    (
        [&](const vector& x) { return 1/mobility(x.x()/size, x.y()/size); }
    );
    auto flow = c.newFlow
    (
        "model localViscosity; localViscosityCoeffs {" + coeffs + "}"
    );
    flow->solve();
    return flow;
}


TEST(noFlow, isRestWhateverFluxWasLeft)
{
    flowCase c(rim(4, 4));
    c.writeField("phi", "surfaceScalarField", "[0 3 -1 0 0 0 0]", "uniform 1", {
        {"inlet", "type calculated; value uniform -1;"},
        {"outlet", "type calculated; value uniform 1;"},
        {"gel", "type calculated; value uniform 0;"},
        {"water", "type calculated; value uniform 0;"}
    });
    auto flow = c.newFlow("model none;");
    flow->solve();

    EXPECT_EQ(gMax(mag(flow->U())().primitiveField()), 0);
    EXPECT_EQ(gMax(mag(flow->phi())().primitiveField()), 0);
}


TEST(uniformFlow, followsItsFunctionOfTime)
{
    flowCase c(rim(4, 4));
    auto flow = c.newFlow
    (
        "model uniform; uniformCoeffs"
        "{ U table ((0 (1 0 0)) (10 (1 20 0))); }"
    );

    for (const scalar time : {0., 5.})
    {
        c.time().setTime(time, label(time));
        flow->solve();

        const vector U(1, 2*time, 0);
        EXPECT_LT(gMax(mag(flow->U().primitiveField() - U)()), 1e-14);

        const scalarField& in = flow->phi().boundaryField()[0];
        const vectorField& Sf = c.mesh().Sf().boundaryField()[0];
        EXPECT_LT(gMax(mag(in - (U & Sf))()), 1e-15);
        EXPECT_LT(relativeDivergence(*flow), 1e-14);
    }
}


TEST(localViscosity, sideFluxIsThatOfTheLocalViscosity)
{
    flowCase c(rim(8, 8));
    auto flow = solvedFlow(c);

    scalar error = 0;
    scalar sides = 0;
    forAll(c.mesh().neighbour(), facei)
    {
        const vector Sf = c.mesh().Sf()[facei];
        if (mag(Sf.x()) < 0.5*mag(Sf))
        {
            continue;
        }
        ++sides;

        // Mean of the two cells, 0.25 apart
        const vector x = c.mesh().Cf()[facei];
        const scalar mean =
            0.5*(mobility(x.x() - 0.125, x.y()) + mobility(x.x() + 0.125, x.y()));
        error = max(error, mag(flow->phi()[facei] - mean*Sf.x()));
    }

    // 1e-10: the solid fraction for a viscosity is found by bisection
    EXPECT_LT(returnReduce(error, maxOp<scalar>()), 1e-10/64);
    EXPECT_GE(returnReduce(sides, sumOp<scalar>()), 8*6);
}


TEST(localViscosity, isDivergenceFreeAndClosedAtTheGel)
{
    for (const scalar size : {1., 1e-6})
    {
        flowCase c(rim(16, 16, size));
        auto flow = solvedFlow(c, "U (1 0 0); gelPatch gel;", size);

        // Round-off of the sum over six faces
        EXPECT_LT(relativeDivergence(*flow), 1e-14);
        EXPECT_EQ(gMax(mag(flow->phi().boundaryField()[2])()), 0);

        // As printed it gains and loses
        auto printed = solvedFlow(c, "U (1 0 0); asPrinted yes;", size);
        EXPECT_GT(relativeDivergence(*printed), 1e-3);
    }
}


static scalar velocityError(const label n)
{
    flowCase c(rim(2*n, n));
    auto flow = solvedFlow(c);

    scalar error = 0;
    forAll(c.mesh().C(), i)
    {
        const vector x = c.mesh().C()[i];

        // The column at the inlet has the cell's viscosity on that side
        if (x.x() > 2./n && x.x() < 2 - 2./n)
        {
            error = max
            (
                error,
                mag(flow->U()[i] - exactVelocity(x.x(), x.y()))
            );
        }
    }
    return returnReduce(error, maxOp<scalar>());
}


TEST(localViscosity, velocityConvergesToThatOfContinuityAtSecondOrder)
{
    const scalar coarse = velocityError(16);
    const scalar fine = velocityError(32);

    EXPECT_LT(fine, 2e-3);
    EXPECT_NEAR(coarse/fine, 4, 0.5);
}


TEST(localViscosity, asPrintedIsTheVelocityOverTheViscosity)
{
    flowCase c(rim(8, 8));
    auto flow = solvedFlow(c, "U (1 0 0); asPrinted yes;");

    scalar error = 0;
    forAll(c.mesh().C(), i)
    {
        const vector x = c.mesh().C()[i];
        error = max
        (
            error,
            mag(flow->U()[i] - vector(mobility(x.x(), x.y()), 0, 0))
        );
    }
    EXPECT_LT(returnReduce(error, maxOp<scalar>()), 1e-10);
}


TEST(localViscosity, valueThatAlphaHasOnTheInletCounts)
{
    // Gel everywhere, but clear water at the inlet: what comes in faster than
    // the gel goes leaves through the far side
    flowCase c(rim(4, 4));
    c.setViscosity([](const vector&) { return 10; });

    volScalarField& alpha = c.alpha();
    alpha.boundaryFieldRef().set
    (
        0,
        fvPatchScalarField::New
        (
            "fixedValue", c.mesh().boundary()[0], alpha.internalField()
        )
    );
    alpha.boundaryFieldRef()[0] == 0;

    auto flow = c.newFlow
    (
        "model localViscosity;"
        "localViscosityCoeffs { U (1 0 0); gelPatch gel; }"
    );
    flow->solve();

    const scalar area = 1*0.25;
    EXPECT_NEAR(gSum(flow->phi().boundaryField()[0]), -1*area, 1e-12);
    EXPECT_NEAR(gSum(flow->phi().boundaryField()[1]), 0.1*area, 1e-12);
    EXPECT_NEAR(gSum(flow->phi().boundaryField()[3]), 0.9*area, 1e-12);
}


TEST(localViscosity, cyclicSidesWork)
{
    boxSpec spec = rim(8, 8);
    spec.types[0] = spec.types[1] = "cyclic";
    spec.size.x() = 2*constant::mathematical::pi/3;
    flowCase c(spec);
    auto flow = solvedFlow(c);

    EXPECT_LT(relativeDivergence(*flow), 1e-14);

    // Over a period nothing is displaced, on balance
    const scalar out = gSum(flow->phi().boundaryField()[3]);
    const scalar gross = gSum(mag(flow->phi().boundaryField()[3])());
    EXPECT_LT(mag(out), 1e-12*gross);
    EXPECT_GT(gross, 0.01/8);
}


// Cells of micrometres that are not aligned to the last digit
TEST(localViscosity, waterWithoutClayFlowsAsIfUndisturbed)
{
    boxSpec spec = rim(25, 25, 2.5e-6);
    spec.cells[2] = 6;
    spec.size.z() = 1.5e-6;
    spec.types = {"cyclic", "cyclic", "patch", "patch", "cyclic", "cyclic"};
    spec.map = [](const vector& x)
    {
        return x + 1e-15*std::sin(1e3*(x.x() + 2*x.y() + 3*x.z()))*x;
    };
    flowCase c(spec);
    c.setViscosity([](const vector&) { return 1; });
    auto flow = c.newFlow
    (
        "model localViscosity;"
        "localViscosityCoeffs { U (1e-3 0 0); gelPatch gel; }"
    );
    flow->solve();

    EXPECT_LT
    (
        gMax(mag(flow->U().primitiveField() - vector(1e-3, 0, 0))()), 1e-13
    );
}


// Columns that spread and lean, cells of different heights, three dimensions
TEST(localViscosity, bentColumnsAreDivergenceFree)
{
    boxSpec spec = rim(6, 8);
    spec.cells[2] = 4;
    spec.size.z() = 1;
    spec.types[4] = spec.types[5] = "symmetryPlane";
    spec.map = [](const vector& x)
    {
        const scalar y = x.y()*(1 + x.y())/2;
        return vector(x.x() + 0.3*y*(x.x() - 0.4), y + 0.1*x.x(), x.z());
    };
    flowCase c(spec);
    c.setViscosity
    (
        [](const vector& x) { return 1 + 100*std::exp(-4*x.y())*x.x(); }
    );
    auto flow = c.newFlow
    (
        "model localViscosity;"
        "localViscosityCoeffs { U (1 0 0); gelPatch gel; }"
    );
    flow->solve();

    EXPECT_LT(relativeDivergence(*flow), 1e-13);
    EXPECT_EQ(gMax(mag(flow->phi().boundaryField()[2])()), 0);
}


// gelPatch may be an expression: columns stand on gel and rock beside each other, and
// the water flows as over one patch. Where they stand on one of the two only, the
// cells over the other one are in no column
TEST(localViscosity, columnsStandOnAllPatchesOfAnExpression)
{
    boxSpec spec = rim(8, 6);
    flowCase one(spec);
    auto flow = solvedFlow(one);

    spec.laterBottom = "rock";
    spec.laterColumn = 5;

    for (const string gel : {"\"(gel|rock)\"", "\"(rock|gel)\"", "\"[gr].*[lk]\""})
    {
        flowCase two(spec);
        auto both = solvedFlow(two, "U (1 0 0); gelPatch " + gel + ";");

        // But for the order of faces in sums
        EXPECT_LT
        (
            gMax
            (
                mag
                (
                    both->phi().primitiveField()
                  - flow->phi().primitiveField()
                )()
            ),
            1e-16
        ) << gel;
        for (const word patch : {"inlet", "outlet", "water"})
        {
            const label i = two.mesh().boundaryMesh().findPatchID(patch);

            EXPECT_LT
            (
                gMax
                (
                    mag
                    (
                        both->phi().boundaryField()[i]
                      - flow->phi().boundaryField()[i]
                    )()
                ),
                1e-16
            ) << gel << ' ' << patch;
        }
        for (const word patch : {"gel", "rock"})
        {
            const label i = two.mesh().boundaryMesh().findPatchID(patch);

            EXPECT_EQ
            (
                returnReduce(two.mesh().boundaryMesh()[i].size(), sumOp<label>()),
                patch == "gel" ? 5 : 3
            );
            EXPECT_EQ(gMax(mag(both->phi().boundaryField()[i])()), 0) << patch;
        }
        EXPECT_LT(relativeDivergence(*both), 1e-14);
    }

    flowCase two(spec);
    EXPECT_TRUE
    (
        mentions
        (
            messageOf
            (
                [&]() { solvedFlow(two, "U (1 0 0); gelPatch gel;"); }
            ),
            {"not layered", "18 cells are in no column", "gel"}
        )
    );
}


static string messageOfRim
(
    boxSpec spec,
    const string& coeffs = "U (1 0 0); gelPatch gel;"
)
{
    flowCase c(spec);
    return messageOf([&]() { solvedFlow(c, coeffs); });
}


TEST(fractureFlowInput, unknownModelIsNamedWithTheNearest)
{
    flowCase c(rim(2, 2));

    EXPECT_TRUE
    (
        mentions
        (
            messageOf([&]() { c.newFlow("model stoks;"); }),
            {"stoks", "Stokes", "none", "uniform", "localViscosity"}
        )
    );
    EXPECT_TRUE
    (
        mentions
        (
            messageOf([&]() { c.newFlow("modell none;"); }),
            {"modell", "'model'"}
        )
    );
}


TEST(fractureFlowInput, missingFileIsNamed)
{
    flowCase c(rim(2, 2));
    EXPECT_TRUE
    (
        mentions
        (
            messageOf([&]() { fractureFlow::New(c.mesh(), c.alpha()); }),
            {"constant/fractureFlowProperties", "model none"}
        )
    );
}


TEST(fractureFlowInput, unknownEntriesAreNamedWithTheNearest)
{
    EXPECT_TRUE
    (
        mentions
        (
            messageOfRim(rim(2, 2), "U (1 0 0); gelpatch gel;"),
            {"gelpatch", "gelPatch"}
        )
    );

    flowCase c(rim(2, 2));
    EXPECT_TRUE
    (
        mentions
        (
            messageOf
            (
                [&]()
                {
                    c.newFlow("model uniform; uniformCoeffs { u (1 0 0); }");
                }
            ),
            {"u", "U"}
        )
    );
}


TEST(fractureFlowInput, missingEntriesAreNamed)
{
    EXPECT_TRUE(mentions(messageOfRim(rim(2, 2), "gelPatch gel;"), {"U"}));
    EXPECT_TRUE(mentions(messageOfRim(rim(2, 2), "U (1 0 0);"), {"gelPatch"}));

    flowCase c(rim(2, 2));
    EXPECT_TRUE
    (
        mentions
        (
            messageOf([&]() { c.newFlow("model uniform;"); }),
            {"U", "uniformCoeffs"}
        )
    );
}


TEST(fractureFlowInput, gelPatchThatIsNotThereListsThePatches)
{
    EXPECT_TRUE
    (
        mentions
        (
            messageOfRim(rim(2, 2), "U (1 0 0); gelPatch clay;"),
            {"clay", "inlet", "outlet", "gel", "water", "back", "front"}
        )
    );
}


TEST(fractureFlowInput, meshThatIsNotLayeredPointsToStokes)
{
    // Columns from two sides meet
    boxSpec corner = rim(4, 4);
    corner.patches[0] = "gel";
    EXPECT_TRUE
    (
        mentions(messageOfRim(corner), {"not layered", "gel", "Stokes"})
    );
}


TEST(fractureFlowInput, closedFarSideIsRefused)
{
    for (const word type : {"wall", "symmetryPlane"})
    {
        boxSpec spec = rim(4, 4);
        spec.types[3] = type;
        EXPECT_TRUE
        (
            mentions(messageOfRim(spec), {"water", type, "open"})
        );
    }

    boxSpec spec = rim(4, 4);
    spec.types[2] = spec.types[3] = "cyclic";
    EXPECT_TRUE(mentions(messageOfRim(spec), {"water", "cyclic", "open"}));
}


// What the annotated dictionary says is what the models read
TEST(fractureFlowInput, annotatedDictionaryIsAccepted)
{
    const fileName file
    (
        getEnv("BENTOFOAM_DIR")/"etc/caseDicts/fractureFlowProperties"
    );
    ASSERT_TRUE(isFile(file)) << "source etc/bashrc first";

    dictionary properties{IFstream(file)()};
    properties.remove("FoamFile");

    for (const word model : {"none", "uniform", "localViscosity"})
    {
        flowCase c(rim(4, 4));
        properties.set("model", model);
        EXPECT_EQ
        (
            messageOf
            (
                [&]()
                {
                    fractureFlow::New(c.mesh(), c.alpha(), properties)->solve();
                }
            ),
            ""
        ) << model;
    }
}
