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
    const std::vector<springs>& stiffness
)
{
    // What the largest eigenvalue is at most, from trace and norm
    const auto atMost = [](const springs& M)
    {
        const double third = M.head<3>().sum()/3;
        const double norm2 =
            M.head<3>().square().sum() + 2*M.tail<3>().square().sum();

        return third + std::sqrt(std::max(0., 2./3*(norm2 - 3*third*third)));
    };

    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    double bound = 0;

    for (std::size_t k = 0; k < local.size(); ++k)
    {
        const springs& M = stiffness[k];
        if (local.fixed[k] || atMost(M) <= bound*local.friction[k])
        {
            continue;
        }

        Eigen::Matrix3d whole;
        whole <<
            M[0], M[3], M[4],
            M[3], M[1], M[5],
            M[4], M[5], M[2];
        solver.compute(whole, Eigen::EigenvaluesOnly);
        bound = std::max(bound, solver.eigenvalues()[2]/local.friction[k]);
    }
    return bound;
}

} // End namespace plateletDynamics
