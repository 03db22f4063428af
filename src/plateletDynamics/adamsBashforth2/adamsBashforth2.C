/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "adamsBashforth2.H"

namespace plateletDynamics
{

double adamsBashforth2::step(motion& system, double deltaT)
{
    platelets& local = system.local();

    const auto displacementOf = [&](std::size_t k) -> vector
    {
        const double previous = local.previousStep[k];
        const double halfRatio =
            deltaT <= 2*previous ? 0.5*deltaT/previous : 0;

        const vector displacement
        (
            deltaT
           *(
                (1 + halfRatio)*local.velocity[k]
              - halfRatio*local.previousVelocity[k]
            )
        );
        local.previousVelocity[k] = local.velocity[k];
        local.previousStep[k] = deltaT;

        return displacement;
    };

    system.displaceAll(displacementOf);

    return deltaT;
}

} // End namespace plateletDynamics
