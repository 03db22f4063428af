/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "vectorLoops.H"

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

HWY_BEFORE_NAMESPACE();

namespace plateletDynamics
{
namespace HWY_NAMESPACE
{

#if HWY_TARGET == HWY_SCALAR

// A processor without vectors: the engine takes its plain kernel

std::size_t search
(
    const rangeSearch& row,
    int begin,
    int end,
    const latticePlace& place,
    int self,
    float rangeSquared,
    int* found
)
{
    const auto difference = [](std::int32_t a, std::int32_t b)
    {
        return float(std::int32_t(std::uint32_t(a) - std::uint32_t(b)));
    };
    const int* const first = found;

    for (int i = begin; i < end; ++i)
    {
        const float dx = difference(place.x, row.x[i]);
        const float dy = difference(place.y, row.y[i]);
        const float dz = difference(place.z, row.z[i]);

        // Without a branch, which would be mispredicted
        *found = row.entry[i];
        found +=
            (dx*dx + dy*dy + dz*dz < rangeSquared) & (row.entry[i] != self);
    }
    return found - first;
}


vectorLoops loops()
{
    return {"plain", 0, {}, search};
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using floats = hn::CappedTag<float, mostLanes>;
using ints = hn::RebindToSigned<floats>;
using fourInts = hn::CappedTag<std::int32_t, 4>;
using floatVector = hn::Vec<floats>;
using intVector = hn::Vec<ints>;

constexpr int lanes = int(hn::MaxLanes(floats()));

//- Intervals of the table: one register, or two where one holds only four
constexpr int tableIntervals = lanes == 16 ? 16 : 8;


struct places
{
    intVector x;
    intVector y;
    intVector z;
};


//- The place that an entry of a list names
HWY_INLINE hn::Vec<fourInts> load(const latticePlace* place, int entry)
{
    const auto pieces = reinterpret_cast<const std::int64_t*>(place);

    return hn::Load
    (
        fourInts(),
        reinterpret_cast<const std::int32_t*>(pieces + std::uint32_t(entry))
    );
}


//- The places number 0, 4, 8, 12 (as many as there are lanes for), side by side
HWY_INLINE intVector everyFourth(const latticePlace* place, const int* entry)
{
#if HWY_CAP_GE512
    const hn::Half<ints> eight;
    return hn::Combine
    (
        ints(),
        hn::Combine(eight, load(place, entry[12]), load(place, entry[8])),
        hn::Combine(eight, load(place, entry[4]), load(place, entry[0]))
    );
#elif HWY_CAP_GE256
    return hn::Combine(ints(), load(place, entry[4]), load(place, entry[0]));
#else
    return load(place, entry[0]);
#endif
}


//- The places of as many neighbours as there are lanes
HWY_INLINE places gather(const latticePlace* place, const int* entry)
{
    const ints di;
    const hn::RepartitionToWide<ints> wide;

    const auto a = everyFourth(place, entry);
    const auto b = everyFourth(place, entry + 1);
    const auto c = everyFourth(place, entry + 2);
    const auto d = everyFourth(place, entry + 3);

    // Rows of four become columns
    const auto xyab = hn::BitCast(wide, hn::InterleaveLower(di, a, b));
    const auto xycd = hn::BitCast(wide, hn::InterleaveLower(di, c, d));
    const auto zab = hn::BitCast(wide, hn::InterleaveUpper(di, a, b));
    const auto zcd = hn::BitCast(wide, hn::InterleaveUpper(di, c, d));

    return
    {
        hn::BitCast(di, hn::InterleaveLower(wide, xyab, xycd)),
        hn::BitCast(di, hn::InterleaveUpper(wide, xyab, xycd)),
        hn::BitCast(di, hn::InterleaveLower(wide, zab, zcd))
    };
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
        const auto entry = hn::IndicesFromVec
        (
            d, hn::And(interval, hn::Set(di, lanes - 1))
        );

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


template<int degree>
void addForces(pairSums& task)
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
    const auto nearSquared = hn::Set(d, task.nearSquared);
    const auto mantissa = hn::Set(di, (1 << mantissaBits) - 1);
    const auto one = hn::BitCast(di, hn::Set(d, 1.0f));
    const auto middle = hn::Set(d, 1.5f);

    const latticePlace* const place = task.place;
    int* const nearRow = task.nearRow;
    int* const nearEntry = task.nearEntry;
    std::size_t nNear = task.nNear;
    int k = task.begin;

    for (; k < task.end; ++k)
    {
        const int* j = task.neighbour + task.start[k];
        const int* const end = task.neighbour + task.start[k + 1];

        if (nNear + std::size_t(end - j) > task.mostNear)
        {
            break;
        }

        const auto x = hn::Set(di, place[k].x);
        const auto y = hn::Set(di, place[k].y);
        const auto z = hn::Set(di, place[k].z);

        auto sumX = hn::Zero(d);
        auto sumY = hn::Zero(d);
        auto sumZ = hn::Zero(d);

        for (; j < end; j += lanes)
        {
            const places other(gather(place, j));

            const auto dx = hn::ConvertTo(d, hn::Sub(x, other.x));
            const auto dy = hn::ConvertTo(d, hn::Sub(y, other.y));
            const auto dz = hn::ConvertTo(d, hn::Sub(z, other.z));
            const auto r2 = hn::MulAdd
            (
                dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz))
            );

            auto counts = hn::And
            (
                hn::Lt(r2, cutOffSquared), hn::FirstN(d, std::size_t(end - j))
            );
            const auto near = hn::And(counts, hn::Lt(r2, nearSquared));

            if (HWY_UNLIKELY(!hn::AllFalse(d, near)))
            {
                const auto these = hn::RebindMask(di, near);
                hn::CompressStore
                (
                    hn::Set(di, k), these, di, nearRow + nNear
                );
                nNear += hn::CompressStore
                (
                    hn::LoadU(di, j), these, di, nearEntry + nNear
                );
                counts = hn::AndNot(near, counts);
            }

            const auto bits = hn::BitCast(di, hn::Mul(r2, scale));
            const auto interval =
                hn::ShiftRight<mantissaBits - partBits>(bits);
            const auto t = hn::Sub
            (
                hn::BitCast
                (
                    d,
                    hn::Or(hn::And(hn::ShiftLeft<partBits>(bits), mantissa), one)
                ),
                middle
            );

            auto f = power[degree](interval);
            for (int p = degree - 1; p >= 0; --p)
            {
                f = hn::MulAdd(f, t, power[p](interval));
            }
            f = hn::IfThenElseZero(counts, f);

            sumX = hn::MulAdd(f, dx, sumX);
            sumY = hn::MulAdd(f, dy, sumY);
            sumZ = hn::MulAdd(f, dz, sumZ);
        }

        double* const force = task.force + 3*std::size_t(k);
        force[0] += task.unit*double(hn::GetLane(hn::SumOfLanes(d, sumX)));
        force[1] += task.unit*double(hn::GetLane(hn::SumOfLanes(d, sumY)));
        force[2] += task.unit*double(hn::GetLane(hn::SumOfLanes(d, sumZ)));
    }

