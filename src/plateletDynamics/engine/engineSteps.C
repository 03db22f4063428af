/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "engineImplementation.H"

#include <cmath>

namespace plateletDynamics
{

namespace
{

//- Share of the integrator's limit, and of the spacing, that a chosen step uses
constexpr double safety = 0.5;
constexpr double largestMove = 0.25;

//- The step is chosen anew when a platelet may have come this far, in spacings.
//  Not when lists are made: that depends on the number of ranks
constexpr double holdsFor = 0.05;

//- Steps of one call beyond which it would never end
constexpr double tooManySteps = 1e12;

//- Time from rate, where no rate means no limit
double inverse(double rate)
{
    return rate > 1e-300 ? 1/rate : 1e300;
}


//- Where absorbed platelets go, in cut-offs: its square is still a number
constexpr double outOfReach = 1e15;

} // End namespace


double engine::implementation::moveScale() const
{
    return
        settings_.spacing > 0
      ? std::min(settings_.spacing, settings_.cutOff)
      : settings_.cutOff;
}


double engine::implementation::stabilityLimit()
{
    return inverse(stiffness()/integrator_->realAxisLimit());
}


double engine::implementation::stableDeltaT()
{
    const double byStiffness =
        stiffness()/(safety*integrator_->realAxisLimit());

    double fastest = 0;
    for (const vector& velocity : local_.velocity)
    {
        fastest = std::max(fastest, velocity.cwiseAbs().maxCoeff());
    }
    fastest = ranks_.max(fastest);

    return inverse
    (
        std::max(byStiffness, fastest/(largestMove*moveScale()))
    );
}


std::int64_t engine::implementation::stepsFor(double duration)
{
    const double step =
        settings_.deltaT > 0 ? settings_.deltaT : stableDeltaT();

    if (duration/tooManySteps > step)
    {
        throw userError
        (
            text
            (
                "A duration of ", duration, " in steps of ", step,
                " would take more than ", tooManySteps, " steps"
            )
        );
    }

    // A duration that is a multiple of the step but for rounding
    return std::max(1.0, std::ceil(duration/step*(1 - 1e-10)));
}


void engine::implementation::displace
(
    std::size_t first,
    const std::vector<vector>& displacement
)
{
    const bool crossable = !near_.crossings().empty();

    for (std::size_t i = 0; i < displacement.size(); ++i)
    {
        const std::size_t k = first + i;
        if (local_.fixed[k])
        {
            continue;
        }

        const vector& d = displacement[i];

        if (!isFinite(d) || d.cwiseAbs().maxCoeff() > settings_.cutOff)
        {
            if (problem_.empty())
            {
                problem_ = text
                (
                    "Platelet ", local_.id[k], " at (",
                    near_.points().position[k].transpose(),
                    ") would move by (", d.transpose(), ") in one step, more"
                    " than the cut-off of ", settings_.cutOff,
                    ". Take a smaller engine step"
                );
            }
            continue;
        }
        movedSquared_ = std::max(movedSquared_, d.squaredNorm());

        const vector& from = near_.points().position[k];
        if (!crossable || !near_.crossings().near(k, from, d))
        {
            near_.displace(k, d);
            continue;
        }

        const auto met = near_.crossings().follow(near_.walls(), from, d);
        near_.displace(k, met.displacement);
        if (met.absorbedBy >= 0)
        {
            absorb(k, met.absorbedBy);
        }
    }

    forcesHold_ = false;
    stiffnessHolds_ = false;
}


void engine::implementation::absorb(std::size_t k, int patch)
{
    vector place(near_.points().position[k]);
    space_.wrap(place);
    departures_.push_back({local_.id[k], local_.tag[k], patch, place});

    // Out of reach of all others, and of each other, until the lists are new
    local_.fixed[k] = platelets::absorbed;
    local_.position[k] =
        settings_.cutOff*vector(outOfReach, 10.0*double(local_.id[k]), 0);
    near_.remove(k, local_.position[k]);
}


void engine::implementation::dropAbsorbed()
{
    std::vector<int> kept;
    for (std::size_t k = 0; k < local_.size(); ++k)
    {
        if (local_.fixed[k] != platelets::absorbed)
        {
            kept.push_back(int(k));
        }
    }

    if (kept.size() < local_.size())
    {
        local_.reorder(kept);
        near_.expire();
    }
}


void engine::implementation::advance(double duration)
{
    if (!std::isfinite(duration) || duration < 0)
    {
        throw userError(text("Cannot advance by a time of ", duration));
    }

    departures_.clear();

    double remaining = duration;
    std::int64_t steps = 0;
    double deltaT = 0;

    while (remaining > 0)
    {
        evaluateForces(true);
        calculateVelocities();

        if (steps == 0 || travelled_ > holdsFor*moveScale())
        {
            steps = stepsFor(remaining);
            deltaT = remaining/steps;
            travelled_ = 0;
        }

        counters_.particleSteps += local_.size();
        ++counters_.steps;

        // The last step ends on the duration, free of accumulated rounding
        integrator_->step(*this, steps > 1 ? deltaT : remaining);
        remaining = steps > 1 ? remaining - deltaT : 0;
        --steps;
    }

    ranks_.agree(problem_);
    near_.takeBack(local_);
    dropAbsorbed();
}

} // End namespace plateletDynamics
