/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxMesh.H"
#include "periodicAxes.H"

#include "unitConversion.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- 10 nm cells
boxSettings smallBox()
{
    boxSettings box;
    box.n = {{10, 6, 4}};
    box.size = vector(1e-7, 6e-8, 4e-8);
    return box;
}


//- What the refusal says; empty if there is none
std::string refusal(const boxSettings& box)
{
    const boxMesh made(box);
    try
    {
        const periodicAxes axes(made.mesh());
    }
    catch (const Foam::error& err)
    {
        return err.message();
    }
    return "";
}

} // End anonymous namespace


TEST(periodicAxes, areThoseOfTheCyclicPatches)
{
    boxSettings box(smallBox());
    box.periodic = {{true, false, true}};

    const boxMesh made(box);
    const periodicAxes axes(made.mesh());

    EXPECT_TRUE(axes.periodic(0));
    EXPECT_FALSE(axes.periodic(1));
    EXPECT_TRUE(axes.periodic(2));
    EXPECT_DOUBLE_EQ(axes.period(0), 1e-7);
    EXPECT_EQ(axes.period(1), 0);
    EXPECT_DOUBLE_EQ(axes.lower(2), 0);
    EXPECT_DOUBLE_EQ(axes.upper(1), 6e-8);
    EXPECT_DOUBLE_EQ(axes.upper(2), 4e-8);
}


TEST(periodicAxes, nearestImageIsNoLongerThanHalfThePeriod)
{
    boxSettings box(smallBox());
    box.periodic = {{true, false, false}};
    const boxMesh made(box);
    const periodicAxes axes(made.mesh());

    const vector nearest(axes.nearestImage(vector(9e-8, 5e-8, -3e-8)));

    EXPECT_NEAR(nearest.x(), -1e-8, 1e-20);
    EXPECT_DOUBLE_EQ(nearest.y(), 5e-8);
    EXPECT_DOUBLE_EQ(nearest.z(), -3e-8);
}


TEST(periodicAxes, refuseARotation)
{
    boxSettings box(smallBox());
    box.periodic = {{false, true, false}};
    // A quarter of a ring: its ends at 0 and 90 degrees
    box.map = [](const point& p, const indices&)
    {
        const scalar angle = p.y()/6e-8*degToRad(90.);
        const scalar r = 1e-7 + p.x();
        return point(r*std::cos(angle), r*std::sin(angle), p.z());
    };

    EXPECT_NE(refusal(box).find("rotational"), std::string::npos);
}


TEST(periodicAxes, refuseATranslationAcrossTheAxes)
{
    boxSettings box(smallBox());
    box.periodic = {{true, false, false}};
    box.map = [](const point& p, const indices&)
    {
        return point(p.x() - p.y(), p.x() + p.y(), p.z());
    };

    EXPECT_NE
    (
        refusal(box).find("not a translation along x, y or z"),
        std::string::npos
    );
}


TEST(periodicAxes, refuseTwoPeriodsOnOneAxis)
{
    boxSettings box(smallBox());
    box.periodic = {{true, false, false}};
    // An L: upper rows are shorter
    box.leftOut = [](const indices& cell)
    {
        return cell[0] >= 6 && cell[1] >= 3;
    };

    EXPECT_NE(refusal(box).find("one period per axis"), std::string::npos);
}


TEST(periodicAxes, refuseAPeriodThatIsNotTheExtent)
{
    boxSettings box(smallBox());
    box.periodic = {{true, false, false}};
    // Steps: all rows are 6 cells long, the upper ones begin later
    box.leftOut = [](const indices& cell)
    {
        return cell[1] < 3 ? cell[0] >= 6 : cell[0] < 4;
    };

    EXPECT_NE
    (
        refusal(box).find("the period must be the whole extent"),
        std::string::npos
    );
}
