/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "vectorLoops.H"

#include <algorithm>
#include <cmath>
#include <utility>

// Lanes whose number is only known when the program runs
#define HWY_DISABLED_TARGETS \
    (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

// The fallback is single lanes with every compiler, and there is one
#define HWY_BROKEN_EMU128 1
#define HWY_COMPILE_ALL_ATTAINABLE

// The file is compiled once for each set of instructions
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "vectorLoops.C"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();

namespace plateletDynamics
{
namespace HWY_NAMESPACE
{

#if HWY_TARGET == HWY_SCALAR

// A processor without vectors: the engine takes its plain kernel

//- The difference of two places along one axis
inline float difference(std::int32_t a, std::int32_t b)
{
    return float(std::int32_t(std::uint32_t(a) - std::uint32_t(b)));
}


std::size_t search
(
    const boxSearch& boxes,
    int self,
    int begin,
    int end,
    int* found
)
{
    const auto gap = [](float apart, float edges)
    {
        return std::max(std::abs(apart) - edges, 0.0f);
    };
    const int* const first = found;

    for (int i = begin; i < end; ++i)
    {
        const float dx = gap
        (
            difference(boxes.x[self], boxes.x[i]),
            boxes.halfX[self] + boxes.halfX[i]
        );
        const float dy = gap
        (
            difference(boxes.y[self], boxes.y[i]),
            boxes.halfY[self] + boxes.halfY[i]
        );
        const float dz = gap
        (
            difference(boxes.z[self], boxes.z[i]),
            boxes.halfZ[self] + boxes.halfZ[i]
        );

        // Without a branch, which would be mispredicted
        *found = boxes.entry[i];
        found +=
            (dx*dx + dy*dy + dz*dz < boxes.rangeSquared)
          & (boxes.entry[i] > boxes.entry[self]);
    }
    return found - first;
}


std::size_t prune
(
    const clusterPlaces* place,
    int cluster,
    float rangeSquared,
    int* partner,
    std::size_t count
)
{
    const clusterPlaces& own = place[cluster];
    std::size_t kept = 0;

    for (std::size_t n = 0; n < count; ++n)
    {
        const clusterPlaces& other = place[partner[n]];
        float least = rangeSquared;

        for (int i = 0; i < clusterSize; ++i)
        {
            for (int j = 0; j < clusterSize; ++j)
            {
                const float dx = difference(own.x[i], other.x[j]);
                const float dy = difference(own.y[i], other.y[j]);
                const float dz = difference(own.z[i], other.z[j]);
                least = std::min(least, dx*dx + dy*dy + dz*dz);
            }
        }
        partner[kept] = partner[n];
        kept += least < rangeSquared;
    }
    return kept;
}


void inRange
(
    const clusterPlaces* place,
    int cluster,
    float rangeSquared,
    const int* partner,
    std::size_t count,
    std::uint16_t* mask
)
{
    const clusterPlaces& own = place[cluster];

    for (std::size_t n = 0; n < count; ++n)
    {
        const clusterPlaces& other = place[partner[n]];
        mask[n] = 0;

        for (int i = 0; i < clusterSize; ++i)
        {
            for (int j = 0; j < clusterSize; ++j)
            {
                const float dx = difference(own.x[i], other.x[j]);
                const float dy = difference(own.y[i], other.y[j]);
                const float dz = difference(own.z[i], other.z[j]);
                mask[n] |=
                    dx*dx + dy*dy + dz*dz < rangeSquared ? laneBit(i, j) : 0;
            }
        }
    }
}


vectorLoops loops()
{
    return {"plain", 0, {}, search, prune, inRange};
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using floats = hn::CappedTag<float, mostLanes>;
using ints = hn::RebindToSigned<floats>;
using floatVector = hn::Vec<floats>;
using intVector = hn::Vec<ints>;

constexpr int lanes = int(hn::MaxLanes(floats()));

//- Points of a cluster whose pairs with four others fill a vector, and vectors
//  for all pairs of two clusters
constexpr int pointsPerVector = lanes/clusterSize;
constexpr int parts = clusterSize/pointsPerVector;

//- Intervals of the table: one register, or two where one holds only four
constexpr int tableIntervals = lanes == 16 ? 16 : 8;

//- Pairs of clusters between two passes: their numbers fit into the nearest
//  cache
constexpr int chunk = 32;

//- Whether vectors without a pair in range are passed over: as many as half of
//  the narrowest, too few of the others to be worth the choice
constexpr bool choosy = lanes == clusterSize;

//- A squared distance beyond all [units^2]
constexpr float farAway = 1e30f;


//- The points of a cluster, each as often as a cluster has points
struct ownPlaces
{
    intVector x[parts];
    intVector y[parts];
    intVector z[parts];

    HWY_INLINE explicit ownPlaces(const clusterPlaces& own)
    {
        for (int p = 0; p < parts; ++p)
        {
            x[p] = repeated(own.x + p*pointsPerVector);
            y[p] = repeated(own.y + p*pointsPerVector);
            z[p] = repeated(own.z + p*pointsPerVector);
        }
    }

private:

    static HWY_INLINE intVector repeated(const std::int32_t* value)
    {
        HWY_ALIGN std::int32_t each[lanes];
        for (int i = 0; i < lanes; ++i)
        {
            each[i] = value[i/clusterSize];
        }
        return hn::Load(ints(), each);
    }
};


//- The displacements of a part of the pairs of two clusters, in units
struct displacements
{
    floatVector x;
    floatVector y;
    floatVector z;

    HWY_INLINE displacements
    (
        const ownPlaces& own,
        int part,
        const clusterPlaces& other
    )
    :
        x(along(own.x[part], other.x)),
        y(along(own.y[part], other.y)),
        z(along(own.z[part], other.z))
    {}

    //- Their squares, and one unit^2: 0 stands for none in range
    HWY_INLINE floatVector squared() const
    {
        const auto one = hn::Set(floats(), 1.0f);

        return hn::MulAdd(x, x, hn::MulAdd(y, y, hn::MulAdd(z, z, one)));
    }

private:

    static HWY_INLINE floatVector along
    (
        intVector own,
        const std::int32_t* other
    )
    {
        return hn::ConvertTo
        (
            floats(), hn::Sub(own, hn::LoadDup128(ints(), other))
        );
    }
};


//- Lanes of a part that a mask names
HWY_INLINE hn::Mask<floats> lanesOf(std::uint16_t mask, int part)
{
    const unsigned bits = unsigned(mask) >> (part*lanes);
    const std::uint8_t bytes[8] =
    {
        std::uint8_t(bits & ((1u << std::min(lanes, 8)) - 1)),
        std::uint8_t(bits >> 8)
    };
    return hn::LoadMaskBits(floats(), bytes);
}


//- The coefficients of one power for all intervals
struct powerTable
{
    floatVector low;
    floatVector high;

    HWY_INLINE void load(const float* values)
    {
        low = hn::LoadU(floats(), values);
        high = low;
        if (tableIntervals > lanes)
        {
            high = hn::LoadU(floats(), values + lanes);
        }
    }

    //- The entries that the intervals name, modulo their number
    HWY_INLINE floatVector operator()(intVector interval) const
    {
        const floats d;
        const ints di;
#if HWY_CAP_GE256
        // These instructions look at the lowest bits of an index only
        const auto entry = hn::IndicesFromVec(d, interval);
#else
        const auto entry = hn::IndicesFromVec
        (
            d, hn::And(interval, hn::Set(di, lanes - 1))
        );
#endif
        if (tableIntervals == lanes)
        {
            return hn::TableLookupLanes(low, entry);
        }
        const auto isLow = hn::Eq
        (
            hn::And(interval, hn::Set(di, lanes)), hn::Zero(di)
        );
        return hn::IfThenElse
        (
            hn::RebindMask(d, isLow),
            hn::TableLookupLanes(low, entry),
            hn::TableLookupLanes(high, entry)
        );
    }
};


//- Some pairs of clusters between the passes: vectors one after the other
struct chunkOfPairs
{
    HWY_ALIGN float x[chunk*mostLanes];
    HWY_ALIGN float y[chunk*mostLanes];
    HWY_ALIGN float z[chunk*mostLanes];

    //- Squared distance, 0 in vectors passed over; then force over distance
    HWY_ALIGN float value[chunk*mostLanes];

    //- Where the vectors to calculate begin
    int vectors[chunk*parts + 1];

    //- Of a row those pairs that are in this chunk
    struct segment
    {
        int cluster;
        const int* partner;
        int count;
    };
    segment segments[chunk];

    int nSegments;
    int nPairs;
    int nVectors;
    floatVector least;

    HWY_INLINE void clear()
    {
        nSegments = 0;
        nPairs = 0;
        nVectors = 0;
        least = hn::Set(floats(), farAway);
    }
};


//- First pass: distances to one partner; those of other lanes than named by
//  the mask are far. `least` is the least of these and of those before
template<bool masked>
HWY_INLINE void addDistances
(
    chunkOfPairs& pairs,
    int number,
    const ownPlaces& own,
    const clusterPlaces& partner,
    std::uint16_t mask,
    floatVector cutOffSquared,
    floatVector& least,
    int& nVectors
)
{
    const floats d;

    for (int p = 0; p < parts; ++p)
    {
        const int at = number*mostLanes + p*lanes;
        const displacements apart(own, p, partner);
        auto r2 = apart.squared();
        if (masked)
        {
            r2 = hn::IfThenElse(lanesOf(mask, p), r2, hn::Set(d, farAway));
        }
        least = hn::Min(least, r2);

        hn::Store(apart.x, d, pairs.x + at);
        hn::Store(apart.y, d, pairs.y + at);
        hn::Store(apart.z, d, pairs.z + at);
        if (choosy)
        {
            const auto inRange = hn::Lt(r2, cutOffSquared);
            r2 = hn::IfThenElseZero(inRange, r2);
            pairs.vectors[nVectors] = at;
            nVectors += !hn::AllFalse(d, inRange);
        }
        hn::Store(r2, d, pairs.value + at);
    }
    if (!choosy)
    {
        nVectors += parts;
    }
}


//- Call the caller for pairs that are near, and put them out of range
void sortOutNear(const pairSums& task, chunkOfPairs& pairs)
{
    float* value = pairs.value;

    for (int s = 0; s < pairs.nSegments; ++s)
    {
        const auto& segment = pairs.segments[s];
        for (int n = 0; n < segment.count*mostLanes; ++n, ++value)
        {
            if (*value > 0 && *value < task.nearSquared)
            {
                task.near
                (
                    task.caller,
                    segment.cluster,
                    segment.partner[n/mostLanes],
                    n%mostLanes/clusterSize,
                    n%clusterSize
                );
                *value = choosy ? 0 : farAway;
            }
        }
    }
}


//- Second pass: from squared distances to forces over distances
template<int degree>
HWY_INLINE void calculateForces
(
    const pairSums& task,
    chunkOfPairs& pairs
)
{
    const floats d;
    const ints di;
    constexpr int mantissaBits = 23;
    constexpr int partBits = tableIntervals == 16 ? 2 : 1;

    powerTable power[degree + 1];
    for (int k = 0; k <= degree; ++k)
    {
        power[k].load(task.coefficients + mostLanes*k);
    }

    const auto scale = hn::Set(d, task.scale);
    const auto cutOffSquared = hn::Set(d, task.cutOffSquared);
    const auto mantissa = hn::Set(di, (1 << mantissaBits) - 1);
    const auto one = hn::BitCast(di, hn::Set(d, 1.0f));
    const auto middle = hn::Set(d, 1.5f);

    for (int n = 0; n < pairs.nVectors; ++n)
    {
        const int at = choosy ? pairs.vectors[n] : n*lanes;
        const auto r2 = hn::Load(d, pairs.value + at);
        const auto bits = hn::BitCast(di, hn::Mul(r2, scale));
        const auto interval = hn::ShiftRight<mantissaBits - partBits>(bits);
        const auto t = hn::Sub
        (
            hn::BitCast
            (
                d, hn::Or(hn::And(hn::ShiftLeft<partBits>(bits), mantissa), one)
            ),
            middle
        );

        const auto inRange =
            choosy ? hn::Gt(r2, hn::Zero(d)) : hn::Lt(r2, cutOffSquared);

        auto f = power[degree](interval);
        for (int k = degree - 1; k >= 0; --k)
        {
            f = hn::MulAdd(f, t, power[k](interval));
        }
        hn::Store
        (
            hn::IfThenElseZero(inRange, f),
            d,
            pairs.value + at
        );
    }
}


template<class Tag>
HWY_INLINE void subtract(Tag d, float* from, hn::Vec<Tag> value)
{
    hn::Store(hn::Sub(hn::Load(d, from), value), d, from);
}


//- Take what all points of the own cluster do to a partner from its force
HWY_INLINE void react
(
    clusterForces& force,
    floatVector x,
    floatVector y,
    floatVector z
)
{
    const floats d;
    float* const value = force.value;

    // Blocks of four lanes: one for each own point, the lanes for the partner's
#if HWY_CAP_GE512
    const auto xz = hn::Add
    (
        hn::ConcatLowerLower(d, z, x), hn::ConcatUpperUpper(d, z, x)
    );
    const auto yy = hn::Add(y, hn::ConcatLowerUpper(d, y, y));

    // To be added in pairs: x x z z and y y y y
    const auto xyz = hn::Add
    (
        hn::OddEvenBlocks(yy, xz),
        hn::SwapAdjacentBlocks(hn::OddEvenBlocks(xz, yy))
    );
    subtract(d, value, xyz);
#elif HWY_CAP_GE256
    const hn::Half<floats> half;
    const auto xy = hn::Add
    (
        hn::ConcatLowerLower(d, y, x), hn::ConcatUpperUpper(d, y, x)
    );
    const auto zz = hn::Add(hn::LowerHalf(half, z), hn::UpperHalf(half, z));
    subtract(d, value, xy);
    subtract(half, value + clusterForces::z, zz);
#else
    subtract(d, value + clusterForces::x, x);
    subtract(d, value + clusterForces::y, y);
    subtract(d, value + clusterForces::z, z);
#endif
}


//- The forces on the points of the own cluster
struct ownForces
{
    floatVector x[parts];
    floatVector y[parts];
    floatVector z[parts];

    HWY_INLINE ownForces()
    {
        for (int p = 0; p < parts; ++p)
        {
            x[p] = hn::Zero(floats());
            y[p] = x[p];
            z[p] = x[p];
        }
    }

    HWY_INLINE void addTo(clusterForces& force) const
    {
        addSums(x, force.value + clusterForces::x);
        addSums(y, force.value + clusterForces::y);
        addSums(z, force.value + clusterForces::z);
    }

private:

    //- Sums over the partners' points
    static HWY_INLINE void addSums(const floatVector* lane, float* force)
    {
        const floats d;
        HWY_ALIGN float sum[lanes];

        for (int p = 0; p < parts; ++p)
        {
            const auto pairs = hn::Add(lane[p], hn::Shuffle2301(lane[p]));
            hn::Store(hn::Add(pairs, hn::Shuffle1032(pairs)), d, sum);

            for (int i = 0; i < pointsPerVector; ++i)
            {
                force[p*pointsPerVector + i] += sum[i*clusterSize];
            }
        }
    }
};


//- Third pass: forces on both sides
HWY_INLINE void addToBoth
(
    const chunkOfPairs& pairs,
    int number,
    ownForces& own,
    clusterForces& partner
)
{
    const floats d;
    auto sumX = hn::Zero(d);
    auto sumY = hn::Zero(d);
    auto sumZ = hn::Zero(d);

    for (int p = 0; p < parts; ++p)
    {
        const int at = number*mostLanes + p*lanes;
        const auto f = hn::Load(d, pairs.value + at);
        const auto x = hn::Mul(f, hn::Load(d, pairs.x + at));
        const auto y = hn::Mul(f, hn::Load(d, pairs.y + at));
        const auto z = hn::Mul(f, hn::Load(d, pairs.z + at));

        own.x[p] = hn::Add(own.x[p], x);
        own.y[p] = hn::Add(own.y[p], y);
        own.z[p] = hn::Add(own.z[p], z);
        sumX = p ? hn::Add(sumX, x) : x;
        sumY = p ? hn::Add(sumY, y) : y;
        sumZ = p ? hn::Add(sumZ, z) : z;
    }
    react(partner, sumX, sumY, sumZ);
}


//- Second and third pass
template<int degree>
void finish(const pairSums& task, chunkOfPairs& pairs)
{
    const floats d;

    if
    (
        HWY_UNLIKELY
        (
            !hn::AllFalse
            (
                d, hn::Lt(pairs.least, hn::Set(d, task.nearSquared))
            )
        )
    )
    {
        sortOutNear(task, pairs);
    }

    calculateForces<degree>(task, pairs);

    int number = 0;
    for (int s = 0; s < pairs.nSegments; ++s)
    {
        const auto segment = pairs.segments[s];
        ownForces sum;

        for (int n = 0; n < segment.count; ++n, ++number)
        {
            addToBoth(pairs, number, sum, task.force[segment.partner[n]]);
        }
        sum.addTo(task.force[segment.cluster]);
    }
    pairs.clear();
}


// In three passes, which a processor overlaps better than one long chain of
// operations that wait for each other
template<int degree>
void addForces(const pairSums& task)
{
    const auto cutOffSquared = hn::Set(floats(), task.cutOffSquared);
    chunkOfPairs pairs;
    pairs.clear();

    for (std::size_t r = 0; r < task.rows; ++r)
    {
        const int c = task.row[r];
        const ownPlaces own(task.place[c]);

        const int* partner = task.partner + task.start[c];
        const int* const end = task.partner + task.start[c + 1];
        const std::uint16_t* mask = task.mask + task.startOfMasks[c];
        const std::uint16_t* const endOfMasks =
            task.mask + task.startOfMasks[c + 1];

        while (partner < end)
        {
            const int first = pairs.nPairs;
            const int count =
                int(std::min<std::ptrdiff_t>(end - partner, chunk - first));
            int nVectors = pairs.nVectors;
            auto least = pairs.least;

            int n = 0;
            for (; n < count && mask < endOfMasks; ++n, ++mask)
            {
                addDistances<true>
                (
                    pairs, first + n, own, task.place[partner[n]], *mask,
                    cutOffSquared, least, nVectors
                );
            }
            for (; n < count; ++n)
            {
                addDistances<false>
                (
                    pairs, first + n, own, task.place[partner[n]], allLanes,
                    cutOffSquared, least, nVectors
                );
                hwy::Prefetch(task.force + partner[n]);
                hwy::Prefetch(task.place + partner[n + fetchedAhead]);
            }

            pairs.segments[pairs.nSegments++] = {c, partner, count};
            pairs.nPairs += count;
            pairs.nVectors = nVectors;
            pairs.least = least;
            partner += count;

            if (pairs.nPairs == chunk)
            {
                finish<degree>(task, pairs);
            }
        }
    }
    finish<degree>(task, pairs);
}


//- The gap along one axis between a box and others
HWY_INLINE floatVector gap
(
    const std::int32_t* centre,
    const float* half,
    int self,
    int i
)
{
    const floats d;
    const ints di;

    const auto apart = hn::ConvertTo
    (
        d, hn::Sub(hn::Set(di, centre[self]), hn::LoadU(di, centre + i))
    );
    const auto edges = hn::Add(hn::Set(d, half[self]), hn::LoadU(d, half + i));

    return hn::Max(hn::Sub(hn::Abs(apart), edges), hn::Zero(d));
}


std::size_t search
(
    const boxSearch& boxes,
    int self,
    int begin,
    int end,
    int* found
)
{
    const floats d;
    const ints di;
    const auto itself = hn::Set(di, boxes.entry[self]);
    const auto range = hn::Set(d, boxes.rangeSquared);
    const int* const first = found;

    for (int i = begin; i < end; i += lanes)
    {
        const auto dx = gap(boxes.x, boxes.halfX, self, i);
        const auto dy = gap(boxes.y, boxes.halfY, self, i);
        const auto dz = gap(boxes.z, boxes.halfZ, self, i);
        const auto r2 = hn::MulAdd
        (
            dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz))
        );
        const auto entry = hn::LoadU(di, boxes.entry + i);

        const auto near = hn::And
        (
            hn::RebindMask
            (
                di,
                hn::And
                (
                    hn::Lt(r2, range), hn::FirstN(d, std::size_t(end - i))
                )
            ),
            hn::Gt(entry, itself)
        );
        // Mostly there is none
        if (!hn::AllFalse(di, near))
        {
            found += hn::CompressStore(entry, near, di, found);
        }
    }
    return found - first;
}


std::size_t prune
(
    const clusterPlaces* place,
    int cluster,
    float rangeSquared,
    int* partner,
    std::size_t count
)
{
    const floats d;
    const ownPlaces own(place[cluster]);
    const auto range = hn::Set(d, rangeSquared);
    std::size_t kept = 0;

    for (std::size_t n = 0; n < count; ++n)
    {
        auto least = range;
        for (int p = 0; p < parts; ++p)
        {
            const displacements apart(own, p, place[partner[n]]);
            least = hn::Min(least, apart.squared());
        }
        partner[kept] = partner[n];
        kept += !hn::AllFalse(d, hn::Lt(least, range));
    }
    return kept;
}


void inRange
(
    const clusterPlaces* place,
    int cluster,
    float rangeSquared,
    const int* partner,
    std::size_t count,
    std::uint16_t* mask
)
{
    const floats d;
    const ownPlaces own(place[cluster]);
    const auto range = hn::Set(d, rangeSquared);

    for (std::size_t n = 0; n < count; ++n)
    {
        unsigned bits = 0;
        for (int p = 0; p < parts; ++p)
        {
            const displacements apart(own, p, place[partner[n]]);
            std::uint8_t bytes[8] = {};
            hn::StoreMaskBits(d, hn::Lt(apart.squared(), range), bytes);
            bits |= (bytes[0] | unsigned(bytes[1]) << 8) << (p*lanes);
        }
        mask[n] = std::uint16_t(bits);
    }
}


vectorLoops loops()
{
    return
    {
        HWY_TARGET <= HWY_AVX3 ? "AVX-512" : hwy::TargetName(HWY_TARGET),
        tableIntervals,
        {
            addForces<4>, addForces<5>, addForces<6>, addForces<7>,
            addForces<8>
        },
        search,
        prune,
        inRange
    };
}

#endif

} // End namespace HWY_NAMESPACE
} // End namespace plateletDynamics

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "registerTable.H"
#include "userError.H"

