/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "boundaryCrossings.H"

#include <cmath>

namespace plateletDynamics
{

namespace
{

constexpr int mostReflections = 16;

} // End namespace


void boundaryCrossings::list
(
    const wallRegions& walls,
    const kernelPoints& points,
    double reach
)
{
    clearance_.clear();
    listed_.clear();

    if (walls.crossed().empty())
    {
        return;
    }

    tolerance_ = 1e-9*reach;
    listed_.assign
    (
        points.position.begin(), points.position.begin() + points.owned
    );

    for (const vector& x : listed_)
    {
        double nearest = reach*reach;
        walls.crossed().near
        (
            x,
            nearest,
            [&](int regioni)
            {
                const wallRegions::region& region = walls.regions()[regioni];
                region.tree.near
                (
                    x,
                    nearest,
                    [&](int item)
                    {
                        nearest = std::min
                        (
                            nearest,
                            walls.distanceSquared(region.begin + item, x)
                        );
                    }
                );
            }
        );

        // Rounding must not hide a crossing
        clearance_.push_back((1 - 1e-9)*std::sqrt(nearest) - tolerance_);
    }
}


boundaryCrossings::outcome boundaryCrossings::follow
(
    const wallRegions& walls,
    const vector& from,
    const vector& displacement
) const
{
    vector x(from);
    vector left(displacement);
    std::vector<vector> bends;

    for (int reflection = 0; reflection <= mostReflections; ++reflection)
    {
        // The first crossing on the way from x by what is left
        double first = 2;
        int crossed = -1;

        bounds way;
        way.include(x);
        way.include(x + left);

        walls.crossed().near
        (
            way,
            2*tolerance_,
            [&](int regioni)
            {
                const wallRegions::region& region = walls.regions()[regioni];
                region.tree.near
                (
                    way,
                    2*tolerance_,
                    [&](int item)
                    {
                        const int number = region.begin + item;
                        const auto& t = walls.triangles()[number];
                        const double before = t.height(x);
                        const double approach = -left.dot(t.normal);

                        if
                        (
                            before < -tolerance_
                         || approach <= 0
                         || before - approach >= 0
                        )
                        {
                            return;
                        }

                        const double share = std::max(0.0, before/approach);
                        const bool sooner =
                            share < first
                         || (share == first && number < crossed);

                        if (sooner && t.contains(x + share*left))
                        {
                            first = share;
                            crossed = number;
                        }
                    }
                );
            }
        );

        if (crossed < 0)
        {
            // Bit for bit where nothing was met
            return
            {
                bends.empty() ? displacement : vector(x + left - from),
                -1,
                vector::Zero(),
                std::move(bends)
            };
        }

        const auto& t = walls.triangles()[crossed];
        x += first*left;

        if (t.does == boundarySurface::action::absorb)
        {
            return {x - from, t.patch, x, std::move(bends)};
        }
        bends.push_back(x);

        left *= 1 - first;
        left -= 2*left.dot(t.normal)*t.normal;
    }

    return {vector::Zero()};
}

} // End namespace plateletDynamics
