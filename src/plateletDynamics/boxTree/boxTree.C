/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "boxTree.H"

#include <algorithm>
#include <numeric>

namespace plateletDynamics
{

boxTree::boxTree(std::vector<bounds> itemBounds)
:
    items_(itemBounds.size()),
    itemBounds_(std::move(itemBounds))
{
    std::iota(items_.begin(), items_.end(), 0);

    if (items_.size())
    {
        build(0, int(items_.size()));
    }
}


void boxTree::build(int begin, int end)
{
    bounds around(itemBounds_[items_[begin]]);
    for (int i = begin; i < end; ++i)
    {
        around.include(itemBounds_[items_[i]]);
    }

    const std::size_t number = nodes_.size();
    nodes_.push_back({around, begin, end, 0});

    if (end - begin <= leafSize)
    {
        return;
    }

    // Halve along the longest side
    int axis;
    (around.upper - around.lower).maxCoeff(&axis);

    const auto place = [&](int item)
    {
        return itemBounds_[item].lower[axis] + itemBounds_[item].upper[axis];
    };
    const int middle = begin + (end - begin)/2;

    std::nth_element
    (
        items_.begin() + begin,
        items_.begin() + middle,
        items_.begin() + end,
        [&](int a, int b)
        {
            return std::make_pair(place(a), a) < std::make_pair(place(b), b);
        }
    );

    build(begin, middle);
    nodes_[number].second = int(nodes_.size());
    build(middle, end);
}

} // End namespace plateletDynamics