    task.begin = k;
    task.nNear = nNear;
}


std::size_t search
(
    const rangeSearch& row,
    int begin,
    int end,
    const latticePlace& place,
    int self,
    float rangeSquared,
    int* found
)
{
    const floats d;
    const ints di;
    const auto x = hn::Set(di, place.x);
    const auto y = hn::Set(di, place.y);
    const auto z = hn::Set(di, place.z);
    const auto itself = hn::Set(di, self);
    const auto range = hn::Set(d, rangeSquared);
    const int* const first = found;

    for (int i = begin; i < end; i += lanes)
    {
        const auto dx = hn::ConvertTo(d, hn::Sub(x, hn::LoadU(di, row.x + i)));
        const auto dy = hn::ConvertTo(d, hn::Sub(y, hn::LoadU(di, row.y + i)));
        const auto dz = hn::ConvertTo(d, hn::Sub(z, hn::LoadU(di, row.z + i)));
        const auto r2 = hn::MulAdd
        (
            dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz))
        );
        const auto entry = hn::LoadU(di, row.entry + i);

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
            hn::Ne(entry, itself)
        );
        found += hn::CompressStore(entry, near, di, found);
    }
    return found - first;
}


vectorLoops loops()
{
    return
    {
        hwy::TargetName(HWY_TARGET),
        tableIntervals,
        {
            addForces<4>, addForces<5>, addForces<6>, addForces<7>,
            addForces<8>
        },
        search
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
            {"AVX3", HWY_AVX3}, {"AVX2", HWY_AVX2}, {"SSE4", HWY_SSE4},
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
                " of this processor. Valid: best, AVX3, AVX2, SSE4, SSSE3,"
                " plain"
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
