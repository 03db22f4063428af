/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "kernelPoints.H"

#include "bounds.H"

namespace plateletDynamics
{

void kernelPoints::formClusters(double longestEdge)
{
    cluster.clear();
    slot.assign(size(), -1);

    const auto form = [&](std::size_t begin, std::size_t end)
    {
        bounds box;
        bool isOpen = false;

        for (std::size_t k = begin; k < end; ++k)
        {
            if (fixed[k] == platelets::absorbed)
            {
                isOpen = false;
                continue;
            }

            bounds grown(box);
            grown.include(position[k]);
            if
            (
                !isOpen
             || cluster.back().count == clusterSize
             || (grown.upper - grown.lower).maxCoeff() > longestEdge
            )
            {
                grown = bounds();
                grown.include(position[k]);
                cluster.push_back({int(k), 0});
            }
            box = grown;
            isOpen = true;

            slot[k] = clusterSize*(clusters() - 1) + cluster.back().count++;
        }
    };

    form(0, owned);
    ownedClusters = clusters();
    form(owned, size());

    // Lanes without a point are put away from where the last point is
    place.assign(cluster.size(), {});
    for (int c = 0; c < clusters(); ++c)
    {
        for (int lane = 0; lane < clusterSize; ++lane)
        {
            const int last = cluster[c].count - 1;
            const int k = cluster[c].first + std::min(lane, last);

            setPlace(clusterSize*c + lane, wholeUnits(position[k]));
            if (lane > last)
            {
                moveAway(clusterSize*c + lane);
            }
        }
    }
}

} // End namespace plateletDynamics
