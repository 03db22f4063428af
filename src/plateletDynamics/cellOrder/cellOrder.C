/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "cellOrder.H"

#include <limits>
#include <numeric>

namespace plateletDynamics
{

namespace
{

//- Most cells per point that a table of all cells may have
constexpr double mostCellsPerPoint = 8;


//- The smallest cuboid of cells that holds all keys, its cells numbered in the
//  order of the keys
class cuboid
{
    std::array<std::int64_t, 3> lower_;
    std::array<std::int64_t, 3> size_{0, 0, 0};

public:

    explicit cuboid(const std::vector<std::int64_t>& keys)
    {
        lower_.fill(std::numeric_limits<std::int64_t>::max());
        std::array<std::int64_t, 3> upper{0, 0, 0};

        for (const std::int64_t key : keys)
        {
            const auto cell = cellKeys::coordinates(key);
            for (int axis = 0; axis < 3; ++axis)
            {
                lower_[axis] = std::min(lower_[axis], cell[axis]);
                upper[axis] = std::max(upper[axis], cell[axis]);
            }
        }
        for (int axis = 0; axis < 3 && keys.size(); ++axis)
        {
            size_[axis] = upper[axis] - lower_[axis] + 1;
        }
    }

    double cells() const
    {
        return double(size_[0])*double(size_[1])*double(size_[2]);
    }

    std::size_t number(std::int64_t key) const
    {
        const auto cell = cellKeys::coordinates(key);

        return
            ((cell[2] - lower_[2])*size_[1] + cell[1] - lower_[1])*size_[0]
          + cell[0] - lower_[0];
    }
};

} // End namespace


cellOrder::cellOrder(const std::vector<std::int64_t>& keys)
{
    const std::size_t n = keys.size();
    const cuboid all(keys);
    index.resize(n);

    if (all.cells() <= mostCellsPerPoint*double(n))
    {
        // By counting
        std::vector<int> begin(std::size_t(all.cells()) + 1, 0);
        for (const std::int64_t key : keys)
        {
            ++begin[all.number(key) + 1];
        }
        for (std::size_t i = 1; i < begin.size(); ++i)
        {
            begin[i] += begin[i - 1];
        }
        for (std::size_t i = 0; i < n; ++i)
        {
            index[begin[all.number(keys[i])]++] = int(i);
        }
    }
    else
    {
        std::iota(index.begin(), index.end(), 0);
        std::stable_sort
        (
            index.begin(), index.end(),
            [&](int a, int b) { return keys[a] < keys[b]; }
        );
    }

    for (std::size_t i = 0; i < n; ++i)
    {
        if (i == 0 || keys[index[i]] != keys[index[i - 1]])
        {
            cells.push_back({keys[index[i]], int(i)});
        }
    }
    cells.push_back({std::numeric_limits<std::int64_t>::max(), int(n)});
}

} // End namespace plateletDynamics
