/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "lineOfSight.H"

#include <algorithm>
#include <cmath>

namespace plateletDynamics
{

lineOfSight::lineOfSight
(
    const wallRegions& walls,
    const kernelPoints& points,
    double range
)
:
    walls_(walls),
    points_(points),
    inFront_(points.size(), 1),
    clearance_(points.size(), 0)
{
    if (walls.rock().empty())
    {
        return;
    }
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        inFront_[k] = isInFront(points.position[k], range);
        allInFront_ = allInFront_ && inFront_[k];
    }
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        if (!inFront_[k])
        {
            clearance_[k] = clearance(points.position[k], range);
        }
    }
}


double lineOfSight::clearance(const vector& x, double range) const
{
    double nearest = range*range;

    walls_.rock().near
    (
        x,
        nearest,
        [&](int regioni)
        {
            const wallRegions::region& region = walls_.regions()[regioni];
            region.tree.near
            (
                x,
                nearest,
                [&](int item)
                {
                    nearest = std::min
                    (
                        nearest, walls_.distanceSquared(region.begin + item, x)
                    );
                }
            );
        }
    );
    return std::sqrt(nearest);
}


bool lineOfSight::isInFront(const vector& x, double range) const
{
    const double tolerance = 1e-12*range;
    bool front = true;

    // Negative once a triangle is found that x is behind: nothing is nearer
    double reach = range*range;

    walls_.rock().near
    (
        x,
        reach,
        [&](int regioni)
        {
            const wallRegions::region& region = walls_.regions()[regioni];

            // A plane that x is in front of has no triangle that it is behind
            if
            (
                region.planar
             && walls_.triangles()[region.begin].height(x) >= -tolerance
            )
            {
                return;
            }

            region.tree.near
            (
                x,
                reach,
                [&](int item)
                {
                    const int number = region.begin + item;
                    const auto& t = walls_.triangles()[number];

                    if
                    (
                        front
                     && t.height(x) < -tolerance
                     && walls_.distanceSquared(number, x) <= reach
                    )
                    {
                        front = false;
                        reach = -1;
                    }
                }
            );
        }
    );
    return front;
}


bool lineOfSight::interrupted(int i, int j) const
{
    if (inFront_[i] && inFront_[j])
    {
        return false;
    }

    const vector& x = points_.position[i];
    const vector& y = points_.position[j];

    // Each point of the line is nearer to an end than any wall is
    const double clear = clearance_[i] + clearance_[j];
    if ((y - x).squaredNorm() < 0.999*clear*clear)
    {
        return false;
    }

    bool found = false;

    bounds line;
    line.include(x);
    line.include(y);

    walls_.rock().near
    (
        line,
        0,
        [&](int regioni)
        {
            const wallRegions::region& region = walls_.regions()[regioni];
            if (found)
            {
                return;
            }
            region.tree.near
            (
                line,
                0,
                [&](int item)
                {
                    found =
                        found
                     || walls_.triangles()[region.begin + item].between(x, y);
                }
            );
        }
    );
    return found;
}

} // End namespace plateletDynamics
