/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inletBox.H"
#include "patchPieces.H"

#include <gtest/gtest.h>

#include <random>

using namespace Foam;

namespace
{

//- Layer behind the lower side, of 10 x 4 faces of 1 um, without some columns
struct layerOfMicrometres
:
    inletBox
{
    const patchLayer layer;

    explicit layerOfMicrometres
    (
        const std::function<bool(const indices&)>& leftOut = nullptr
    )
    :
        inletBox(vector(1e-6, 1e-6, 1e-6), leftOut),
        layer
        (
            made.mesh(),
            made.mesh().boundaryMesh().findPatchID("lowerY"),
            1e-6, 0, axes, properties, dict("patch lowerY;")
        )
    {}

    //- By micrometres along and across the patch, at any height
    static point at(const scalar x, const scalar z, const scalar y = 0)
    {
        return 1e-6*point(x, y, z);
    }
};


scalar sumOfShares(const patchPieces& pieces)
{
    scalar sum = 0;
    for (label i = 0; i < pieces.size(); ++i)
    {
        sum += pieces.share(i);
    }
    return sum;
}

} // End anonymous namespace


// A border amid faces leaves each piece one of the face's two triangles
TEST(patchPieces, areEqualWhereTheyDivideAPatch)
{
    const layerOfMicrometres c;

    for
    (
        const auto& [edge, number] :
        {
            std::pair<scalar, label>{2.499e-6, 4}, {1.999e-6, 10}, {2.01e-6, 4},
            {4.999e-6, 2}, {1.1e-5, 1}, {1, 1}
        }
    )
    {
        const patchPieces pieces(c.layer, edge);

        ASSERT_EQ(pieces.size(), number) << edge;
        for (label i = 0; i < number; ++i)
        {
            EXPECT_NEAR(pieces.share(i)*number, 1, 1e-12) << edge << ' ' << i;
        }
    }
}


TEST(patchPieces, areSquareFieldsStraightBeforeAndBehind)
{
    const layerOfMicrometres c;
    const patchPieces pieces(c.layer, 1.999e-6);

    // 5 x 2 fields of 2 um, each a piece of its own
    labelHashSet met;
    for (label i = 0; i < 5; ++i)
    {
        for (label k = 0; k < 2; ++k)
        {
            const label piece = pieces.of(c.at(2*i + 0.1, 2*k + 0.1));

            ASSERT_GE(piece, 0);
            EXPECT_TRUE(met.insert(piece)) << i << ' ' << k;
            for (const scalar y : {-0.9, -0.1, 0.1, 2.9})
            {
                EXPECT_EQ(pieces.of(c.at(2*i + 1.9, 2*k + 1.9, y)), piece);
                EXPECT_EQ(pieces.of(c.at(2*i + 0.1, 2*k + 1.9, y)), piece);
            }
        }
    }

    for (const point& beside : {c.at(-0.1, 1), c.at(10.1, 1), c.at(5, 4.1)})
    {
        EXPECT_EQ(pieces.of(beside), -1);
    }
}


// A patch like an L: where nothing of it is there is no piece, and the piece at its
// inner corner, half a field, has half of the share
TEST(patchPieces, areNoneWhereThePatchIsNot)
{
    const layerOfMicrometres c
    (
        [](const indices& cell) { return cell[0] >= 5 && cell[2] >= 2; }
    );
    const patchPieces pieces(c.layer, 1.999e-6);

    EXPECT_EQ(pieces.size(), 8);
    EXPECT_NEAR(sumOfShares(pieces), 1, 1e-12);
    EXPECT_EQ(pieces.of(c.at(7, 3)), -1);

    for (label piece = 0; piece < pieces.size(); ++piece)
    {
        const bool atCorner = piece == pieces.of(c.at(4.5, 3));
        EXPECT_NEAR(pieces.share(piece), (atCorner ? 2.0 : 4.0)/30, 1e-12);
    }
}


TEST(patchPieces, placesOfAPieceFillItEvenly)
{
    const layerOfMicrometres c;
    const patchPieces pieces(c.layer, 1.999e-6);
    const label piece = pieces.of(c.at(5, 1));
    const label places = 20000;

    std::mt19937 engine(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    vector sum(Zero);
    vector squares(Zero);

    for (label n = 0; n < places; ++n)
    {
        const patchLayer::place p
        (
            c.layer.at
            (
                {uniform(engine), uniform(engine), uniform(engine)},
                0.5e-6,
                pieces.weightUpTo(piece)
            )
        );
        ASSERT_EQ(pieces.of(p.x), piece);

        const vector off((p.x - c.at(5, 1, -0.5))/1e-6);
        sum += off;
        squares += cmptMultiply(off, off);
    }

    // Of 2 um about the middle: variance 1/3; standard errors 0.004 and 0.002
    EXPECT_NEAR(sum.x()/places, 0, 0.015);
    EXPECT_NEAR(sum.z()/places, 0, 0.015);
    EXPECT_NEAR(squares.x()/places, 1.0/3, 0.008);
    EXPECT_NEAR(squares.z()/places, 1.0/3, 0.008);
    EXPECT_NEAR(sum.y(), 0, 1e-9);
}
