/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "localMobility.H"
#include "userError.H"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace plateletDynamics
{

std::string localMobility::calculateVelocities(platelets& local) const
{
    std::string problem;

    for (std::size_t k = 0; k < local.size(); ++k)
    {
        vector& velocity = local.velocity[k];
        velocity.setZero();

        if (local.fixed[k])
        {
            continue;
        }
        if (std::isgreater(local.friction[k], 0))
        {
            velocity =
                local.waterVelocity[k] + (1/local.friction[k])*local.force[k];

            if (isFinite(velocity))
            {
                continue;
            }
        }
        if (problem.empty())
        {
            problem = text
            (
                "Platelet ", local.id[k], " has no velocity: water velocity (",
                local.waterVelocity[k].transpose(), "), force (",
                local.force[k].transpose(), "), friction ", local.friction[k]
            );
        }
        velocity.setZero();
    }
    return problem;
}


double localMobility::largestEigenvalue(const platelets& local) const
{
    double largest = 0;
    for (std::size_t k = 0; k < local.size(); ++k)
    {
        if (!local.fixed[k])
        {
            largest = std::max(largest, 1/local.friction[k]);
        }
    }
    return largest;
}


double localMobility::decayRateBound
(
    const platelets& local,
    const std::vector<springs>& stiffness
) const
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


void localMobility::drawVelocities
(
    const platelets& local,
    double thermalEnergy,
    double deltaT,
    const gaussianNoise& noise,
    std::uint64_t draw,
    std::vector<vector>& random
) const
{
    random.resize(local.size());
    for (std::size_t k = 0; k < local.size(); ++k)
    {
        const double diffusivity = thermalEnergy/local.friction[k];
        random[k] = std::sqrt(2*diffusivity/deltaT)*noise(local.id[k], draw);
    }
}


void localMobility::addDrift
(
    const platelets& local,
    double thermalEnergy,
    std::vector<vector>& velocity
) const
{
    for (std::size_t k = 0; k < local.mobilitySlope.size(); ++k)
    {
        velocity[k] +=
            (thermalEnergy/local.friction[k])*local.mobilitySlope[k];
    }
}

} // End namespace plateletDynamics
