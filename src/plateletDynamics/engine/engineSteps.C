/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "engineImplementation.H"

#include "stopwatch.H"

#include <cmath>
#include <limits>

namespace plateletDynamics
{

namespace
{

//- Share of the spacing that a chosen step uses
constexpr double largestMove = 0.25;

//- The step is chosen anew when a platelet may have come this far, in spacings.
//  Not when lists are made: that depends on the number of ranks
constexpr double holdsFor = 0.05;

//- The same of random motion, of what a platelet has come from where it was; and
//  over the length on which the strongest force changes, speed over rate, where
//  stiffness decides
constexpr double randomHoldsFor = 0.2;
constexpr double lengthsHeld = 3;

//- Speed over that of the stiffest motion in thermal equilibrium, sqrt(rate D),
//  beyond which platelets are far from it; and the share of the integrator's limit
//  with which they then come to rest without overshoot, from where they might not
//  return
constexpr double farFromRest = 10;
constexpr double withoutOvershoot = 0.25;

//- The same of the rate that adaptive integrators use, whose estimate of the
//  error would notice if it has grown
constexpr double rateHoldsFor = 0.2;

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
    const double rate = stiffness();

    double fastest[2] = {0, mobility_->largestEigenvalue(local_)};
    for (std::size_t k = 0; k < local_.size(); ++k)
    {
        if (!local_.fixed[k])
        {
            fastest[0] =
                std::max(fastest[0], local_.velocity[k].cwiseAbs().maxCoeff());
        }
    }
    ranks_.max(fastest, 2);

    const double diffusivity = settings_.thermalEnergy*fastest[1];
    const bool falling =
        isRandom()
     && fastest[0] > farFromRest*std::sqrt(rate*diffusivity);

    const double byStiffness =
        rate
       /(
            integrator_->realAxisLimit()
           *(falling ? withoutOvershoot : integrator_->shareOfLimit())
        );

    // (random displacement)^2 = 2 D step
    const double byNoise =
        settings_.thermalStep > 0
      ? 2*diffusivity/(settings_.thermalStep*settings_.thermalStep)
      : 0;

    holdsWithin_ = randomHoldsFor*moveScale();
    if (byStiffness > byNoise)
    {
        holdsWithin_ = std::min(holdsWithin_, lengthsHeld*fastest[0]/rate);
    }

