/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "leimkuhlerMatthews.H"

#include <algorithm>
#include <cmath>

namespace plateletDynamics
{

double leimkuhlerMatthews::step(motion& system, double deltaT)
{
    platelets& local = system.local();
    const mobility& mu = system.forceToVelocity();

    const auto begins = [&](double previousStep) { return previousStep <= 0; };
    const auto draw = [&](std::uint64_t number, std::vector<vector>& random)
    {
        mu.drawVelocities(local, thermalEnergy_, deltaT, noise_, number, random);
    };

    // Two draws a step: the second is for platelets that begin
    const std::uint64_t number = 2*steps_++;
    draw(number, later_);
    if
    (
        std::any_of
        (
            local.previousStep.begin(), local.previousStep.end(), begins
        )
    )
    {
        draw(number + 1, begin_);
    }

    velocity_.resize(local.size());
    for (std::size_t k = 0; k < local.size(); ++k)
    {
        // Each acts for half a step
        const vector earlier
        (
            begins(local.previousStep[k])
          ? vector(std::sqrt(3.0)*begin_[k])
          : vector(local.previousStep[k]/deltaT*local.previousVelocity[k])
        );
        velocity_[k] = local.velocity[k] + 0.5*(earlier + later_[k]);

        local.previousVelocity[k] = later_[k];
        local.previousStep[k] = deltaT;
    }
    mu.addDrift(local, thermalEnergy_, velocity_);

    system.displaceAll
    (
        [&](std::size_t k) -> vector { return deltaT*velocity_[k]; }
    );

    return deltaT;
}

} // End namespace plateletDynamics
