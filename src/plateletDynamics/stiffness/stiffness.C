/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "stiffness.H"

#include <Eigen/Eigenvalues>

namespace plateletDynamics
{

double decayRateBound
(
    const platelets& local,
    const std::vector<Eigen::Matrix3d>& stiffness
)
{
    // What the largest eigenvalue of M is at most, from trace and norm
    const auto atMost = [](const Eigen::Matrix3d& M)
    {
        const double third = M.trace()/3;
        return
            third
          + std::sqrt(std::max(0., 2./3*(M.squaredNorm() - 3*third*third)));
    };

    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    double bound = 0;

    for (std::size_t k = 0; k < local.size(); ++k)
    {
        if
        (
            local.fixed[k]
         || atMost(stiffness[k]) <= bound*local.friction[k]
        )
        {
            continue;
        }
        solver.compute(stiffness[k], Eigen::EigenvaluesOnly);
        bound = std::max(bound, solver.eigenvalues()[2]/local.friction[k]);
    }
    return bound;
}

} // End namespace plateletDynamics
