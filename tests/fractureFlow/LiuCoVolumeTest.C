/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowCase.H"
#include "LiuCoVolume.H"
#include "OSspecific.H"
#include "surfaceFields.H"

#include <gtest/gtest.h>

using namespace Foam;

//- What a stock solver has before it makes its viscosity model: U and phi
struct solverCase
:
    flowCase
{
    volVectorField U;
    surfaceScalarField phi;

    static boxSpec spec()
    {
        boxSpec result;
        result.cells = {4, 4, 1};
        return result;
    }

    //- Without the field alpha.clay of flowCase where a solver has none
    explicit solverCase(const bool hasAlpha)
    :
        flowCase(spec()),
        U
        (
            IOobject("U", time().timeName(), mesh()),
            mesh(),
            dimensionedVector(dimVelocity, Zero)
        ),
        phi
        (
            IOobject("phi", time().timeName(), mesh()),
            mesh(),
            dimensionedScalar(dimVelocity*dimArea, Zero)
        )
    {
        if (!hasAlpha)
        {
            alpha().checkOut();
        }
    }

    autoPtr<viscosityModel> newModel
    (
        const string& properties = "transportModel LiuCoVolume;"
    )
    {
        return viscosityModel::New("nu", dictionaryOf(properties), U, phi);
    }

    //- Inside, on the front, and in which time directory
    void writeAlpha
    (
        const string& value,
        const string& front = "0.3",
        const word& folder = "0"
    ) const
    {
        writeField
        (
            "alpha.clay",
            "volScalarField",
            "[0 0 0 0 0 0 0]",
            "uniform " + value,
            {
                {"inlet", "type fixedValue; value uniform 0;"},
                {"outlet", "type zeroGradient;"},
                {"bottom", "type zeroGradient;"},
                {"top", "type zeroGradient;"},
                {"back", "type zeroGradient;"},
                {"front", "type calculated; value uniform " + front + ";"}
            },
            folder
        );
    }
};

static colloid::coVolumeViscosity law(const string& properties)
{
    const colloid::clayProperties clay(dictionaryOf(properties));
    return clay.viscosity(clay.waterAt(0));
}


TEST(LiuCoVolume, isTheLawOfClayPropertiesOverTheDensityOfWater)
{
    const string text
    (
        "water { concentration 1; viscosity 2e-3; density 1025; }"
    );
    solverCase c(true);
    c.writeClayProperties(text);

    forAll(c.alpha(), i)
    {
        c.alpha()[i] = 1e-3*(i + 1);
    }
    c.alpha().correctBoundaryConditions();

    auto model = c.newModel();
    const volScalarField nu(model->nu());
    const auto expected = law(text);

    forAll(nu, i)
    {
        const scalar nui =
            2e-3/1025*expected.relativeViscosity(c.alpha()[i]);
        EXPECT_NEAR(nu[i], nui, 1e-14*nui);
    }
    EXPECT_EQ(nu.dimensions(), dimViscosity);
}


TEST(LiuCoVolume, gelIsAsStiffAsGelViscositySays)
{
    solverCase c(true);
    c.writeClayProperties
    (
        "water { concentration 0.1; } viscosity { gelViscosity 1e5; }"
    );
    c.alpha() == 0.05;

    // 1e-3 Pa s over 1000 kg/m3
    EXPECT_NEAR(max(c.newModel()->nu()()).value(), 1e5*1e-6, 1e-12);
}


TEST(LiuCoVolume, patchesHaveTheViscosityOfTheirValueOrTheirCells)
{
    solverCase c(false);
    c.writeAlpha("0.01");
    auto model = c.newModel();

    const scalar ofClay = 1e-6*law
    (
        "water { concentration 0.1; } viscosity { gelStop off; }"
    ).relativeViscosity(0.01);

    const auto expectPatch = [&](const word& name, const scalar expected)
    {
        const label patchi = c.mesh().boundaryMesh().findPatchID(name);
        const scalarField nu(model->nu(patchi));
        EXPECT_LT(gMax(mag(nu - expected)()), 1e-12*expected) << name;
    };

    expectPatch("inlet", 1e-6);
    expectPatch("outlet", ofClay);

    // calculated: nobody has calculated it
    expectPatch("front", ofClay);
}


TEST(LiuCoVolume, alphaThatNoSolverOwnsIsReadAndReadAgain)
{
    solverCase c(false);
    c.writeAlpha("0", "0", "0");
    auto model = c.newModel();
    EXPECT_NEAR(max(model->nu()()).value(), 1e-6, 1e-20);

    // Nothing at the next time: it stays, and is written there with the rest
    c.time()++;
    model->correct();
    EXPECT_NEAR(max(model->nu()()).value(), 1e-6, 1e-20);

    const volScalarField& alpha =
        c.mesh().lookupObject<volScalarField>("alpha.clay");
    EXPECT_EQ(alpha.writeOpt(), IOobject::AUTO_WRITE);
    alpha.write();
    EXPECT_TRUE(isFile(c.time().timePath()/"alpha.clay"));

    c.time()++;
    c.writeAlpha("0.01", "0", c.time().timeName());
    model->correct();
    EXPECT_GT(max(model->nu()()).value(), 2e-6);
}


TEST(LiuCoVolume, alphaThatNobodyHasIsAnErrorThatNamesIt)
{
    solverCase c(false);
    EXPECT_TRUE(mentions(messageOf([&]() { c.newModel(); }), {"alpha.clay"}));
}


