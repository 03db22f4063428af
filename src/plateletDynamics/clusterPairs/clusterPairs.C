/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "clusterPairs.H"

#include "cellOrder.H"

#include <algorithm>
#include <cmath>

namespace plateletDynamics
{

namespace
{

//- The boxes around the clusters in the order of a grid's cells, as arrays for
//  the vector loops
class clusterBoxes
{
    std::vector<std::int32_t> centre_[3];
    std::vector<float> half_[3];
    std::vector<std::int64_t> key_;

public:

    //- Boxes from one cell of each other can be nearer than the range only if
    //  the cells are within cellKeys::reach
    cellOrder order;

    //- Whether cells do not tell some points apart
    bool clamped = false;

    clusterBoxes(const kernelPoints& points, double range)
    :
        order({})
    {
        const int n = points.clusters();
        std::vector<bounds> box(n);
        bounds all;
        double longest = 0;

        for (int c = 0; c < n; ++c)
        {
            const auto own = points.cluster[c];
            for (int k = own.first; k < own.first + own.count; ++k)
            {
                box[c].include(points.position[k]);
            }
            all.include(box[c]);
            longest = std::max
            (
                longest, (box[c].upper - box[c].lower).maxCoeff()
            );
        }

        const cellKeys grid
        (
            all, vector::Constant((range + longest)/cellKeys::reach)
        );
        key_.reserve(n);
        for (int c = 0; c < n; ++c)
        {
            clamped =
                clamped
             || grid.isClamped(box[c].lower) || grid.isClamped(box[c].upper);
            key_.push_back(grid.key(0.5*(box[c].lower + box[c].upper)));
        }
        order = cellOrder(key_);

        for (int axis = 0; axis < 3; ++axis)
        {
            centre_[axis].reserve(n + mostLanes);
            half_[axis].reserve(n + mostLanes);
            for (const int c : order.index)
            {
                const double lower = box[c].lower[axis];
                const double upper = box[c].upper[axis];

                // Rounding leaves out none
                centre_[axis].push_back
                (
                    wholeUnits(0.5*(lower + upper), points.perUnit)
                );
                half_[axis].push_back
                (
                    float(0.5*(upper - lower)*points.perUnit*(1 + 1e-6)) + 2
                );
            }
            centre_[axis].resize(n + mostLanes, 0);
            half_[axis].resize(n + mostLanes, 0);
        }
        order.index.resize(n + mostLanes, 0);
    }

    boxSearch within(float rangeSquared) const
    {
        return
        {
            centre_[0].data(), centre_[1].data(), centre_[2].data(),
            half_[0].data(), half_[1].data(), half_[2].data(),
            order.index.data(), rangeSquared
        };
    }
};


//- Finds the range of boxes in a row of cells near a given cell, for cells in
//  rising order: the search goes on from where it ended before
class rowFinder
{
    std::int64_t offset_;
    std::size_t first_ = 0;

public:

    explicit rowFinder(std::int64_t offset)
    :
        offset_(offset)
    {}

    //- Begin and end of the boxes
    std::pair<int, int> find
    (
        const std::vector<cellOrder::cell>& cells,
        std::int64_t key
    )
    {
        const std::int64_t low = key + offset_ - cellKeys::reach;
        const std::int64_t high = key + offset_ + cellKeys::reach;

        while (cells[first_].key < low)
        {
            ++first_;
        }

        std::size_t last = first_;
        while (cells[last].key <= high)
        {
            ++last;
        }
        return {cells[first_].begin, cells[last].begin};
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


//- The pairs within a cluster of so many points, each once
std::uint16_t pairsWithin(int count)
{
    std::uint16_t mask = 0;
    for (int i = 0; i < count; ++i)
    {
        for (int j = i + 1; j < count; ++j)
        {
            mask |= laneBit(i, j);
        }
    }
    return mask;
}

} // End namespace


void clusterPairs::build(const kernelPoints& points, double range)
{
    const clusterBoxes boxes(points, range);
    const auto& cells = boxes.order.cells;

    // Rounding in single precision leaves out none
    const float rangeSquared =
        float(std::pow((1 + 1e-6)*range/points.unit, 2));
    const boxSearch search(boxes.within(rangeSquared));

    // In the order of the cells
    std::vector<int> found;
    std::vector<std::size_t> begin(points.ownedClusters);
    std::vector<int> count(points.ownedClusters);
    std::size_t end = 0;

    std::vector<rowFinder> rows(allRows());
    std::vector<std::pair<int, int>> candidates(rows.size());

    for (std::size_t i = 0; i + 1 < cells.size(); ++i)
    {
        std::size_t most = mostLanes;
        for (std::size_t r = 0; r < rows.size(); ++r)
        {
            candidates[r] = rows[r].find(cells, cells[i].key);
            most += candidates[r].second - candidates[r].first;
        }

        for (int box = cells[i].begin; box < cells[i + 1].begin; ++box)
        {
            const int c = boxes.order.index[box];
            if (c >= points.ownedClusters)
            {
                continue;
            }
            if (found.size() < end + most)
            {
                found.resize(std::max(end + most, found.size()/4*5));
            }

            begin[c] = end;
            for (const auto& [from, to] : candidates)
            {
                end += loops_.search(search, box, from, to, &found[end]);
            }
            count[c] = int
            (
                loops_.prune
                (
                    points.place.data(), c, rangeSquared, &found[begin[c]],
                    end - begin[c]
                )
            );
            end = begin[c] + count[c];
        }
    }

    // In the order of the clusters
    start_.assign(1, 0);
    startOfMasks_.assign(1, 0);
    partner_.clear();
    mask_.clear();
    partner_.reserve(end + points.ownedClusters + fetchedAhead);
    for (int c = 0; c < points.ownedClusters; ++c)
    {
        partner_.push_back(c);
        mask_.push_back(pairsWithin(points.cluster[c].count));

        const auto first = found.begin() + std::ptrdiff_t(begin[c]);
        partner_.insert(partner_.end(), first, first + count[c]);

        start_.push_back(partner_.size());
        startOfMasks_.push_back(mask_.size());
    }

    if (boxes.clamped)
    {
        // Places are the same every 2^32 units: those that are that far from
        // each other were listed too
        remove
        (
            points,
            [](int) { return true; },
            [&](int k, int j)
            {
                return
                    (points.position[k] - points.position[j]).norm()
                  > 1.001*range;
            }
        );
    }
    else
    {
        finish(points.ownedClusters);
    }
}


void clusterPairs::finish(int ownedClusters)
{
    partner_.resize(partner_.size() + fetchedAhead, 0);

    interior_.clear();
    boundary_.clear();

    for (int row = 0; row < rows(); ++row)
    {
        bool hasGhosts = false;
        forPartners
        (
            row,
            [&](int partner, std::uint16_t)
            {
                hasGhosts = hasGhosts || partner >= ownedClusters;
            }
        );

        (hasGhosts ? boundary_ : interior_).push_back(row);
    }
}

} // End namespace plateletDynamics
