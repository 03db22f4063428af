/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "wallForces.H"

#include <algorithm>
#include <cmath>

namespace plateletDynamics
{

namespace
{

double square(double x)
{
    return x*x;
}

} // End namespace


void wallForces::list
(
    const wallRegions& walls,
    const kernelPoints& points,
    double cutOff,
    double skin
)
{
    candidates_.clear();
    entries_.clear();
    neighbours_.clear();

    const double reach = cutOff + skin/2;
    const double reachSquared = reach*reach;

    for (std::size_t k = 0; k < points.owned; ++k)
    {
        const vector& x = points.position[k];
        const std::size_t begin = entries_.size();

        walls.pushing().near
        (
            x,
            reachSquared,
            [&](int region) { listRegion(walls, region, x, reach, skin); }
        );

        if (entries_.size() > begin)
        {
            // In the order of the regions, not of the tree
            std::sort
            (
                entries_.begin() + begin, entries_.end(),
                [](const entry& a, const entry& b)
                {
                    return a.region < b.region;
                }
            );
            neighbours_.push_back({int(k), x, begin, entries_.size()});
        }
    }
}


void wallForces::listRegion
(
    const wallRegions& walls,
    int region,
    const vector& x,
    double reach,
    double skin
)
{
    const wallRegions::region& r = walls.regions()[region];
    const std::size_t begin = candidates_.size();

    // What may become the nearest while the platelet moves half a skin
    double nearest = reach;
    double farthestSquared = square(reach + skin);
    r.tree.near
    (
        x,
        farthestSquared,
        [&](int item)
        {
            const double distance =
                std::sqrt(walls.distanceSquared(r.begin + item, x));

            candidates_.push_back({r.begin + item, distance});
            if (distance < nearest)
            {
                nearest = distance;
                farthestSquared = square(nearest + skin);
            }
        }
    );

    // Nothing within the reach leaves nothing
    const auto isTooFar = [&](const candidate& c)
    {
        return nearest == reach || c.distance > nearest + skin;
    };
    candidates_.erase
    (
        std::remove_if(candidates_.begin() + begin, candidates_.end(), isTooFar),
        candidates_.end()
    );
    if (candidates_.size() == begin)
    {
        return;
    }

    std::sort
    (
        candidates_.begin() + begin, candidates_.end(),
        [](const candidate& a, const candidate& b)
        {
            return
                std::make_pair(a.distance, a.triangle)
              < std::make_pair(b.distance, b.triangle);
        }
    );
    entries_.push_back({region, begin, candidates_.size()});
}


wallRegions::foot wallForces::nearest
(
    const wallRegions& walls,
    const entry& where,
    const vector& x,
    double moved
) const
{
    const bool planar = walls.regions()[where.region].planar;
    wallRegions::foot best{};
    double bestDistance = 0;

    for (std::size_t c = where.begin; c < where.end; ++c)
    {
        const bool first = c == where.begin;

        // What was farther away is still farther, less the way moved
        if (!first && candidates_[c].distance - moved > bestDistance)
        {
            break;
        }

        const auto foot = walls.nearest(candidates_[c].triangle, x);
        const double distance = (foot.point - x).norm();

        if (first || distance < bestDistance)
        {
            best = foot;
            bestDistance = distance;

            // No part of a plane is nearer than the perpendicular's foot
            if (planar && foot.within)
            {
                break;
            }
        }
    }
    return best;
}


void wallForces::pulls
(
    const wallRegions& walls,
    const neighbour& near,
    const vector& x,
    std::vector<pull>& all
) const
{
    // Equally near but for rounding
    constexpr double tie = 1 + 1e-9;

    // A little more than it has moved, against rounding
    const double moved = (1 + 1e-9)*(x - near.listed).norm() + 1e-300;

    all.clear();
    for (std::size_t e = near.begin; e < near.end; ++e)
    {
        const auto foot = nearest(walls, entries_[e], x, moved);
        const vector away(x - foot.point);

        all.push_back
        (
            {foot, away.norm(), away.dot(foot.outward) < 0, true}
        );
    }

    double shortest = all.front().distance;
    for (const pull& p : all)
    {
        shortest = std::min(shortest, p.distance);
    }

    bool inRock = true;
    for (const pull& p : all)
    {
        inRock = inRock && (p.distance > shortest*tie || p.behind);
    }

    for (pull& p : all)
    {
        const bool pushesBack =
            inRock && p.behind && p.distance <= shortest*tie;

        p.acts = pushesBack || !p.behind || p.foot.rim;
        p.behind = pushesBack;
    }
}


void wallForces::remove(int k)
{
    neighbours_.erase
    (
        std::remove_if
        (
            neighbours_.begin(), neighbours_.end(),
            [k](const neighbour& near){ return near.platelet == k; }
        ),
        neighbours_.end()
    );
}


template<class Use>
void wallForces::forEachWall
(
    const wallRegions& walls,
    const kernelPoints& points,
    const Use& use
) const
{
    std::vector<pull> all;

    for (const neighbour& near : neighbours_)
    {
        const vector& x = points.position[near.platelet];
        pulls(walls, near, x, all);

        for (const pull& p : all)
        {
            if (!p.acts)
            {
                continue;
            }

            // Where the wall is flat, and on the wall itself, the normal is
            // more exact than the line to the nearest point
            const bool onWall =
                p.distance <= 1e-14*(1 + x.cwiseAbs().maxCoeff());

            const vector direction
            (
                p.foot.flat || onWall
              ? p.foot.outward.normalized()
              : vector((x - p.foot.point)/(p.behind ? -p.distance : p.distance))
            );

            use(near.platelet, direction, p.behind ? -p.distance : p.distance);
        }
    }
}


std::int64_t wallForces::addForces
(
    const wallRegions& walls,
    const kernelPoints& points,
    const taperedForce& law,
    std::vector<vector>& force
) const
{
    std::int64_t contacts = 0;

    forEachWall
    (
        walls,
        points,
        [&](int k, const vector& direction, double distance)
        {
            const double gap = distance - law.thickness()/2;

            contacts += gap <= law.contactGap();
            force[k] += law.force(gap)*direction;
        }
    );
    return contacts;
}


void wallForces::addStiffness
(
    const wallRegions& walls,
    const kernelPoints& points,
    const taperedForce& law,
    std::vector<springs>& stiffness
) const
{
    forEachWall
    (
        walls,
        points,
        [&](int k, const vector& direction, double distance)
        {
            const double gap = distance - law.thickness()/2;
            const double force = law.force(gap);

            // Attraction to an edge holds sideways too; to a plane it does
            // not, but the bound may be generous
            const double across =
                force < 0 && distance > 0 ? force/distance : 0;

            pairSprings(direction, 1, law.slope(gap), across)
               .addTo(stiffness[k], weight(true));
        }
    );
}

} // End namespace plateletDynamics
