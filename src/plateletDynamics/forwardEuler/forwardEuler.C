/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "forwardEuler.H"

namespace plateletDynamics
{

void forwardEuler::step(motion& system, double deltaT)
{
    platelets& local = system.local();
    displacement_.resize(local.size());

    for (std::size_t k = 0; k < local.size(); ++k)
    {
        displacement_[k] = deltaT*local.velocity[k];
        local.previousVelocity[k] = local.velocity[k];
        local.previousStep[k] = deltaT;
    }

    system.displace(displacement_);
}

} // End namespace plateletDynamics
