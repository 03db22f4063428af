/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "neighbourList.H"

#include "cellOrder.H"

#include <cmath>

namespace plateletDynamics
{

namespace
{

//- The points in the order of their cells, as arrays for the vector loops
class sortedPoints
:
    public cellOrder
{
    std::vector<std::int32_t> x_;
    std::vector<std::int32_t> y_;
    std::vector<std::int32_t> z_;
    std::vector<int> entry_;

public:

    sortedPoints(const kernelPoints& points, const cellKeys& grid)
    :
        cellOrder(grid, points.position, points.fixed)
    {
        for (auto* values : {&x_, &y_, &z_, &entry_})
        {
            values->reserve(index.size() + mostLanes);
        }
        for (const int k : index)
        {
            x_.push_back(points.place[k].x);
            y_.push_back(points.place[k].y);
            z_.push_back(points.place[k].z);
            entry_.push_back(k*latticePlace::entry);
        }
        for (auto* values : {&x_, &y_, &z_, &entry_})
        {
            values->resize(values->size() + mostLanes, 0);
        }
    }

    rangeSearch arrays() const
    {
        return {x_.data(), y_.data(), z_.data(), entry_.data()};
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


void neighbourList::build
(
    const kernelPoints& points,
    const cellKeys& grid,
    double range
)
{
    const sortedPoints sorted(points, grid);
    const rangeSearch arrays(sorted.arrays());

    // Rounding in single precision leaves out none
    const float rangeSquared =
        float(std::pow((1 + 1e-6)*range/points.unit, 2));

    std::vector<rowFinder> rows(allRows());
    std::vector<std::pair<int, int>> candidates(rows.size());

    // Lists in the order of the cells, then of the platelets
    std::vector<int> count(points.owned, 0);
    start_.assign(points.owned + 1, 0);
    std::size_t end = 0;
    bool inOrder = true;
    int last = -1;

    for (std::size_t c = 0; c + 1 < sorted.cells.size(); ++c)
    {
        std::size_t most = mostLanes;
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
            candidates[i] = rows[i].find(sorted, sorted.cells[c].key);
            most += candidates[i].second - candidates[i].first;
        }

        for (int s = sorted.cells[c].begin; s < sorted.cells[c + 1].begin; ++s)
        {
            const int k = sorted.index[s];
            if (k >= int(points.owned))
            {
                continue;
            }
            neighbour_.reserve(end + most);

            start_[k] = end;
            for (const auto& [from, to] : candidates)
            {
                end += loops_.search
                (
                    arrays,
                    from,
                    to,
                    points.place[k],
                    k*latticePlace::entry,
                    rangeSquared,
                    neighbour_.data() + end
                );
            }
            count[k] = int(end - start_[k]);
            inOrder = inOrder && k > last;
            last = k;
        }
    }

    if (inOrder)
    {
        // Rows of absorbed platelets, which have none, end where they begin
        start_.back() = end;
        for (std::size_t k = points.owned; k-- > 0;)
        {
            start_[k] = start_[k + 1] - count[k];
        }
    }
    else
    {
        const std::vector<std::size_t> begin(std::move(start_));
        start_.assign(points.owned + 1, 0);
        indexBuffer inOrderOfRows;
        inOrderOfRows.reserve(end + mostLanes);
        for (std::size_t k = 0; k < points.owned; ++k)
        {
            start_[k + 1] = start_[k] + count[k];
            std::copy_n
            (
                neighbour_.data() + begin[k], count[k],
                inOrderOfRows.data() + start_[k]
            );
        }
        neighbour_ = std::move(inOrderOfRows);
    }

    // Readable beyond the end, by loops that then count none of it
    neighbour_.reserve(end + mostLanes);
    std::fill_n(neighbour_.data() + end, mostLanes, 0);

    // Places are the same every 2^32 units: where cells don't tell points
    // apart, those that are that far from each other were listed too
    bool clamped = false;
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        clamped =
            clamped
         || (
                points.fixed[k] != platelets::absorbed
             && grid.isClamped(points.position[k])
            );
    }
    if (clamped)
    {
        remove
        (
            [&](int k, int j)
            {
                return
                    (points.position[k] - points.position[j]).norm()
                  > 1.001*range;
            }
        );
    }

    divide(points.owned);
}


void neighbourList::divide(std::size_t owned)
{
    interior_.clear();
    boundary_.clear();

    for (std::size_t k = 0; k < owned; ++k)
    {
        const auto listed = (*this)[k];
        bool hasGhosts = false;
        for (const int j : listed)
        {
            hasGhosts = hasGhosts || j >= int(owned);
        }

        std::vector<rowRange>& rows = hasGhosts ? boundary_ : interior_;
        if (rows.empty() || rows.back().end != int(k))
        {
            rows.push_back({int(k), int(k)});
        }
        ++rows.back().end;
    }
}

} // End namespace plateletDynamics
