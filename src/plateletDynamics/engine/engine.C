/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "engine.H"

#include "engineImplementation.H"

namespace plateletDynamics
{

engine::engine
(
    const periodicBox& space,
    const boundarySurface& limits,
    std::shared_ptr<const gapForce> force,
    const engineSettings& settings,
    MPI_Comm communicator
)
:
    implementation_
    (
        std::make_unique<implementation>
        (
            space, limits, std::move(force), settings, communicator
        )
    )
{}


engine::~engine() = default;


void engine::load(platelets newPlatelets)
{
    implementation_->load(std::move(newPlatelets));
}


platelets& engine::local()
{
    return implementation_->local();
}


const platelets& engine::local() const
{
    return implementation_->local();
}


void engine::advance(double duration)
{
    implementation_->advance(duration);
}


void engine::clearCrossings()
{
    auto& crossings = implementation_->local().crossings;
    crossings.assign(crossings.size(), {0, 0, 0});
}


const std::vector<departure>& engine::departures() const
{
    return implementation_->departures();
}


void engine::setCountedSurfaces(const std::vector<countedSurface>& surfaces)
{
    implementation_->setCountedSurfaces(surfaces);
}


const std::vector<passages>& engine::counted() const
{
    return implementation_->counted();
}


void engine::listsExpire()
{
    implementation_->listsExpire();
}


void engine::change
(
    std::shared_ptr<const gapForce> force,
    const engineSettings& settings
)
{
    implementation_->change(std::move(force), settings);
}


void engine::evaluate()
{
    implementation_->evaluateAll();
}


double engine::stiffness()
{
    return implementation_->stiffness();
}


double engine::stabilityLimit()
{
    return implementation_->stabilityLimit();
}


double engine::stableDeltaT()
{
    return implementation_->stableDeltaT();
}


double engine::virial()
{
    return implementation_->virial();
}


const engineCounters& engine::counters() const
{
    return implementation_->counters();
}


double engine::skinUse() const
{
    return implementation_->near().skinUse();
}


void engine::setSkinUse(double use)
{
    implementation_->near().setSkinUse(use);
}


std::string engine::kernelName() const
{
    return implementation_->kernelName();
}


double engine::skin() const
{
    return implementation_->skin();
}


std::vector<double> engine::integratorMemory() const
{
    return implementation_->integratorMemory();
}


std::string engine::integratorName() const
{
    return implementation_->integratorName();
}


bool engine::choosesSteps() const
{
    return implementation_->choosesSteps();
}


void engine::setIntegratorMemory(const std::vector<double>& memory)
{
    implementation_->setIntegratorMemory(memory);
}

} // End namespace plateletDynamics