TEST(LiuCoVolume, followsTheConcentrationInTime)
{
    solverCase c(true);
    c.writeClayProperties
    (
        "water { concentration table ((0 0.1) (10 10)); }"
        "viscosity { gelStop off; }"
    );
    c.alpha() == 0.003;

    auto model = c.newModel();
    const scalar before = max(model->nu()()).value();

    c.time().setTime(10, 10);
    model->correct();
    const scalar after = max(model->nu()()).value();

    const auto viscosity = [](const string& concentration)
    {
        return 1e-6*law
        (
            "water { concentration " + concentration + "; }"
            "viscosity { gelStop off; }"
        ).relativeViscosity(0.003);
    };

    EXPECT_NEAR(before, viscosity("0.1"), 1e-12*before);
    EXPECT_NEAR(after, viscosity("10"), 1e-12*after);
    EXPECT_GT(before, 1.5*after);
}


//- A field c as erosionFoam has it, 0.1 mol/m3 below the middle, 10 above
static autoPtr<volScalarField> layeredSalt(solverCase& c)
{
    wordList types(c.mesh().boundary().size(), "zeroGradient");
    forAll(types, patchi)
    {
        const polyPatch& pp = c.mesh().boundaryMesh()[patchi];
        types[patchi] =
            pp.coupled() ? pp.type()
          : pp.name() == "top" ? "fixedValue"
          : "zeroGradient";
    }

    autoPtr<volScalarField> salt
    (
        new volScalarField
        (
            IOobject("c", c.time().timeName(), c.mesh()),
            c.mesh(),
            dimensionedScalar("c", dimMoles/dimVolume, 0.1),
            types
        )
    );
    forAll(*salt, i)
    {
        salt()[i] = c.mesh().C()[i].y() < 0.5 ? 0.1 : 10;
    }
    const label top = c.mesh().boundaryMesh().findPatchID("top");
    salt->boundaryFieldRef()[top] == 50;
    salt->correctBoundaryConditions();

    return salt;
}


TEST(LiuCoVolume, followsALocalConcentration)
{
    const string text("water { concentration 1; }");
    solverCase c(true);
    c.writeClayProperties(text);
    c.alpha() == 0.007;

    auto model = c.newModel();
    const auto uniform = [](const string& concentration)
    {
        return 1e-6*law
        (
            "water { concentration " + concentration + "; }"
        ).relativeViscosity(0.007);
    };

    // Gel with 0.1, a sol with 10
    EXPECT_NEAR(uniform("0.1"), 1, 1e-12);
    EXPECT_LT(uniform("10"), 1e-5);

    {
        auto salt = layeredSalt(c);
        model->correct();
        const volScalarField nu(model->nu());

        forAll(nu, i)
        {
            const scalar expected =
                uniform(c.mesh().C()[i].y() < 0.5 ? "0.1" : "10");
            EXPECT_NEAR(nu[i], expected, 1e-12*expected);
        }

        const auto expectPatch = [&](const word& name, const string& salt)
        {
            const label patchi = c.mesh().boundaryMesh().findPatchID(name);
            const scalarField onPatch(model->nu(patchi));
            const scalar expected = uniform(salt);
            EXPECT_LT
            (
                gMax(mag(onPatch - expected)()), 1e-12*expected
            ) << name;
        };
        expectPatch("bottom", "0.1");
        expectPatch("top", "50");
    }

    // Without the field it is that of clayProperties again
    model->correct();
    EXPECT_NEAR(max(model->nu()()).value(), uniform("1"), 1e-18);
}


TEST(LiuCoVolume, localConcentrationThatCannotBeIsRefused)
{
    solverCase c(true);
    auto model = c.newModel();
    {
        auto salt = layeredSalt(c);
        salt() == dimensionedScalar(salt->dimensions(), Zero);
        EXPECT_TRUE
        (
            mentions
            (
                messageOf([&]() { model->correct(); }),
                {"0 mol/m3", "field c", "above zero"}
            )
        );
    }

    volScalarField other
    (
        IOobject("c", c.time().timeName(), c.mesh()),
        c.mesh(),
        dimensionedScalar("one", dimless, 1)
    );
    EXPECT_TRUE
    (
        mentions
        (
            messageOf([&]() { model->correct(); }),
            {"dimensions", "mol/m3", "[0 -3 0 0 1 0 0]"}
        )
    );
}


TEST(LiuCoVolume, coefficientsInTransportPropertiesAreRefused)
{
    solverCase c(true);
    EXPECT_TRUE
    (
        mentions
        (
            messageOf
            (
                [&]()
                {
                    c.newModel
                    (
                        "transportModel LiuCoVolume;"
                        "LiuCoVolumeCoeffs { coreThickness 2; }"
                    );
                }
            ),
            {"coreThickness", "constant/clayProperties"}
        )
    );
    EXPECT_EQ
    (
        messageOf
        (
            [&]()
            {
                c.newModel
                (
                    "transportModel LiuCoVolume; LiuCoVolumeCoeffs {}"
                );
            }
        ),
        ""
    );
}


// Both ways to the law give the same field
TEST(LiuCoVolume, fractureFlowHasTheSameViscosity)
{
    solverCase c(true);
    forAll(c.alpha(), i)
    {
        c.alpha()[i] = 1e-3*i;
    }
    auto flow = c.newFlow("model none;");
    const volScalarField nu("ofFlow", flow->nu());

    EXPECT_EQ(gMax(mag(nu - c.newModel()->nu())().primitiveField()), 0);
}
