/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "adamsBashforth2.H"

namespace plateletDynamics
{

void adamsBashforth2::step(motion& system, double deltaT)
{
    platelets& local = system.local();
    displacement_.resize(local.size());

    for (std::size_t k = 0; k < local.size(); ++k)
    {
        const double previous = local.previousStep[k];
        const double halfRatio =
            deltaT <= 2*previous ? 0.5*deltaT/previous : 0;

        displacement_[k] =
            deltaT
           *(
                (1 + halfRatio)*local.velocity[k]
              - halfRatio*local.previousVelocity[k]
            );
        local.previousVelocity[k] = local.velocity[k];
        local.previousStep[k] = deltaT;
    }

    system.displace(displacement_);
}

} // End namespace plateletDynamics