namespace plateletDynamics
{

HWY_EXPORT(loops);

static_assert
(
    registerTable::lowestDegree == 4 && registerTable::highestDegree == 8,
    "addForces is made for these"
);


vectorLoops vectorLoops::choose(const std::string& instructions)
{
    const std::int64_t all = hwy::SupportedTargets();
    std::int64_t allowed = 0;

    // The wider, the lower the bit
    for
    (
        const auto& [name, widest]
      : {
            std::pair<const char*, std::int64_t>("best", 1),
            {"AVX-512", HWY_AVX3}, {"AVX2", HWY_AVX2}, {"SSE4", HWY_SSE4},
            {"SSSE3", HWY_SSSE3}, {"plain", HWY_SCALAR}
        }
    )
    {
        if (instructions == name)
        {
            allowed = all & ~(widest - 1);
        }
    }
    if (!allowed)
    {
        throw userError
        (
            text
            (
                "Instructions '", instructions, "' are not known, or not those"
                " of this processor. Valid: best, AVX-512, AVX2, SSE4,"
                " SSSE3, plain"
            )
        );
    }

    hwy::SetSupportedTargetsForTest(allowed);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    const vectorLoops chosen(HWY_DYNAMIC_DISPATCH(loops)());

    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());

    return chosen;
}

} // End namespace plateletDynamics

#endif
