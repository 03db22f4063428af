/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    fluxFit against synthetic cells of which D is known, alike on any number of
    ranks, each of which has its share of the cells.
\*---------------------------------------------------------------------------*/

#include "fluxFit.H"
#include "Pstream.H"

#include <gtest/gtest.h>

#include <random>

using namespace Foam;

namespace
{

constexpr label pieces = 8;

//- phi from 0.001 to 0.01, gradients of it over some 1e-7 m
struct cells
{
    std::mt19937_64 random{20261122};
    std::uniform_real_distribution<> uniform;
    std::normal_distribution<> normal;

    //- D [m2/s] at a fraction; noise of the flux that a cell, and that all
    //  cells of a piece have in common [m/s]
    template<class Diffusivity>
    void add
    (
        fluxFit& fit,
        const Diffusivity& D,
        const scalar ofCell = 0,
        const scalar ofPiece = 0
    )
    {
        fit.nextSample();

        std::vector<vector> common(pieces);
        for (vector& v : common)
        {
            v = ofPiece*vector(normal(random), normal(random), normal(random));
        }
        for (label i = 0; i < 1000; ++i)
        {
            const scalar phi = 0.001 + 0.009*uniform(random);
            const vector g
            (
                3e4*vector(normal(random), normal(random), normal(random))
            );
            const vector q
            (
                -D(phi)*g + common[i%pieces]
              + ofCell*vector(normal(random), normal(random), normal(random))
            );
            const scalar volume = 1e-24*(1 + uniform(random));

            if (i%Pstream::nProcs() == Pstream::myProcNo())
            {
                fit.add(i%pieces, volume, phi, q, g);
            }
        }
    }
};

const fractionBins oneBin(1e-3, 1e-2, 1, false);

} // End anonymous namespace


TEST(fluxFit, isExactWithoutNoise)
{
    for
    (
        const auto weighting
      : {fluxFit::weighting::leastSquares, fluxFit::weighting::pointwise}
    )
    {
        fluxFit fit(fractionBins(1e-3, 1e-2, 5, true), pieces, weighting);
        cells all;
        all.add(fit, [](scalar) { return 2.5e-10; });

        const diffusivityTable table(fit.table());
        ASSERT_EQ(table.rows().size(), 5);
        for (const auto& row : table.rows())
        {
            EXPECT_NEAR(row.diffusivity, 2.5e-10, 1e-13*2.5e-10);
            EXPECT_LT(row.standardError, 1e-13*2.5e-10);
        }
    }
}


TEST(fluxFit, tellsTheFractionThatDBelongsTo)
{
    // D linear in phi: in each bin that at the mean of phi, however wide it is
    fluxFit fit(oneBin, pieces, fluxFit::weighting::leastSquares);
    cells all;
    all.add(fit, [](const scalar phi) { return 1e-8*phi; });

    const diffusivityTable table(fit.table());
    ASSERT_EQ(table.rows().size(), 1);
    const auto& row = table.rows()[0];
    EXPECT_NEAR(row.diffusivity, 1e-8*row.fraction, 1e-12*row.diffusivity);

    // Uniform from 0.001 to 0.01, four standard errors of a thousand
    EXPECT_NEAR(row.fraction, 0.0055, 4*0.009/Foam::sqrt(12*1000.0));
}


TEST(fluxFit, errorIsThatOfManyFits)
{
    // Noise that the cells of a piece share, which errors of independent cells
    // would take for ten times less
    scalar mean = 0;
    scalar squares = 0;
    scalar told = 0;
    const label repeats = 200;

    cells all;
    for (label repeat = 0; repeat < repeats; ++repeat)
    {
        fluxFit fit(oneBin, pieces, fluxFit::weighting::leastSquares);
        all.add(fit, [](scalar) { return 2e-10; }, 1e-6, 3e-6);

        const auto row = fit.table().rows()[0];
        mean += row.diffusivity/repeats;
        squares += sqr(row.diffusivity - 2e-10)/repeats;
        told += sqr(row.standardError)/repeats;
    }

    // Of 200 fits the spread is known to 5 %, of 7 degrees of freedom each the
    // mean of their squared errors to 4 %
    EXPECT_NEAR(Foam::sqrt(told/squares), 1, 0.2);
    EXPECT_NEAR(mean, 2e-10, 4*Foam::sqrt(squares/repeats));
}


