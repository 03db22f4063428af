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
    double spacing,
    double tolerance,
    const std::string& instructions
)
:
    plain_(force, forceTable(force, tolerance)),
    loops_(vectorLoops::choose(instructions)),
    table_(force, spacing, loops_.intervals, tolerance),
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
    const auto loop =
        loops_.addForces[table_.degree() - registerTable::lowestDegree];

    // Room for the near pairs of at least one row
    std::vector<int> nearRow(4096);
    std::vector<int> nearEntry(nearRow.size());

    for (const rowRange& range : rows)
    {
        task.begin = range.begin;
        task.end = range.end;

        while (task.begin < task.end)
        {
            task.nearRow = nearRow.data();
            task.nearEntry = nearEntry.data();
            task.nNear = 0;
            task.mostNear = nearRow.size() - mostLanes;

            const int begun = task.begin;
            loop(task);

            for (std::size_t i = 0; i < task.nNear; ++i)
            {
                addNear
                (
                    points,
                    nearRow[i],
                    nearEntry[i]/latticePlace::entry,
                    force,
                    met
                );
            }
            if (task.begin == begun)
            {
                nearRow.resize(2*nearRow.size());
                nearEntry.resize(nearRow.size());
            }
        }
    }
}


void vectorKernel::addNear
(
    const kernelPoints& points,
    int k,
    int j,
    std::vector<vector>& force,
    events& met
) const
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

} // End namespace plateletDynamics
