/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "halo.H"

#include "bounds.H"
#include "stopwatch.H"

#include <algorithm>

namespace plateletDynamics
{

namespace
{

//- The bounds of the own points of each rank
std::vector<bounds> allBounds
(
    const rankGroup& ranks,
    const kernelPoints& points
)
{
    const bounds own(boundsOf(points.position, points.fixed, 0, points.owned));

    std::vector<double> numbers(own.lower.data(), own.lower.data() + 3);
    numbers.insert(numbers.end(), own.upper.data(), own.upper.data() + 3);
    numbers = ranks.gather(numbers);

    std::vector<bounds> all(ranks.size());
    for (int rank = 0; rank < ranks.size(); ++rank)
    {
        all[rank].lower = Eigen::Map<const vector>(&numbers[6*rank]);
        all[rank].upper = Eigen::Map<const vector>(&numbers[6*rank + 3]);
    }
    return all;
}


//- Platelets that are tested together: those that follow each other are near
constexpr std::size_t block = 16;


//- The bounds of every so many own points
std::vector<bounds> boundsOfBlocks(const kernelPoints& points)
{
    std::vector<bounds> blocks;
    for (std::size_t begin = 0; begin < points.owned; begin += block)
    {
        blocks.push_back
        (
            boundsOf
            (
                points.position, points.fixed, begin,
                std::min(begin + block, points.owned)
            )
        );
    }
    return blocks;
}


//- The bounds, displaced
bounds moved(const bounds& original, const vector& shift)
{
    bounds image(original);
    image.lower += shift;
    image.upper += shift;
    return image;
}

} // End namespace


halo::halo(const rankGroup& ranks, const periodicBox& space)
:
    ranks_(ranks),
    shifts_(space.shifts())
{}


void halo::chooseGhosts(const kernelPoints& points, double range)
{
    const std::vector<bounds> all(allBounds(ranks_, points));
    const bounds& own = all[ranks_.rank()];
    const std::vector<bounds> blocks(boundsOfBlocks(points));

    partners_.clear();
    for (int rank = 0; rank < ranks_.size(); ++rank)
    {
        partner other;
        other.rank = rank;

        for (std::size_t s = 0; s < shifts_.size(); ++s)
        {
            const vector& shift = shifts_[s];
            const bool itself = rank == ranks_.rank() && shift.isZero(0);

            if (itself || own.empty() || all[rank].empty())
            {
                continue;
            }

            if (!moved(own, shift).overlaps(all[rank], range))
            {
                continue;
            }

            for (std::size_t b = 0; b < blocks.size(); ++b)
            {
                if
                (
                    blocks[b].empty()
                 || !moved(blocks[b], shift).overlaps(all[rank], range)
                )
                {
                    continue;
                }

                const std::size_t end = std::min(block*(b + 1), points.owned);
                for (std::size_t k = block*b; k < end; ++k)
                {
                    const vector x(points.position[k] + shift);

                    if
                    (
                        points.fixed[k] != platelets::absorbed
                     && all[rank].distanceSquared(x) < range*range
                    )
                    {
                        other.index.push_back(int(k));
                        other.shift.push_back(std::uint8_t(s));
                    }
                }
            }
        }

        partners_.push_back(std::move(other));
    }
}


void halo::exchangeCounts()
{
    std::vector<int> sent;
    for (const partner& other : partners_)
    {
        sent.push_back(int(other.index.size()));
    }

    std::vector<int> received(sent);
    if (ranks_.size() > 1)
    {
        MPI_Alltoall
        (
            sent.data(), 1, MPI_INT,
            received.data(), 1, MPI_INT,
            ranks_.communicator()
        );
    }

    for (std::size_t rank = 0; rank < partners_.size(); ++rank)
    {
        partners_[rank].nGhosts = received[rank];
    }
}


void halo::wait(std::vector<MPI_Request>& requests)
{
    if (requests.size())
    {
        const stopwatch watch(seconds_);
        MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    }
}


void halo::exchangeNames(kernelPoints& points)
{
    // The id, and whether fixed in its sign bit: ~id for a fixed platelet
    const auto name = [&](int k)
    {
        return points.fixed[k] ? ~points.id[k] : points.id[k];
    };

    std::vector<std::vector<std::int64_t>> sent(partners_.size());
    std::vector<std::int64_t> received(points.size() - points.owned);
    std::vector<MPI_Request> requests;

    for (std::size_t i = 0; i < partners_.size(); ++i)
    {
        const partner& other = partners_[i];

        for (const int k : other.index)
        {
            sent[i].push_back(name(k));
        }

        std::int64_t* const place =
            received.data() + (other.firstGhost - points.owned);

        if (other.rank == ranks_.rank())
        {
            std::copy(sent[i].begin(), sent[i].end(), place);
            continue;
        }
        if (other.nGhosts)
        {
            MPI_Irecv
            (
                place, int(other.nGhosts), MPI_INT64_T, other.rank, 0,
                ranks_.communicator(), &requests.emplace_back()
            );
        }
        if (sent[i].size())
        {
            MPI_Isend
            (
                sent[i].data(), int(sent[i].size()), MPI_INT64_T, other.rank, 0,
                ranks_.communicator(), &requests.emplace_back()
            );
        }
    }

    wait(requests);

    for (std::size_t ghost = 0; ghost < received.size(); ++ghost)
    {
        const bool fixed = received[ghost] < 0;
        points.fixed[points.owned + ghost] = fixed;
        points.id[points.owned + ghost] =
            fixed ? ~received[ghost] : received[ghost];
    }
}


void halo::rebuild(kernelPoints& points, double range)
{
    chooseGhosts(points, range);

    exchangeCounts();

    std::size_t total = points.owned;
    for (partner& other : partners_)
    {
        other.firstGhost = total;
        total += other.nGhosts;
    }
    points.resize(total);

    exchangeNames(points);
    start(points);
    finish();
}


void halo::start(kernelPoints& points)
{
    static_assert
    (
        sizeof(vector) == 3*sizeof(double),
        "positions are sent as rows of doubles"
    );

    for (partner& other : partners_)
    {
        vector* const ghosts = points.position.data() + other.firstGhost;
        const bool itself = other.rank == ranks_.rank();

        if (!itself && other.nGhosts)
        {
            MPI_Irecv
            (
                ghosts, int(3*other.nGhosts), MPI_DOUBLE, other.rank, 1,
                ranks_.communicator(), &underWay_.emplace_back()
            );
        }

        other.buffer.resize(itself ? 0 : other.index.size());
        vector* const target = itself ? ghosts : other.buffer.data();

        for (std::size_t i = 0; i < other.index.size(); ++i)
        {
            target[i] =
                points.position[other.index[i]] + shifts_[other.shift[i]];
        }

        if (!itself && other.index.size())
        {
            MPI_Isend
            (
                other.buffer.data(), int(3*other.index.size()), MPI_DOUBLE,
                other.rank, 1, ranks_.communicator(), &underWay_.emplace_back()
            );
        }
    }
}


void halo::finish()
{
    wait(underWay_);
    underWay_.clear();
}

} // End namespace plateletDynamics
