/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "automatic.H"

namespace plateletDynamics
{

namespace
{

//- Steps in a row after which the other integrator takes over
constexpr int inARow = 5;

//- Stages of RKC2 at which the other is not held up by its stability
constexpr int fewStages = 2;

//- Share of the longest step that shows that this is what holds it up
constexpr double heldUp = 0.7;

} // End namespace


double automatic::attempt
(
    motion& system,
    const std::vector<vector>& start,
    double deltaT
)
{
    const bool better =
        isStiff_
      ? chebyshev2::stagesFor(deltaT, system.decayRate()) <= fewStages
      : deltaT > heldUp*longestStep(system);

    otherIsBetter_ = better ? otherIsBetter_ + 1 : 0;
    const double error =
        isStiff_
      ? stiff_.attempt(system, start, deltaT)
      : smooth_.attempt(system, start, deltaT);

    if (otherIsBetter_ == inARow)
    {
        isStiff_ = !isStiff_;
        otherIsBetter_ = 0;
    }
    return error;
}


std::vector<double> automatic::memory() const
{
    std::vector<double> all(adaptiveIntegrator::memory());
    all.push_back(isStiff_);
    all.push_back(otherIsBetter_);
    return all;
}


void automatic::remember(const std::vector<double>& memory)
{
    if (memory.size() == this->memory().size())
    {
        adaptiveIntegrator::remember({memory.begin(), memory.end() - 2});
        isStiff_ = memory[memory.size() - 2] > 0;
        otherIsBetter_ = int(memory.back());
    }
}

} // End namespace plateletDynamics
