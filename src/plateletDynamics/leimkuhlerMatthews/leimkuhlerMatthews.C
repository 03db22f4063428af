/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "leimkuhlerMatthews.H"

#include <cmath>

namespace plateletDynamics
{

double leimkuhlerMatthews::step(motion& system, double deltaT)
{
    platelets& local = system.local();

    // Two draws a step: the second is for platelets that begin
    const std::uint64_t draw = 2*steps_++;

    const auto displacementOf = [&](std::size_t k) -> vector
    {
        const double diffusivity = thermalEnergy_/local.friction[k];
        const double scale = std::sqrt(2*diffusivity/deltaT);
        const bool begins = local.previousStep[k] <= 0;

        // Random velocities, each of which acts for half a step
        const vector later(scale*noise_(local.id[k], draw));
        const vector earlier
        (
            begins
          ? vector(std::sqrt(3.0)*scale*noise_(local.id[k], draw + 1))
          : vector(local.previousStep[k]/deltaT*local.previousVelocity[k])
        );

        local.previousVelocity[k] = later;
        local.previousStep[k] = deltaT;

        vector velocity(local.velocity[k] + 0.5*(earlier + later));
        if (!local.mobilitySlope.empty())
        {
            velocity += diffusivity*local.mobilitySlope[k];
        }
        return deltaT*velocity;
    };

    system.displaceAll(displacementOf);

    return deltaT;
}

} // End namespace plateletDynamics
