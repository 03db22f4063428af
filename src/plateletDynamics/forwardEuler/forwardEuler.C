/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "forwardEuler.H"

namespace plateletDynamics
{

double forwardEuler::step(motion& system, double deltaT)
{
    const std::vector<vector>& velocity = system.local().velocity;

    system.displaceAll
    (
        [&](std::size_t k) -> vector { return deltaT*velocity[k]; }
    );

    return deltaT;
}

} // End namespace plateletDynamics
