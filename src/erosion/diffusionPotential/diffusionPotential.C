/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusionPotential.H"

namespace
{

constexpr int tablesPerDecade = 40;

} // End anonymous namespace


Foam::diffusionPotential::diffusionPotential
(
    const dictionary& diffusivityDict,
    const colloid::clayProperties& matter,
    const scalar largestFraction
)
:
    model_(fractionDiffusivity::New(diffusivityDict, matter)),
    largest_(largestFraction),
    water_(matter.waterAt(0)),
    uniform_(0)
{
    model_->warnBeyond(largest_);
    setUniform(water_.concentration);
}


const Foam::potentialInWater& Foam::diffusionPotential::table
(
    const int number
) const
{
    auto& entry = tables_[number];

    if (!entry)
    {
        colloid::water solution(water_);
        solution.concentration =
            uniform_ > 0
          ? uniform_
          : std::pow(10.0, scalar(number)/tablesPerDecade);

        entry.reset(new potentialInWater(*model_, solution, largest_));
    }
    return *entry;
}


void Foam::diffusionPotential::setUniform(const scalar concentration)
{
    if (concentration != uniform_)
    {
        tables_.clear();
        uniform_ = concentration;
    }
}


void Foam::diffusionPotential::setVarying()
{
    // A model that does not follow it keeps its one table
    if (model_->followsConcentration() && uniform_ > 0)
    {
        tables_.clear();
        uniform_ = 0;
    }
}


Foam::diffusionPotential::atConcentration
Foam::diffusionPotential::at(const scalar concentration) const
{
    if (uniform_ > 0)
    {
        return {table(0), table(0), 0};
    }

    const scalar place = tablesPerDecade*std::log10(max(concentration, 1e-6));
    const int number = int(std::floor(place));

    return {table(number), table(number + 1), place - number};
}
