/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "vertexWeld.H"

#include <algorithm>
#include <numeric>

namespace plateletDynamics
{

std::vector<int> vertexWeld
(
    const std::vector<vector>& points,
    const std::vector<double>& tolerance
)
{
    // Sweep along a direction in which few points of a mesh coincide
    const vector direction(vector(0.5701, 0.6237, 0.5347).normalized());

    std::vector<std::pair<double, int>> order(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        order[i] = {direction.dot(points[i]), int(i)};
    }
    std::sort(order.begin(), order.end());

    // Each point takes the number of the first like it
    std::vector<int> first(points.size());
    std::iota(first.begin(), first.end(), 0);
    std::vector<std::uint8_t> welded(points.size(), 0);

    for (std::size_t s = 0; s < order.size(); ++s)
    {
        const int i = order[s].second;
        if (welded[i])
        {
            continue;
        }
        for (std::size_t t = s + 1; t < order.size(); ++t)
        {
            const int j = order[t].second;
            if (order[t].first - order[s].first > tolerance[i])
            {
                break;
            }
            const double near = std::min(tolerance[i], tolerance[j]);

            if ((points[i] - points[j]).squaredNorm() <= near*near)
            {
                first[j] = first[i];
                welded[j] = 1;
            }
        }
    }
    return first;
}

} // End namespace plateletDynamics
