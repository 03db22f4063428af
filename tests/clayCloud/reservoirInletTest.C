/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inletBox.H"
#include "reservoirInlet.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

namespace
{

constexpr scalar fraction = 0.005;

//- pi/4 (200 nm)^2 1 nm over the fraction
const scalar spacing = std::cbrt(std::acos(-1.0)*1e-23/fraction);


//- A reservoir below a patch of 25 x 5 spacings: five pieces of 5 x 5, of 50
//  platelets within two spacings of the patch and 60 in the layer
struct reservoirOfFive
:
    inletBox
{
    static constexpr label number = 5;

    reservoirInlet inlet;

    reservoirOfFive()
    :
        inletBox((1 + 1e-9)*spacing*vector(2.5, 5, 1.25), nullptr, spacing),
        inlet
        (
            "gel",
            dict("type reservoir; patch lowerY; fraction 0.005;"),
            {made.mesh(), properties, interactions, axes, 0}
        )
    {}

    static label pieceOf(const point& x)
    {
        return label(x.x()/(5*spacing));
    }
};


//- By pieces
using numbers = FixedList<label, reservoirOfFive::number>;


numbers entering(const clayInlet::change& change)
{
    numbers sums(label(0));
    for (const patchLayer::place& p : change.enter)
    {
        ++sums[reservoirOfFive::pieceOf(p.x)];
    }
    return sums;
}

} // End anonymous namespace


TEST(reservoirInlet, isFilledEvenlyAtFirst)
{
    reservoirOfFive c;
    const auto change = c.inlet.supply({}, 0, 1);

    EXPECT_EQ(c.inlet.waited(), 0);
    for (const label n : entering(change))
    {
        EXPECT_NEAR(n, 60, 1);
    }
    EXPECT_NEAR(change.enter.size(), 300, 1);
    EXPECT_EQ(change.leave.size(), 0);
}


// Clay on both sides of the patch alike, but before and behind one piece, from which
// all has gone. There N = 0, and with t = 6 dt
//     N* dt/t + R dt = 50/6 + (1 - exp(-1/6)) 60
// enters at once, and next time, when what entered has gone as well, R has moved
// towards that. Where nothing has gone a sixth of what is missing enters or leaves,
// and a sixtieth of it besides if it is less than a tenth
TEST(reservoirInlet, suppliesEachPieceByItself)
{
    reservoirOfFive c;
    const scalar deltaT = c.inlet.interval(0);
    const auto first = c.inlet.supply({}, 0, deltaT);
    const label robbed = 2;

    clayInlet::neighbours near;
    FixedList<scalar, reservoirOfFive::number> atPatch(scalar(0));
    numbers inLayer(label(0));
    for (const patchLayer::place& p : first.enter)
    {
        const label piece = c.pieceOf(p.x);
        ++inLayer[piece];
        if (piece != robbed)
        {
            near.x.append(p.x);
            near.x.append(point(p.x.x(), -p.x.y(), p.x.z()));
            near.id.append(near.id.size());
            near.id.append(near.id.size());
            atPatch[piece] += 2*max(0.0, 1 - mag(p.x.y())/(2*spacing));
        }
    }

    const scalar learnt = 1 - std::exp(-1.0/6);
    const scalar gone = learnt*inLayer[robbed];
    label supplied = 0;

    for (label time = 0; time < 2; ++time)
    {
        const auto change = c.inlet.supply(near, 0, deltaT);
        const auto in = entering(change);

        // What is left over by rounding up or down is less than 1
        const scalar expected =
            50.0/6 + gone + (time ? learnt*(supplied - gone) : 0);
        EXPECT_LT(mag(in[robbed] - expected), 1) << expected;
        supplied = in[robbed];

        numbers out(label(0));
        for (const label id : change.leave)
        {
            ++out[c.pieceOf(near.x[id])];
        }
        EXPECT_EQ(out[robbed], 0);

        for (label piece = 0; piece < c.number; ++piece)
        {
            const scalar missing = 50 - atPatch[piece];
            const scalar missed = mag(missing) < 5 ? missing*(time + 1)/60 : 0;

            if (piece != robbed)
            {
                EXPECT_LT
                (
                    mag(in[piece] - out[piece] - (missing + missed)/6), 1
                ) << piece << ' ' << missing;
            }
        }
    }
    EXPECT_EQ(c.inlet.waited(), 0);
}


// As many in each piece as before, at a depth at which they count so much that this
// is missing. Over dt = 3 t three times of it enter or leave, and where it is less than
// a tenth of N* its integral over 10 t, 0.3 of it, three times as well
TEST(reservoirInlet, addsUpWhatLittleIsMissing)
{
    reservoirOfFive c;
    const scalar deltaT = 18*c.inlet.interval(0);
    const auto first = c.inlet.supply({}, 0, deltaT);
    const numbers inLayer(entering(first));
    const scalar missing[reservoirOfFive::number] = {6, 4, 0, -4, -6};

    clayInlet::neighbours near;
    for (label piece = 0; piece < c.number; ++piece)
    {
        const label n = inLayer[piece];
        for (label i = 0; i < n; ++i)
        {
            const scalar across = 0.618*i - std::floor(0.618*i);
            near.x.append
            (
                spacing*point
                (
                    5*(piece + (i + 0.5)/n),
                    -2*(1 - (50 - missing[piece])/n),
                    5*across
                )
            );
            near.id.append(near.id.size());
        }
    }

    const auto change = c.inlet.supply(near, 0, deltaT);
    const auto in = entering(change);
    numbers out(label(0));
    for (const label id : change.leave)
    {
        ++out[c.pieceOf(near.x[id])];
    }

    for (label piece = 0; piece < c.number; ++piece)
    {
        const scalar expected =
            3*missing[piece]*(mag(missing[piece]) < 5 ? 1.3 : 1);

        EXPECT_LT(mag(in[piece] - out[piece] - expected), 1) << piece;
    }
    EXPECT_EQ(c.inlet.waited(), 0);
}
