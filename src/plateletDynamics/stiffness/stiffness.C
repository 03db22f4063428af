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
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    double bound = 0;

    for (std::size_t k = 0; k < local.size(); ++k)
    {
        // The trace is at least the largest eigenvalue
        if
        (
            local.fixed[k]
         || stiffness[k].trace() <= bound*local.friction[k]
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
