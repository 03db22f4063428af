/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "chebyshev2.H"

#include <cmath>
#include <utility>

namespace plateletDynamics
{

int chebyshev2::stagesFor(double deltaT, double decayRate)
{
    return std::max(2, 1 + int(std::sqrt(1.54*deltaT*decayRate + 1)));
}


double chebyshev2::attempt
(
    motion& system,
    const std::vector<vector>& start,
    double deltaT
)
{
    const int stages = stagesFor(deltaT, system.decayRate());
    const std::size_t n = start.size();
    offset_.resize(n);
    before_.resize(n);
    beforeThat_.resize(n);
    const std::vector<vector>& velocity = system.local().velocity;

    // Chebyshev's polynomials at w0, and their derivatives
    const double s = stages;
    const double w0 = 1 + 2/(13*s*s);
    const double root = std::sqrt(w0*w0 - 1);
    const double angle = s*std::log(w0 + root);
    const double w1 =
        std::sinh(angle)*(w0*w0 - 1)
       /(std::cosh(angle)*s*root - w0*std::sinh(angle));

    double T1 = w0, T2 = 1;
    double dT1 = 1, dT2 = 0;
    double ddT1 = 0, ddT2 = 0;
    double b1 = 1/(4*w0*w0), b2 = b1;

    const double first = w1*b1*deltaT;
    for (std::size_t k = 0; k < n; ++k)
    {
        beforeThat_[k].setZero();
        before_[k] = first*start[k];
    }

    for (int j = 2; j <= stages; ++j)
    {
        const double T = 2*w0*T1 - T2;
        const double dT = 2*w0*dT1 - dT2 + 2*T1;
        const double ddT = 2*w0*ddT1 - ddT2 + 4*dT1;
        const double b = ddT/(dT*dT);
        const double a = 1 - T1*b1;
        const double mu = 2*w0*b/b1;
        const double nu = -b/b2;
        const double gamma = mu*w1/w0*deltaT;

        system.evaluateAt(before_);
        for (std::size_t k = 0; k < n; ++k)
        {
            offset_[k] =
                mu*before_[k] + nu*beforeThat_[k]
              + gamma*(velocity[k] - a*start[k]);
        }
        std::swap(beforeThat_, before_);
        std::swap(before_, offset_);

        T2 = std::exchange(T1, T);
        dT2 = std::exchange(dT1, dT);
        ddT2 = std::exchange(ddT1, ddT);
        b2 = std::exchange(b1, b);
    }

    system.evaluateAt(before_);
    for (std::size_t k = 0; k < n; ++k)
    {
        offset_[k] =
            -0.8*before_[k] + 0.4*deltaT*(start[k] + velocity[k]);
    }
    return system.errorOverTolerance(offset_);
}

} // End namespace plateletDynamics