TEST(fluxFit, samplesInARowAreOneBlockOfTime)
{
    // D that goes up slowly over a thousand samples: their mean, with an error
    // that shows it. Blocks are joined on the way, which loses none
    fluxFit fit(oneBin, pieces, fluxFit::weighting::leastSquares);
    cells all;
    const label samples = 1000;
    for (label sample = 0; sample < samples; ++sample)
    {
        const scalar D = 1e-10*(1 + scalar(sample)/samples);
        all.add(fit, [D](scalar) { return D; });
    }

    const diffusivityTable table(fit.table());
    ASSERT_EQ(table.rows().size(), 1);
    const auto& row = table.rows()[0];
    EXPECT_NEAR(row.diffusivity, 1.5e-10, 0.01e-10);
    EXPECT_LE(row.more[1], 16);

    // Of 16 blocks that go up evenly by 1e-10: 1e-10/sqrt(12*16)
    EXPECT_NEAR(row.standardError, 0.072e-10, 0.015e-10);
}


TEST(fluxFit, goesOnFromItsNumbers)
{
    // Broken off amid a block of time, and long enough after it for blocks to be
    // joined again
    fluxFit whole(oneBin, pieces, fluxFit::weighting::leastSquares);
    fluxFit before(oneBin, pieces, fluxFit::weighting::leastSquares);
    fluxFit after(oneBin, pieces, fluxFit::weighting::leastSquares);
    cells one;
    cells same;
    const auto add = [&](fluxFit& fit, cells& all, const label sample)
    {
        const scalar D = 1e-10*(1 + scalar(sample)/300);
        all.add(fit, [D](scalar) { return D; }, 1e-6);
    };

    for (label sample = 0; sample < 77; ++sample)
    {
        add(whole, one, sample);
        add(before, same, sample);
    }
    ASSERT_TRUE(after.restore(before.numbers()));
    for (label sample = 77; sample < 300; ++sample)
    {
        add(whole, one, sample);
        add(after, same, sample);
    }

    const diffusivityTable expected(whole.table());
    const diffusivityTable found(after.table());
    ASSERT_EQ(found.rows().size(), 1);
    const auto& row = found.rows()[0];
    const auto& of = expected.rows()[0];
    EXPECT_NEAR(row.diffusivity, of.diffusivity, 1e-12*of.diffusivity);
    EXPECT_NEAR(row.standardError, of.standardError, 1e-9*of.standardError);
    EXPECT_EQ(row.more[1], of.more[1]);

    fluxFit other
    (
        fractionBins(1e-3, 1e-2, 2, false),
        pieces,
        fluxFit::weighting::leastSquares
    );
    EXPECT_FALSE(other.restore(before.numbers()));
}


TEST(fluxFit, pointwiseHasSpikesWhereGradientsVanish)
{
    const scalar D = 2e-10;
    for
    (
        const auto weighting
      : {fluxFit::weighting::leastSquares, fluxFit::weighting::pointwise}
    )
    {
        fluxFit fit(oneBin, pieces, weighting);
        cells all;
        all.add(fit, [D](scalar) { return D; });

        // A cell with hardly any gradient, and a flux of the others' size
        if (Pstream::master())
        {
            fit.add(0, 1e-24, 5e-3, vector(1e-6, 0, 0), vector(-1e-3, 0, 0));
        }
        const auto row = fit.table().rows()[0];

        if (weighting == fluxFit::weighting::leastSquares)
        {
            EXPECT_NEAR(row.diffusivity, D, 1e-5*D);
        }
        else
        {
            EXPECT_GT(row.diffusivity, 1000*D);
        }
    }
}


TEST(fluxFit, leavesOutWhatHasNoError)
{
    fluxFit fit(oneBin, pieces, fluxFit::weighting::leastSquares);
    fit.nextSample();
    if (Pstream::master())
    {
        for (label piece = 0; piece < fluxFit::leastBlocks - 1; ++piece)
        {
            fit.add(piece, 1, 5e-3, vector(1, 0, 0), vector(-1, 0, 0));
        }
    }
    EXPECT_EQ(fit.table().rows().size(), 0);

    if (Pstream::master())
    {
        fit.add(7, 1, 5e-3, vector(1, 0, 0), vector(-1, 0, 0));

        // Outside of the bins
        fit.add(6, 1, 5e-2, vector(1, 0, 0), vector(-9, 0, 0));
    }
    const diffusivityTable table(fit.table());
    ASSERT_EQ(table.rows().size(), 1);
    EXPECT_DOUBLE_EQ(table.rows()[0].diffusivity, 1);
}


TEST(diffusivityTable, isLinearBetweenRowsAndHeldOutside)
{
    diffusivityTable table;
    table.append({0.001, 1e-11, 0, {}});
    table.append({0.003, 5e-11, 0, {}});
    EXPECT_DOUBLE_EQ(table.at(0.0005), 1e-11);
    EXPECT_DOUBLE_EQ(table.at(0.002), 3e-11);
    EXPECT_DOUBLE_EQ(table.at(0.0025), 4e-11);
    EXPECT_DOUBLE_EQ(table.at(0.02), 5e-11);
}
