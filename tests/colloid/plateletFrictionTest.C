/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "KozenyCarmanFriction.H"
#include "StokesFriction.H"
#include "constantFriction.H"
#include "referenceTable.H"

#include "IStringStream.H"
#include "error.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::colloid;

namespace
{

autoPtr<plateletFriction> newFriction(const word& model, const char* text)
{
    IStringStream stream(text);

    return plateletFriction::New
    (
        model, dictionary(stream), platelet(), water()
    );
}

} // End anonymous namespace


// Nine and ten digits were computed independently for the default platelet
TEST(plateletFriction, StokesIsThatOfALoneDisc)
{
    EXPECT_LT(relativeError(platelet().frictionRadius(), 6.386446922e-8), 1e-9);
    EXPECT_LT
    (
        relativeError
        (
            StokesFriction(platelet(), water()).value(0.3), 1.20381688e-9
        ),
        1e-8
    );
}


// A disc without thickness: C = diameter/pi
TEST(plateletFriction, radiusTendsToThatOfAThinDisc)
{
    platelet thin;
    thin.thickness = 1e-6*thin.diameter;
    EXPECT_LT
    (
        relativeError
        (
            thin.frictionRadius(), thin.diameter/physicalConstants::pi
        ),
        1e-6
    );
}


TEST(plateletFriction, KozenyCarmanAgreesWithTheReference)
{
    const KozenyCarmanFriction friction(platelet(), water(), 5);

    for (const char* table : {"colloid.csv", "suspension.csv"})
    {
        for (const referenceRow& row : referenceTable(table))
        {
            EXPECT_LT
            (
                relativeError(friction.value(row.at("phi")), row.at("xi")),
                1e-10
            );
        }
    }
}


TEST(plateletFriction, isProportionalToTheViscosity)
{
    water thick;
    thick.viscosity = 3e-3;

    EXPECT_DOUBLE_EQ
    (
        KozenyCarmanFriction(platelet(), thick, 5).value(0.01),
        3*KozenyCarmanFriction(platelet(), water(), 5).value(0.01)
    );
}


TEST(plateletFriction, aFixedFractionReplacesTheLocalOne)
{
    const auto local =
        newFriction("KozenyCarman", "Kozeny 5; fraction local;");
    const auto fixed =
        newFriction("KozenyCarman", "Kozeny 5; fraction 0.01;");

    EXPECT_TRUE(local->varies());
    EXPECT_EQ(fixed->slope(0.3), 0);

    // Fourth-order difference
    const scalar h = 1e-3;
    const auto f = [&](int i) { return local->value(0.3 + i*h); };
    EXPECT_NEAR
    (
        (8*(f(1) - f(-1)) - f(2) + f(-2))/(12*h)/local->slope(0.3), 1, 1e-9
    );
    EXPECT_FALSE(fixed->varies());
    EXPECT_EQ(fixed->value(0.5), local->value(0.01));
    EXPECT_GT(local->value(0.5), local->value(0.01));
}


TEST(plateletFriction, constantIsItsValue)
{
    const auto friction = newFriction("constant", "value 1.2e-9;");
    EXPECT_EQ(friction->value(0), 1.2e-9);
    EXPECT_EQ(friction->value(0.5), 1.2e-9);
    EXPECT_FALSE(friction->varies());
    EXPECT_EQ(friction->clone()->value(0), 1.2e-9);
}


TEST(plateletFriction, refusesWhatIsImpossible)
{
    EXPECT_THROW(newFriction("auto", ""), Foam::error);
    EXPECT_THROW(newFriction("Stoke", ""), Foam::error);
    EXPECT_THROW(newFriction("constant", ""), Foam::error);
    EXPECT_THROW(newFriction("constant", "value -1;"), Foam::error);
    EXPECT_THROW(newFriction("KozenyCarman", "Kozeny -5;"), Foam::error);
    EXPECT_THROW
    (
        newFriction("KozenyCarman", "Kozeny 5; fraction 1.2;"), Foam::error
    );
    EXPECT_THROW
    (
        newFriction("KozenyCarman", "Kozeny 5; fraction locla;"), Foam::error
    );
}


// ************************************************************************* //
