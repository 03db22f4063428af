/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "engineImplementation.H"

#include "localMobility.H"
#include "stopwatch.H"

#include <cmath>
#include <limits>

namespace plateletDynamics
{

namespace
{

void check(const engineSettings& settings)
{
    const auto require =
        []
        (
            bool valid,
            const char* name,
            double value,
            const std::string& what,
            const char* unit = ""
        )
        {
            if (!std::isfinite(value) || !valid)
            {
                throw userError
                (
                    text(name, " is ", value, unit, " but must be ", what)
                );
            }
        };

    require
    (
        std::isgreaterequal(settings.thickness, 0),
        "thickness", settings.thickness, "0 or more", " lengths"
    );
    require
    (
        std::isgreater(settings.cutOff, settings.thickness),
        "cutOff", settings.cutOff,
        "greater than the thickness of " + lengths(settings.thickness),
        " lengths"
    );
    require
    (
        std::isgreaterequal(settings.skin, 0),
        "skin", settings.skin, "positive, or 0 to have it chosen", " lengths"
    );
    require
    (
        std::isgreaterequal(settings.deltaT, 0),
        "deltaT", settings.deltaT, "positive, or 0 to have it chosen", " times"
    );
    require
    (
        std::isgreater(settings.tableTolerance, 0),
        "tableTolerance", settings.tableTolerance, "positive"
    );
    require
    (
        std::isgreaterequal(settings.thermalEnergy, 0),
        "thermalEnergy", settings.thermalEnergy, "0 or more"
    );
    require
    (
        std::isgreaterequal(settings.thermalStep, 0),
        "thermalStep", settings.thermalStep, "positive, or 0 for any",
        " lengths"
    );
    if (!isFinite(settings.bodyForce))
    {
        throw userError("bodyForce must be finite");
    }
}

} // End namespace


engine::implementation::implementation
(
    const periodicBox& space,
    const boundarySurface& limits,
    std::shared_ptr<const gapForce> force,
    const engineSettings& settings,
    MPI_Comm communicator
)
:
    space_(space),
    limits_(limits),
    settings_(settings),
    ranks_(communicator),
    integrator_(integrator::New(settings)),
    mobility_(std::make_unique<localMobility>()),
    loops_(vectorLoops::choose(settings.instructions)),
    near_(ranks_, space_, limits_, loops_)
{
    change(std::move(force), settings);
}


void engine::implementation::change
(
    std::shared_ptr<const gapForce> force,
    const engineSettings& settings
)
{
    plateletDynamics::check(settings);

    if
    (
        settings.integrator != settings_.integrator
     || settings.thermalEnergy != settings_.thermalEnergy
     || settings.seed != settings_.seed
    )
    {
        // Random numbers go on where they were, lest a path repeats itself
        draws_ = integratorMemory().back();
        settings_ = settings;
        integrator_ = integrator::New(settings);
        setIntegratorMemory({draws_});
        local_.previousStep.assign(local_.size(), 0);
    }
    settings_ = settings;
    clearChoice();

    force_ = std::make_unique<taperedForce>
    (
        std::move(force), settings_.thickness, settings_.cutOff
    );
    kernel_ = pairKernel::New(*force_, settings_, loops_);
    near_.setRange(settings_.cutOff, force_->wallCutOff(), settings_.skin);
    listsExpire();
}


std::vector<double> engine::implementation::integratorMemory() const
{
    std::vector<double> memory(integrator_->memory());

    // The memory of random motion is the number of its draws
    if (!isRandom())
    {
        memory.push_back(draws_);
    }
    return memory;
}


void engine::implementation::setIntegratorMemory
(
    const std::vector<double>& memory
)
{
    if (memory.empty())
    {
        return;
    }
    draws_ = memory.back();
    integrator_->remember
    (
        isRandom() ? std::vector<double>{draws_}
      : std::vector<double>(memory.begin(), memory.end() - 1)
    );
}


void engine::implementation::check(const platelets& loaded) const
{
    const std::size_t n = loaded.size();

    for
    (
        const std::size_t size :
        {
            loaded.tag.size(), loaded.position.size(),
            loaded.waterVelocity.size(), loaded.friction.size(),
            loaded.fixed.size(), loaded.previousVelocity.size(),
            loaded.previousStep.size(), loaded.crossings.size(),
            loaded.mobilitySlope.empty() ? n : loaded.mobilitySlope.size()
        }
    )
    {
        if (size != n)
        {
            throw userError("The arrays of the platelets differ in length");
        }
    }

    for (std::size_t k = 0; k < n; ++k)
    {
        bool outside = !isFinite(loaded.position[k]);
        for (int axis = 0; axis < 3 && !outside; ++axis)
        {
            outside =
                space_.periodic[axis]
             && std::abs(loaded.position[k][axis] - space_.lower[axis])
              > 1e6*space_.period(axis);
        }
        if (outside)
        {
            throw userError
            (
                text
                (
                    "Platelet ", loaded.id[k], " is at (",
                    lengths(loaded.position[k].x()), ", ",
                    lengths(loaded.position[k].y()), ", ",
                    lengths(loaded.position[k].z()), "), far from the box"
                )
            );
        }
        if
        (
            !std::isfinite(loaded.friction[k])
         || loaded.friction[k] <= 0
        )
        {
            throw userError
            (
                text
                (
                    "Platelet ", loaded.id[k], " has a friction of ",
                    frictions(loaded.friction[k]), " but it must be positive"
                )
            );
        }
    }

    std::vector<std::int64_t> ids(loaded.id);
    std::sort(ids.begin(), ids.end());
    const auto twin = std::adjacent_find(ids.begin(), ids.end());

    if (twin != ids.end())
    {
        throw userError(text("Two platelets have the id ", *twin));
    }
}


void engine::implementation::load(platelets&& loaded)
{
    std::string problem;
    try
    {
        check(loaded);
    }
    catch (const userError& error)
    {
        problem = error.what();
    }
    ranks_.agree(problem);

    local_ = std::move(loaded);
    local_.force.assign(local_.size(), vector::Zero());
    local_.velocity.assign(local_.size(), vector::Zero());
    local_.crossings.assign(local_.size(), {0, 0, 0});
    clearChoice();
    problem_.clear();
    departures_.clear();
    stepStart_.clear();

    near_.forget();
    listsExpire();
}


void engine::implementation::listsExpire()
{
    near_.noteSkinUse();
    near_.expire();
    forcesHold_ = false;
    stiffnessHolds_ = false;
}


void engine::implementation::setCountedSurfaces
(
    const std::vector<countedSurface>& surfaces
)
{
    surfaces_ = surfaceCounters(surfaces, space_, settings_.cutOff);

    // They are listed with the platelets
    listsExpire();
}


void engine::implementation::evaluateForces(bool maySort)
{
    if (forcesHold_)
    {
        return;
    }

    double moved = std::sqrt(movedSquared_);
    if (near_.update(local_, maySort, problem_, moved))
    {
        ++counters_.rebuilds;
        surfaces_.list(near_.points(), 2*near_.skin(), 0.5*near_.skin());
    }
    travelled_ += moved;
    movedSquared_ = 0;

    pairKernel::events met;
    local_.force.assign(local_.size(), settings_.bodyForce);

    const auto addForces = [&](const std::vector<int>& rows)
    {
        const stopwatch watch(counters_.forceSeconds);
        kernel_->addForces
        (
            near_.points(), near_.pairs(), rows, local_.force, met
        );
    };

    // While the ghosts are on their way
    addForces(near_.pairs().interior());
    near_.finish();
    addForces(near_.pairs().boundary());
    {
        const stopwatch watch(counters_.forceSeconds);
        kernel_->finishForces(near_.points(), local_.force);
    }

    if (met.coincidence && problem_.empty())
    {
        problem_ = text
        (
            "Platelets ", met.coincident[0], " and ", met.coincident[1],
            " are at the same place: their force has no direction. Move one of"
            " them, however little"
        );
    }

    counters_.contacts += met.contacts;
    counters_.contacts += near_.onWalls().addForces
    (
        near_.walls(), near_.points(), *force_, local_.force
    );
    ++counters_.evaluations;
    counters_.particleSteps += std::int64_t(local_.size());
    forcesHold_ = true;
    stiffnessHolds_ = false;
}


void engine::implementation::calculateVelocities()
{
    const std::string problem(mobility_->calculateVelocities(local_));
    if (problem_.empty())
    {
        problem_ = problem;
    }
}


void engine::implementation::evaluateAll()
{
    evaluateForces(true);
    calculateVelocities();
    ranks_.agree(problem_);
}


double engine::implementation::stiffness()
{
    evaluateAll();

    if (!stiffnessHolds_)
    {
        const stopwatch timing(counters_.stiffnessSeconds);
        std::vector<springs> all(local_.size(), springs::Zero());
        local_.nearest.assign
        (
            local_.size(), settings_.cutOff*settings_.cutOff
        );
        kernel_->addStiffness
        (
            near_.points(), near_.pairs(), all, local_.nearest
        );
        for (double& distance : local_.nearest)
        {
            distance = std::sqrt(distance);
        }
        near_.onWalls().addStiffness
        (
            near_.walls(), near_.points(), *force_, all
        );
        stiffness_ = ranks_.max(mobility_->decayRateBound(local_, all));
        stiffnessHolds_ = true;
        ++counters_.stiffnessEvaluations;
    }
    return stiffness_;
}


double engine::implementation::virial()
{
    evaluateAll();

    return ranks_.sum(kernel_->virial(near_.points(), near_.pairs()));
}


const engineCounters& engine::implementation::counters()
{
    counters_.listedPairs = near_.pairs().pairs();
    counters_.listSeconds = near_.listSeconds();
    counters_.haloSeconds = near_.haloSeconds();

    return counters_;
}

} // End namespace plateletDynamics
