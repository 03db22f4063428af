/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "vectorKernel.H"

#include "userError.H"

namespace plateletDynamics
{

vectorKernel::vectorKernel
(
    const taperedForce& force,
    double tolerance,
    const std::string& instructions
)
:
    plain_(force, forceTable(force, tolerance)),
    loops_(vectorLoops::choose(instructions)),
    table_(force, loops_.intervals, tolerance),
    cutOffSquared_(force.cutOff()*force.cutOff())
{
    for (int k = 0; valid() && k <= table_.degree(); ++k)
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
    const neighbourList& pairs,
    const std::vector<rowRange>& rows,
    std::vector<vector>& force,
    events& met
) const
{
    static_assert
    (
        sizeof(vector) == 3*sizeof(double),
        "forces are handed over as rows of doubles"
    );

    std::vector<std::array<int, 2>> near;
    const double units = 1/(points.unit*points.unit);

    pairSums task;
    task.place = points.place.data();
    task.start = pairs.starts();
    task.neighbour = pairs.neighbours();
    task.cutOffSquared = float(cutOffSquared_*units);
    task.nearSquared = float(table_.beginSquared()*units);
    task.scale = float(1/(table_.taperSquared()*units));
    task.coefficients = coefficients_.data();
    task.unit = points.unit;
    task.force = force.empty() ? nullptr : force[0].data();
    task.near = [](void* context, int k, int j)
    {
        static_cast<decltype(near)*>(context)->push_back({k, j});
    };
    task.context = &near;

    for (const rowRange& range : rows)
    {
        task.begin = range.begin;
        task.end = range.end;
        loops_.addForces[table_.degree() - registerTable::lowestDegree](task);
    }

    for (const auto& [k, j] : near)
    {
        // Two absorbed ones were moved away alike
        if
        (
            (points.position[k] - points.position[j]).squaredNorm()
          < cutOffSquared_
        )
        {
            force[k] += plain_.force(points, k, j, met);
        }
    }
}

} // End namespace plateletDynamics
