/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "neighbourList.H"

#include "cellKeys.H"

#include <limits>
#include <numeric>

namespace plateletDynamics
{

namespace
{

//- All points in the order of their cells
class sortedPoints
{
public:

    struct cell
    {
        std::int64_t key;
        int begin;
    };

    std::vector<int> index;
    std::vector<vector> position;

    //- The cells that are not empty, in order, and one beyond all
    std::vector<cell> cells;

    sortedPoints(const kernelPoints& points, double edge)
    {
        bounds around;
        for (std::size_t k = 0; k < points.size(); ++k)
        {
            if (points.fixed[k] != platelets::absorbed)
            {
                around.include(points.position[k]);
            }
        }
        const cellKeys grid(around, edge);

        std::vector<std::pair<std::int64_t, int>> order(points.size());
        for (std::size_t k = 0; k < points.size(); ++k)
        {
            order[k] = {grid.key(points.position[k]), int(k)};
        }
        std::sort(order.begin(), order.end());

        for (const auto& [key, k] : order)
        {
            if (cells.empty() || cells.back().key != key)
            {
                cells.push_back({key, int(index.size())});
            }
            index.push_back(k);
            position.push_back(points.position[k]);
        }
        cells.push_back
        (
            {std::numeric_limits<std::int64_t>::max(), int(index.size())}
        );
    }
};


//- Finds the range of points in a row of cells near a given cell, for cells
//  in rising order: the search goes on from where it ended before
class rowFinder
{
    std::int64_t offset_;
    std::size_t first_ = 0;

public:

    explicit rowFinder(std::int64_t offset)
    :
        offset_(offset)
    {}

    //- Begin and end of the points in sortedPoints
    std::pair<int, int> find(const sortedPoints& sorted, std::int64_t key)
    {
        const std::int64_t low = key + offset_ - cellKeys::reach;
        const std::int64_t high = key + offset_ + cellKeys::reach;

        while (sorted.cells[first_].key < low)
        {
            ++first_;
        }

        std::size_t last = first_;
        while (sorted.cells[last].key <= high)
        {
            ++last;
        }
        return {sorted.cells[first_].begin, sorted.cells[last].begin};
    }
};


std::vector<rowFinder> allRows()
{
    std::vector<rowFinder> rows;
    for (int z = -cellKeys::reach; z <= cellKeys::reach; ++z)
    {
        for (int y = -cellKeys::reach; y <= cellKeys::reach; ++y)
        {
            rows.emplace_back(cellKeys::step(0, y, z));
        }
    }
    return rows;
}

} // End namespace


void neighbourList::build(const kernelPoints& points, double range)
{
    const sortedPoints sorted(points, range/cellKeys::reach);
    const double rangeSquared = range*range;

    std::vector<rowFinder> rows(allRows());
    std::vector<std::pair<int, int>> candidates(rows.size());

    // Lists in the order of the cells, then of the platelets
    std::vector<std::size_t> begin(points.owned);
    std::vector<std::size_t> count(points.owned);
    std::vector<int> found;
    std::size_t end = 0;

    for (std::size_t c = 0; c + 1 < sorted.cells.size(); ++c)
    {
        std::size_t most = 0;
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
            candidates[i] = rows[i].find(sorted, sorted.cells[c].key);
            most += candidates[i].second - candidates[i].first;
        }

        for (int s = sorted.cells[c].begin; s < sorted.cells[c + 1].begin; ++s)
        {
            const std::size_t k = sorted.index[s];
            if (k >= points.owned)
            {
                continue;
            }

            const vector x(sorted.position[s]);
            begin[k] = end;
            if (found.size() < end + most)
            {
                found.resize(2*(end + most));
            }

            for (const auto& [from, to] : candidates)
            {
                for (int t = from; t < to; ++t)
                {
                    const double distanceSquared =
                        (sorted.position[t] - x).squaredNorm();

                    // Without a branch, which would be mispredicted
                    found[end] = sorted.index[t];
                    end += (distanceSquared < rangeSquared) & (t != s);
                }
            }
            count[k] = end - begin[k];
        }
    }

    start_.assign(points.owned + 1, 0);
    std::partial_sum(count.begin(), count.end(), start_.begin() + 1);

    neighbour_.assign(start_.back() + mostLanes, 0);
    for (std::size_t k = 0; k < points.owned; ++k)
    {
        std::copy_n
        (
            found.begin() + begin[k], count[k], neighbour_.begin() + start_[k]
        );
    }
}

} // End namespace plateletDynamics