    return inverse
    (
        std::max
        ({
            byStiffness, fastest[0]/(largestMove*moveScale()), byNoise
        })
    );
}


void engine::implementation::clearChoice()
{
    travelled_ = 0;
    local_.sinceChoice.assign
    (
        isRandom() ? local_.size() : 0, vector::Zero()
    );
}


bool engine::implementation::choiceHolds(double deltaT)
{
    if (!isRandom())
    {
        return travelled_ <= holdsFor*moveScale();
    }

    if (settings_.deltaT > 0)
    {
        return true;
    }

    double farthest[2] = {0, 0};
    for (std::size_t k = 0; k < local_.size(); ++k)
    {
        if (!local_.fixed[k])
        {
            farthest[0] =
                std::max(farthest[0], local_.sinceChoice[k].squaredNorm());
            farthest[1] =
                std::max(farthest[1], local_.velocity[k].cwiseAbs().maxCoeff());
        }
    }
    ranks_.max(farthest, 2);

    return
        std::sqrt(farthest[0]) <= holdsWithin_
     && deltaT*farthest[1] <= largestMove*moveScale();
}


void engine::implementation::noteMove(std::size_t k, const vector& d)
{
    movedSquared_ = std::max(movedSquared_, d.squaredNorm());

    if (isRandom())
    {
        local_.sinceChoice[k] += d;
    }
}


void engine::implementation::go
(
    std::size_t k,
    const boundaryCrossings::outcome& way
)
{
    const vector from(near_.points().position[k]);
    near_.displace(k, way.displacement);
    countWay(k, from, from, way.bends);
}


void engine::implementation::countWay
(
    std::size_t k,
    const vector& start,
    const vector& from,
    const std::vector<vector>& bends
)
{
    vector x(start);
    vector at(from);

    for (const vector& bend : bends)
    {
        surfaces_.count(x, bend - at, bend);
        x = at = bend;
    }
    const vector& end = near_.points().position[k];
    surfaces_.count(x, end - at, end);
}


std::int64_t engine::implementation::stepsFor(double duration, double step)
{
    if (duration/integrator::tooManySteps > step)
    {
        throw userError
        (
            text
            (
                "A duration of ", times(duration), " in steps of ",
                times(step), " would take more than ",
                integrator::tooManySteps, " steps"
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
    const bool counting = !surfaces_.empty();

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

        const vector& from = near_.points().position[k];
        const bool passing = counting && surfaces_.nearStep(k, from, d);
        if (!crossable || !near_.crossings().near(k, from, d))
        {
            noteMove(k, d);
            if (passing)
            {
                go(k, {d});
            }
            else
            {
                near_.displace(k, d);
            }
            continue;
        }

        const auto met = near_.crossings().follow(near_.walls(), from, d);
        noteMove(k, met.displacement);
        if (passing)
        {
            go(k, met);
        }
        else
        {
            near_.displace(k, met.displacement);
        }
        if (met.absorbedBy >= 0)
        {
            absorb(k, met.absorbedBy);
        }
        else if (isRandom() && met.displacement != d)
        {
            // What is still to be made of a random displacement turns too
            const vector normal((met.displacement - d).normalized());
            vector& random = local_.previousVelocity[k];
            random -= 2*random.dot(normal)*normal;
        }
    }

    forcesHold_ = false;
    stiffnessHolds_ = false;
}


void engine::implementation::evaluateAt(const std::vector<vector>& offset)
{
    offset_.resize(local_.size(), vector::Zero());

    // Once for all tries of a step: the way back leaves round-off
    if (!surfaces_.empty() && stepStart_.empty())
    {
        stepStart_.assign
        (
            near_.points().position.begin(),
            near_.points().position.begin() + local_.size()
        );
    }

    for (std::size_t k = 0; k < offset.size(); ++k)
    {
        if (local_.fixed[k])
        {
            continue;
        }

        const vector d(offset[k] - offset_[k]);
        if (!isFinite(d) || d.cwiseAbs().maxCoeff() > settings_.cutOff)
        {
            wentTooFar_ = true;
            continue;
        }
        near_.displace(k, d);
        offset_[k] = offset[k];
    }

    forcesHold_ = false;
    stiffnessHolds_ = false;
    evaluateForces(false);
    calculateVelocities();
}


double engine::implementation::errorOverTolerance
(
    const std::vector<vector>& error
)
{
    const double scale = moveScale();
    double largest = 0;
    for (std::size_t k = 0; k < error.size(); ++k)
    {
        if (!local_.fixed[k])
        {
            // In units of the local spacing, not less than the mean of the start
            const double unit =
                std::min(std::max(local_.nearest[k], scale), settings_.cutOff);
            largest = std::max(largest, error[k].norm()/unit);
        }
    }
    if (wentTooFar_)
    {
        largest = std::numeric_limits<double>::infinity();
    }
    return ranks_.max(largest)/settings_.stepTolerance;
}


void engine::implementation::accept()
{
    bool turned = false;

    for (std::size_t k = 0; k < offset_.size(); ++k)
    {
        if (local_.fixed[k])
        {
            continue;
        }
        const vector& d = offset_[k];
        movedSquared_ = std::max(movedSquared_, d.squaredNorm());

        // No history for a multistep integrator that goes on from here
        local_.previousStep[k] = 0;

        const vector from(near_.points().position[k] - d);
        const bool passing = !surfaces_.empty() && surfaces_.near(k, from, d);
        const bool crossable =
            !near_.crossings().empty() && near_.crossings().near(k, from, d);

        boundaryCrossings::outcome met{d};
        if (crossable)
        {
            met = near_.crossings().follow(near_.walls(), from, d);
        }
        if (met.absorbedBy >= 0 || met.displacement != d)
        {
            near_.displace(k, met.displacement - d);
            turned = true;
        }
        if (passing)
        {
            countWay(k, stepStart_[k], from, met.bends);
        }
        if (met.absorbedBy >= 0)
        {
            absorb(k, met.absorbedBy);
        }
    }
    offset_.clear();
    stepStart_.clear();

    // Forces were calculated where all are but those that turned
    if (ranks_.max(turned))
    {
        forcesHold_ = false;
        stiffnessHolds_ = false;
    }
}


void engine::implementation::back()
{
    for (std::size_t k = 0; k < offset_.size(); ++k)
    {
        if (!local_.fixed[k])
        {
            near_.displace(k, -offset_[k]);
        }
    }
    offset_.clear();
    wentTooFar_ = false;
    forcesHold_ = false;
    stiffnessHolds_ = false;
}


double engine::implementation::decayRate()
{
    if (decayRate_ < 0 || travelled_ > rateHoldsFor*moveScale())
    {
        decayRate_ = stiffness();
        travelled_ = 0;
    }
    return decayRate_;
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
        throw userError(text("Cannot advance by a time of ", times(duration)));
    }

    departures_.clear();
    surfaces_.clear();

    double remaining = duration;
    std::int64_t steps = 0;
    double deltaT = 0;
    decayRate_ = -1;

    while (remaining > 0)
    {
        if (integrator_->isAdaptive() && near_.isUntidy())
        {
            listsExpire();
        }
        evaluateForces(true);
        calculateVelocities();

        const double asked = settings_.deltaT;

        if (integrator_->isAdaptive())
        {
            deltaT = remaining;
            if (asked > 0)
            {
                stepsFor(remaining, asked);
                deltaT = std::min(asked, remaining);
            }
        }
        else
        {
            if (steps == 0 || !choiceHolds(deltaT))
            {
                steps =
                    stepsFor(remaining, asked > 0 ? asked : stableDeltaT());
                deltaT = remaining/steps;
                clearChoice();
            }

            // The last step ends on the duration, free of accumulated rounding
            deltaT = steps > 1 ? deltaT : remaining;
            --steps;
        }

        ++counters_.steps;

        double moving = 0;
        double& seconds = isRandom() ? counters_.randomSeconds : moving;
        const stopwatch watch(seconds);
        const double taken = integrator_->step(*this, deltaT);
        remaining = taken < remaining ? remaining - taken : 0;
    }

    ranks_.agree(problem_);
    near_.takeBack(local_);
    dropAbsorbed();
}

} // End namespace plateletDynamics
