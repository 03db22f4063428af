/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluxFit.H"
#include "PstreamReduceOps.H"


Foam::fluxFit::fluxFit
(
    const fractionBins& bins,
    const label pieces,
    const weighting weighting
)
:
    bins_(bins),
    pieces_(pieces),
    weighting_(weighting),
    samplesPerTime_(1),
    samples_(1)
{}


void Foam::fluxFit::nextSample()
{
    if (times_.size() && samples_ < samplesPerTime_)
    {
        ++samples_;
        return;
    }

    if (times_.size() == mostTimes)
    {
        for (label time = 0; time < mostTimes/2; ++time)
        {
            List<sums> joined(times_[2*time]);
            forAll(joined, i)
            {
                joined[i] += times_[2*time + 1][i];
            }
            times_[time].transfer(joined);
        }
        times_.setSize(mostTimes/2);
        samplesPerTime_ *= 2;
    }
    times_.append(List<sums>(pieces_*bins_.size()));
    samples_ = 1;
}


void Foam::fluxFit::add
(
    const label piece,
    const scalar volume,
    const scalar fraction,
    const vector& flux,
    const vector& gradient
)
{
    const label bin = bins_.find(fraction);
    const scalar square = magSqr(gradient);

    // Squares of what is no number any more would be none either
    if (bin < 0 || square <= VSMALL)
    {
        return;
    }

    const scalar weight =
        weighting_ == weighting::pointwise ? volume/square : volume;

    sums& to = times_.last()[piece*bins_.size() + bin];
    to.flux -= weight*(flux & gradient);
    to.gradient += weight*square;
    to.fraction += weight*square*fraction;
}


Foam::scalar Foam::fluxFit::variance
(
    const UList<sums>& blocks,
    const sums& all
)
{
    DynamicList<scalar> without(blocks.size());
    for (const sums& block : blocks)
    {
        if (block.gradient > 0 && block.gradient < all.gradient)
        {
            without.append
            (
                (all.flux - block.flux)/(all.gradient - block.gradient)
            );
        }
    }

    const label n = without.size();
    if (n < leastBlocks)
    {
        return -1;
    }

    scalar mean = 0;
    for (const scalar ratio : without)
    {
        mean += ratio/n;
    }
    scalar squares = 0;
    for (const scalar ratio : without)
    {
        squares += sqr(ratio - mean);
    }
    return squares*(n - 1)/n;
}


Foam::scalarList Foam::fluxFit::layout() const
{
    return
    {
        scalar(bins_.size()),
        bins_.middle(0),
        bins_.middle(bins_.size() - 1),
        scalar(pieces_)
    };
}


Foam::scalarList Foam::fluxFit::sumsOfRanks() const
{
    scalarList numbers(3*times_.size()*pieces_*bins_.size());
    label i = 0;
    for (const List<sums>& time : times_)
    {
        for (const sums& part : time)
        {
            numbers[i++] = part.flux;
            numbers[i++] = part.gradient;
            numbers[i++] = part.fraction;
        }
    }
    Pstream::listCombineGather(numbers, plusEqOp<scalar>());
    Pstream::listCombineScatter(numbers);
    return numbers;
}


Foam::scalarList Foam::fluxFit::numbers() const
{
    scalarList result(layout());
    result.append(scalar(samplesPerTime_));
    result.append(scalar(samples_));
    result.append(sumsOfRanks());
    return result;
}


bool Foam::fluxFit::restore(const scalarList& numbers)
{
    const scalarList expected(layout());
    const label begin = expected.size() + 2;
    const label perTime = 3*pieces_*bins_.size();

    if
    (
        numbers.size() < begin
     || (numbers.size() - begin) % perTime
     || SubList<scalar>(numbers, expected.size()) != expected
    )
    {
        return false;
    }

    samplesPerTime_ = label(numbers[begin - 2]);
    samples_ = label(numbers[begin - 1]);
    times_.clear();
    for (label i = begin; i < numbers.size(); )
    {
        times_.append(List<sums>(pieces_*bins_.size()));
        for (sums& part : times_.last())
        {
            // They are of all ranks: one has them, whichever
            if (Pstream::master())
            {
                part.flux = numbers[i];
                part.gradient = numbers[i + 1];
                part.fraction = numbers[i + 2];
            }
            i += 3;
        }
    }
    return true;
}


Foam::diffusivityTable Foam::fluxFit::table() const
{
    const label nBins = bins_.size();
    const scalarList numbers(sumsOfRanks());

    diffusivityTable result({"blocksOfSpace[-]", "blocksOfTime[-]"});

    for (label bin = 0; bin < nBins; ++bin)
    {
        sums all;
        List<sums> byPiece(pieces_);
        List<sums> byTime(times_.size());

        forAll(byTime, time)
        {
            forAll(byPiece, piece)
            {
                const label at = 3*((time*pieces_ + piece)*nBins + bin);

                sums part;
                part.flux = numbers[at];
                part.gradient = numbers[at + 1];
                part.fraction = numbers[at + 2];

                all += part;
                byPiece[piece] += part;
                byTime[time] += part;
            }
        }

        const scalar squared =
            max(variance(byPiece, all), variance(byTime, all));
        if (squared < 0)
        {
            continue;
        }

        const auto filled = [](const UList<sums>& blocks)
        {
            scalar count = 0;
            for (const sums& block : blocks)
            {
                count += block.gradient > 0;
            }
            return count;
        };
        result.append
        ({
            all.fraction/all.gradient,
            all.flux/all.gradient,
            Foam::sqrt(squared),
            scalarList({filled(byPiece), filled(byTime)})
        });
    }
    return result;
}
