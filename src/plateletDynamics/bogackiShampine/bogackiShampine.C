/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "bogackiShampine.H"

namespace plateletDynamics
{

double bogackiShampine::attempt
(
    motion& system,
    const std::vector<vector>& start,
    double deltaT
)
{
    const std::vector<vector>& velocity = system.local().velocity;
    offset_.resize(start.size());

    const auto evaluateAt = [&](const auto& offsetOf)
    {
        for (std::size_t k = 0; k < offset_.size(); ++k)
        {
            offset_[k] = deltaT*offsetOf(k);
        }
        system.evaluateAt(offset_);
    };

    evaluateAt([&](std::size_t k) -> vector { return 0.5*start[k]; });
    k2_ = velocity;

    evaluateAt([&](std::size_t k) -> vector { return 0.75*k2_[k]; });
    k3_ = velocity;

    evaluateAt
    (
        [&](std::size_t k) -> vector
        {
            return (2*start[k] + 3*k2_[k] + 4*k3_[k])/9;
        }
    );
    for (std::size_t k = 0; k < offset_.size(); ++k)
    {
        offset_[k] =
            deltaT
           *(
                -5./72*start[k] + 1./12*k2_[k] + 1./9*k3_[k] - 1./8*velocity[k]
            );
    }
    return system.errorOverTolerance(offset_);
}

} // End namespace plateletDynamics
