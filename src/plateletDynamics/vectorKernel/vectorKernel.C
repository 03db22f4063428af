/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "vectorKernel.H"

#include "userError.H"

#include <algorithm>
#include <utility>

namespace plateletDynamics
{

vectorKernel::vectorKernel
(
    const taperedForce& force,
    const vectorLoops& loops,
    registerTable table,
    forceTable near
)
:
    plain_(force, std::move(near)),
    loops_(loops),
    table_(std::move(table)),
    cutOffSquared_(force.cutOff()*force.cutOff())
{
    for (int k = 0; k <= table_.degree(); ++k)
    {
        const auto& power = table_.coefficients(k);
        coefficients_.insert(coefficients_.end(), power.begin(), power.end());
    }
}


std::string vectorKernel::name() const
{
    return text
    (
        loops_.name, ", ", table_.intervals(), " polynomials of degree ",
        table_.degree()
    );
}


void vectorKernel::addForces
(
    const kernelPoints& points,
    const clusterPairs& pairs,
    const std::vector<int>& rows,
    std::vector<vector>& force,
    events& met
)
{
    // Zero after finishForces()
    sum_.resize(points.clusters(), clusterForces{});

    const double units = 1/(points.unit*points.unit);

    auto addNear = [&](int cluster, int partner, int i, int j)
    {
        const auto own = points.cluster[cluster];
        const auto other = points.cluster[partner];
        const int k = own.first + i;
        const int l = other.first + j;

        // Lanes without a point and absorbed platelets were moved away alike
        if
        (
            i < own.count && j < other.count
         && (points.position[k] - points.position[l]).squaredNorm()
          < cutOffSquared_
        )
        {
            plain_.addPair(points, k, l, force, met);
        }
    };
    using caller = decltype(addNear);

    pairSums task;
    task.place = points.place.data();
    task.start = pairs.starts();
    task.startOfMasks = pairs.startsOfMasks();
    task.partner = pairs.partners();
    task.mask = pairs.masks();
    task.cutOffSquared = float(cutOffSquared_*units);
    task.nearSquared = float(table_.beginSquared()*units);
    task.scale = float(1/(table_.taperSquared()*units));
    task.coefficients = coefficients_.data();
    task.force = sum_.data();
    task.caller = &addNear;
    task.near = [](void* object, int cluster, int partner, int i, int j)
    {
        (*static_cast<caller*>(object))(cluster, partner, i, j);
    };

    task.row = rows.data();
    task.rows = rows.size();

    loops_.addForces[table_.degree() - registerTable::lowestDegree](task);
}


void vectorKernel::finishForces
(
    const kernelPoints& points,
    std::vector<vector>& force
)
{
    for (int c = 0; c < points.ownedClusters; ++c)
    {
        const auto own = points.cluster[c];
        const float* const sum = sum_[c].value;

        for (int i = 0; i < own.count; ++i)
        {
            force[own.first + i] += points.unit*vector
            (
                sum[clusterForces::x + i],
                sum[clusterForces::y + i],
                sum[clusterForces::z + i]
            );
        }
        sum_[c] = {};
    }

    // Those of ghosts belong to other ranks
    std::fill(sum_.begin() + points.ownedClusters, sum_.end(), clusterForces{});
}

} // End namespace plateletDynamics
