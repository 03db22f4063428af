/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "adaptiveIntegrator.H"

#include "userError.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plateletDynamics
{

namespace
{

//- Steps tried in vain beyond which something else is wrong: each is at most
//  0.8 of the one before
constexpr int mostTries = 200;

} // End namespace


double adaptiveIntegrator::longestStep(motion& system) const
{
    const double rate = system.decayRate();

    return rate > 0 ? realAxisLimit()/rate : std::numeric_limits<double>::max();
}


double adaptiveIntegrator::step(motion& system, double deltaT)
{
    start_ = system.local().velocity;

    if (deltaT/tooManySteps > longestStep(system))
    {
        throw userError
        (
            text
            (
                "A duration of ", times(deltaT), " would take more than ",
                tooManySteps, " steps: displacements decay at ",
                perTime(system.decayRate()), ". Softer forces (a larger"
                " contactGap), or platelets that do not overlap"
            )
        );
    }

    if (control_.next() <= 0)
    {
        const double rate = system.decayRate();

        // Not 1/rate, where bogackiShampine's estimate of a decay is 0
        control_.start(rate > 0 ? 0.5/rate : deltaT);
    }

    for (int tries = 0; tries < mostTries; ++tries)
    {
        // In equal steps to the end
        const double most = std::min(control_.next(), longestStep(system));
        const double h = deltaT/std::ceil(deltaT/most*(1 - 1e-10));

        if (control_.accept(h, attempt(system, start_, h)))
        {
            system.accept();
            return h;
        }
        system.back();
    }
    throw userError
    (
        text
        (
            "No step from ", times(deltaT), " down to ",
            times(control_.next()), " keeps the tolerance"
        )
    );
}

} // End namespace plateletDynamics
