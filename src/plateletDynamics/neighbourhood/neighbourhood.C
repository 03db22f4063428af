/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "neighbourhood.H"

#include "cellOrder.H"
#include "lineOfSight.H"
#include "stopwatch.H"
#include "userError.H"

#include <algorithm>
#include <cmath>

namespace plateletDynamics
{

namespace
{

//- Skin over cut-off where the user leaves it to us: at first, and the limits
//  of what is chosen later
constexpr double firstSkin = 0.12;
constexpr double leastSkin = 0.02;
constexpr double largestSkin = 0.5;

//- What making the lists costs, in evaluations of the forces of as many listed
//  pairs: 4.8 with AVX-512, 6.2 with AVX2, 2.2 with SSE4 (engineBenchmark
//  -skin 0.15 -rebuildEvery 5). A constant, so that the choice does not depend
//  on clocks
constexpr double costOfLists = 5;

//- How much a cluster's pairs reach beyond those of a point, in edges of the
//  cube that holds as many platelets: from the pairs of clusters at skins of
//  0.1, 0.2 and 0.3 spacings, cut-off 2.5
constexpr double reachOfClusters = 1.1;

//- The longest cluster, in such edges; but clusters of platelets that are far
//  from each other may be so long in cut-offs
constexpr double longestInEdges = 1.5;
constexpr double longestInCutOffs = 0.5;

//- Weight of the newest figure in the mean use of the skin
constexpr double newest = 0.3;

} // End namespace


neighbourhood::neighbourhood
(
    const rankGroup& ranks,
    const periodicBox& space,
    const boundarySurface& limits,
    const vectorLoops& loops
)
:
    ranks_(ranks),
    space_(space),
    limits_(limits),
    halo_(ranks, space),
    pairs_(loops)
{}


void neighbourhood::setRange(double cutOff, double wallCutOff, double skin)
{
    // A skin of a cut-off at most: pairs of the lists are far less than half a
    // lattice apart
    points_.setUnit(std::ldexp(cutOff, -27));
    cutOff_ = cutOff;
    wallCutOff_ = wallCutOff;
    skinIsChosen_ = !(skin > 0);
    mostSkin_ = skinIsChosen_ ? largestSkin*cutOff : skin;
    if (mostSkin_ > cutOff)
    {
        throw userError
        (
            text
            (
                "The skin of ", lengths(skin), " is wider than the cutOff of ",
                lengths(cutOff), ". Take at most that, or leave it to be chosen"
            )
        );
    }

    for (int axis = 0; axis < 3; ++axis)
    {
        if (!space_.periodic[axis])
        {
            continue;
        }
        const double period = space_.period(axis);

        if (!(period >= 2*cutOff))
        {
            throw userError
            (
                text
                (
                    "The periodic box is ", lengths(period), " wide along ",
                    "xyz"[axis], ", less than two cut-offs of ",
                    lengths(cutOff), ". Take a box of at least ",
                    lengths(2*cutOff), " or a cutOff of at most ",
                    lengths(period/2)
                )
            );
        }

        // Images one period away are all that there are
        mostSkin_ = std::min(mostSkin_, period - cutOff);
    }
    skin_ = mostSkin_;

    // Walls that reach farther than need be are right too
    if (!walls_ || cutOff_ + mostSkin_ > wallsReach_)
    {
        wallsReach_ = cutOff_ + mostSkin_;
        walls_ = std::make_unique<wallRegions>(limits_, space_, wallsReach_);
    }
    expire();
}


double neighbourhood::clusterEdge(double neighbours, double number) const
{
    // Of cells as wide as the cut-off, those around a platelet hold so many
    const double most = clusterSize;
    const double inCell = number > 0 ? neighbours/number : 0;

    return cutOff_*std::cbrt(most/std::max(inCell, most));
}


void neighbourhood::chooseSkin(double clusterEdge)
{
    skin_ = mostSkin_;

    if (!skinIsChosen_)
    {
        return;
    }
    if (skinUse_ < 0)
    {
        skin_ = std::min(skin_, firstSkin*cutOff_);
        return;
    }

    // The least of (reach + skin)^3 (1 + w/skin): pairs listed, evaluated in
    // every step and listed every skin/use steps
    const double reach = cutOff_ + reachOfClusters*clusterEdge;
    const double w = costOfLists*skinUse_;
    const double best = (std::sqrt(w*w + 3*w*reach) - w)/3;

    skin_ = std::min(skin_, std::max(best, leastSkin*cutOff_));
}


void neighbourhood::noteSkinUse()
{
    if (age_ > 0)
    {
        const double use = skinUsed_/age_;
        skinUse_ = skinUse_ < 0 ? use : (1 - newest)*skinUse_ + newest*use;
    }
    age_ = 0;
}


void neighbourhood::sort
(
    platelets& local,
    const bounds& around,
    std::vector<int>& present,
    double edge
) const
{
    // Columns, cut short for the search by counting
    const cellKeys grid(around, vector(0.5*edge, edge, edge));
    std::vector<std::int64_t> keys;
    keys.reserve(present.size());
    for (const int k : present)
    {
        keys.push_back(grid.pathKey(local.position[k]));
    }

    cellOrder order(keys);
    for (std::size_t c = 0; c + 1 < order.cells.size(); ++c)
    {
        const double sign = grid.isBackward(order.cells[c].key) ? -1 : 1;

        std::sort
        (
            order.index.begin() + order.cells[c].begin,
            order.index.begin() + order.cells[c + 1].begin,
            [&](int a, int b)
            {
                const double ahead = sign*
                (
                    local.position[present[b]][0]
                  - local.position[present[a]][0]
                );
                return
                    ahead > 0
                 || (
                        ahead == 0
                     && local.id[present[a]] < local.id[present[b]]
                    );
            }
        );
    }
    for (int& k : order.index)
    {
        k = present[k];
    }
    local.reorder(order.index);
}


void neighbourhood::takeBack(platelets& local)
{
    for (std::size_t k = 0; k < local.size(); ++k)
    {
        if (local.fixed[k] == platelets::absorbed)
        {
            continue;
        }
        vector& x = local.position[k];

        // Of the point alone, not of how often it was taken back: counters of
        // passages see the same place
        if (stepped_)
        {
            x = points_.position[k];
        }
        const std::array<int, 3> outside(space_.wrap(x));
        for (int axis = 0; axis < 3; ++axis)
        {
            local.crossings[k][axis] += outside[axis];
            if (stepped_)
            {
                local.crossings[k][axis] -= wraps_[k][axis];
                wraps_[k][axis] = std::int8_t(outside[axis]);
            }
        }
    }
    stepped_ = false;
}


void neighbourhood::listWalls()
{
    if (walls_->empty())
    {
        return;
    }

    wallForces_.list(*walls_, points_, wallCutOff_, skin_);
    crossings_.list(*walls_, points_, 2*skin_);

    const lineOfSight sight(*walls_, points_, cutOff_ + skin_);
    if (!sight.free())
    {
        pairs_.remove
        (
            points_,
            [&](int k) { return !sight.isFree(k); },
            [&](int k, int j) { return sight.interrupted(k, j); }
        );
    }
}


void neighbourhood::rebuild(platelets& local, bool maySort)
{
    const stopwatch watch(listSeconds_);
    const double waitedBefore = haloSeconds();

    takeBack(local);

    const bounds around
    (
        boundsOf(local.position, local.fixed, 0, local.size())
    );
    const cellKeys grid(around, vector::Constant(cutOff_));
    std::vector<int> present;
    std::vector<std::int64_t> keys;
    for (std::size_t k = 0; k < local.size(); ++k)
    {
        if (local.fixed[k] != platelets::absorbed)
        {
            present.push_back(int(k));
            keys.push_back(grid.key(local.position[k]));
        }
    }
    double neighbours = 0;
    const cellOrder order(keys);
    for (std::size_t c = 0; c + 1 < order.cells.size(); ++c)
    {
        const double number = order.cells[c + 1].begin - order.cells[c].begin;
        neighbours += number*(number - 1);
    }
    const double edge = clusterEdge(neighbours, double(present.size()));
    unsorted_ = maySort ? 0 : unsorted_ + 1;
    if (maySort)
    {
        sort(local, around, present, edge);
    }

    // The same on all ranks
    {
        const stopwatch waiting(waitSeconds_);
        const double sum = ranks_.sum(neighbours);
        chooseSkin(clusterEdge(sum, ranks_.sum(double(present.size()))));
    }

    wraps_.assign(local.size(), {0, 0, 0});

    points_.owned = local.size();
    points_.resize(local.size());
    points_.id = local.id;
    points_.fixed = local.fixed;
    std::copy
    (
        local.position.begin(), local.position.end(), points_.position.begin()
    );
    halo_.rebuild(points_, cutOff_ + skin_);

    points_.formClusters
    (
        std::max(longestInEdges*edge, longestInCutOffs*cutOff_)
    );
    listed_.assign
    (
        points_.place.begin(), points_.place.begin() + points_.ownedClusters
    );
    movedSquared_ = 0;
    pairs_.build(points_, cutOff_ + skin_);
    listWalls();

    // Waiting is counted apart
    listSeconds_ -= haloSeconds() - waitedBefore;
    expired_ = false;
}


void neighbourhood::finish()
{
    if (arriving_)
    {
        halo_.finish();
        points_.setPlaces(points_.owned, points_.size());
        arriving_ = false;
    }
}


bool neighbourhood::update
(
    platelets& local,
    bool maySort,
    const std::string& problem,
    double& largestMove
)
{
    // The same on all ranks
    double decision[4] =
    {
        double(!problem.empty()),
        double(expired_),
        2*std::sqrt(movedSquared_),
        largestMove
    };
    {
        const stopwatch watch(waitSeconds_);
        ranks_.max(decision, 4);
    }
    largestMove = decision[3];

    if (decision[0] > 0)
    {
        ranks_.agree(problem);
    }
    const bool expired = decision[1] > 0;
    if (!expired)
    {
        ++age_;
        skinUsed_ = decision[2];
    }

    if (expired || skinUsed_ > skin_)
    {
        noteSkinUse();
        rebuild(local, maySort);
        return true;
    }

    halo_.start(points_);
    arriving_ = true;
    return false;
}

} // End namespace plateletDynamics
