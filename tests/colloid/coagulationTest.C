/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coagulation.H"
#include "KozenyCarmanFriction.H"
#include "diffusivity.H"

#include "IStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::colloid;

namespace
{

dictionary parse(const char* text)
{
    IStringStream stream(text);
    return dictionary(stream);
}

const char* const defaults = "water { concentration 1; }";

// D from a friction, as a user of the class sees it
scalar D(const clayProperties& properties, scalar concentration, scalar phi)
{
    water solution(properties.waterAt(0));
    solution.concentration = concentration;

    return diffusivity
    (
        properties.clay(),
        solution,
        properties.newDoubleLayer("compression", solution)(),
        KozenyCarmanFriction(properties.clay(), solution, 5)
    ).value(phi);
}

} // End anonymous namespace


// Computed independently for the default platelet, with the digits it has
TEST(coagulation, happensAbove76WithTheDefaults)
{
    const clayProperties properties(parse(defaults));
    const auto critical = coagulation(properties).critical();

    ASSERT_TRUE(critical.found);
    EXPECT_NEAR(critical.concentration, 76, 0.5);
    EXPECT_NEAR(critical.fraction, 0.048, 0.0005);
}


// By looking at D itself on a fine grid of the dilute side
TEST(coagulation, theDiffusivityChangesSignThere)
{
    const clayProperties properties(parse(defaults));
    const auto critical = coagulation(properties).critical();

    bool negativeBelow = false;
    bool negativeAbove = false;

    for (scalar phi = 1e-3; phi < 0.1; phi *= 1.0005)
    {
        negativeBelow |= D(properties, 0.9999*critical.concentration, phi) < 0;
        negativeAbove |= D(properties, 1.0001*critical.concentration, phi) < 0;
    }

    EXPECT_FALSE(negativeBelow);
    EXPECT_TRUE(negativeAbove);
}


TEST(coagulation, namesTheFractionsOfNegativeDiffusivity)
{
    const clayProperties properties(parse(defaults));
    const coagulation law(properties);

    EXPECT_FALSE(law.negative(70).found);

    for (const scalar c : {77.0, 100.0, 1000.0})
    {
        const auto range = law.negative(c);

        ASSERT_TRUE(range.found);
        EXPECT_GT(D(properties, c, range.lower*0.9999), 0) << c;
        EXPECT_LT(D(properties, c, range.lower*1.0001), 0) << c;
        EXPECT_LT(D(properties, c, range.upper*0.9999), 0) << c;
        EXPECT_GT(D(properties, c, range.upper*1.0001), 0) << c;
    }
}


// More attraction or less charge: less salt does
TEST(coagulation, comesEarlierWithMoreAttractionAndLessCharge)
{
    const auto critical = [](const char* text)
    {
        const clayProperties properties(parse(text));
        return coagulation(properties).critical().concentration;
    };

    const scalar usual = critical(defaults);

    EXPECT_LT
    (
        critical("platelet { Hamaker 3e-20; } water { concentration 1; }"),
        0.8*usual
    );
    EXPECT_LT
    (
        critical
        (
            "platelet { surfaceCharge 0.02; } water { concentration 1; }"
        ),
        usual
    );
    EXPECT_LT
    (
        critical("parameterSet Kratos; water { concentration 1; }"),
        0.2*usual
    );
}


TEST(coagulation, neverHappensWithoutAttraction)
{
    const clayProperties properties
    (
        parse("platelet { Hamaker 0; } water { concentration 1; }")
    );

    EXPECT_FALSE(coagulation(properties).critical().found);
    EXPECT_FALSE(coagulation(properties).negative(1000).found);
}


TEST(coagulation, happensAtOnceWithoutRepulsion)
{
    const clayProperties properties(parse(defaults));
    const coagulation law
    (
        properties, parse("model exponential; P0 0; kappa 1e8;")
    );
    const auto critical = law.critical();

    EXPECT_TRUE(critical.found);
    EXPECT_LT(critical.concentration, 1.001e-4);
}


// ************************************************************************* //
