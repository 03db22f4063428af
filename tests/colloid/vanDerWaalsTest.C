/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vanDerWaals.H"
#include "physicalConstants.H"
#include "referenceTable.H"

#include "error.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::colloid;

namespace
{

// Eq. 3-7 as printed. It cancels as (delta/h)^2, 1e-10 at 1e-4 m: quadruple
// precision keeps 20 digits of that
__float128 printedForce(const platelet& clay, const __float128 h)
{
    const __float128 delta = clay.thickness;
    const __float128 a = h;
    const __float128 b = h + delta;
    const __float128 c = h + 2*delta;

    return
        __float128(clay.Hamaker*clay.faceArea()/(6*physicalConstants::pi))
       *(1/(a*a*a) - 2/(b*b*b) + 1/(c*c*c));
}

} // End anonymous namespace


TEST(vanDerWaals, agreesWithTheReference)
{
    const vanDerWaals attraction{platelet()};

    for (const referenceRow& row : referenceTable("colloid.csv"))
    {
        const scalar h = row.at("h");
        EXPECT_LT(relativeError(attraction.force(h), row.at("F_vdW")), 1e-10);
        EXPECT_LT(relativeError(attraction.slope(h), row.at("dF_vdW")), 1e-10);
    }

    for (const referenceRow& row : referenceTable("suspension.csv"))
    {
        EXPECT_LT
        (
            relativeError(attraction.force(row.at("h")), row.at("F_vdW")),
            1e-10
        );
    }
}


// Rounding only: a dozen operations
TEST(vanDerWaals, agreesWithThePrintedFormInQuadruplePrecision)
{
    for (const scalar thickness : {1e-9, 2e-10, 1e-7})
    {
        platelet clay;
        clay.thickness = thickness;
        const vanDerWaals attraction(clay);

        for (scalar h = 1e-10; h < 1.1e-4; h *= 1.37)
        {
            const scalar printed = scalar(printedForce(clay, h));
            EXPECT_LT(relativeError(attraction.force(h), printed), 1e-14)
                << h << ' ' << thickness;
        }
    }
}


// The integral's end leaves out 1e-12 of it; Simpson's rule on 2000
// intervals in ln(h) errs by less
TEST(vanDerWaals, energyIsTheIntegralOfTheForce)
{
    const vanDerWaals attraction{platelet()};

    for (const scalar h : {1e-10, 1e-9, 3e-8, 1e-5})
    {
        const label n = 20000;
        const scalar step = std::log(1e4)/n;
        scalar sum = 0;

        for (label i = 0; i <= n; ++i)
        {
            const scalar x = h*std::exp(i*step);
            const scalar weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
            sum += weight*attraction.force(x)*x;
        }

        // From h to 1e4 h
        const scalar difference =
            attraction.energy(h) - attraction.energy(1e4*h);

        EXPECT_LT(relativeError(sum*step/3, difference), 1e-10) << h;
    }
}


TEST(vanDerWaals, slopeIsTheDerivativeOfTheForce)
{
    const vanDerWaals attraction{platelet()};

    for (scalar h = 1e-10; h < 1.1e-4; h *= 1.9)
    {
        // Fourth-order differences: error (d/h)^4 times 7th powers of h
        const scalar d = 1e-3*h;
        const scalar difference =
        (
            8*(attraction.force(h + d) - attraction.force(h - d))
          - (attraction.force(h + 2*d) - attraction.force(h - 2*d))
        )/(12*d);

        EXPECT_LT(relativeError(attraction.slope(h), difference), 1e-9) << h;
    }
}


TEST(vanDerWaals, fallsMonotonicallyAndNeverTraps)
{
    const vanDerWaals attraction{platelet()};
    scalar previous = GREAT;

    // Floating-point traps are on in this program
    for (scalar h = 1e-10; h < 1e-4; h *= 1.001)
    {
        const scalar force = attraction.force(h);
        ASSERT_GT(force, 0);
        ASSERT_LT(force, previous);
        ASSERT_LT(attraction.slope(h), 0);
        previous = force;
    }

    for (const scalar h : {1.0, 1e15, 1e60, 1e200})
    {
        EXPECT_LT(attraction.force(h), 1e-50);
        EXPECT_GE(attraction.force(h), 0);
        EXPECT_LE(attraction.slope(h), 0);
        EXPECT_GE(attraction.energy(h), 0);
    }
}


TEST(vanDerWaals, refusesGapsThatAreNotPositive)
{
    const vanDerWaals attraction{platelet()};
    EXPECT_THROW(attraction.force(0), Foam::error);
    EXPECT_THROW(attraction.slope(-1e-9), Foam::error);
    EXPECT_THROW(attraction.energy(0), Foam::error);
}


// ************************************************************************* //
