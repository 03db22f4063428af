/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "suspensionBox.H"
#include "asFatalError.H"
#include "errorAt.H"

#include <random>

const Foam::Enum<Foam::suspensionBox::arrangement>
Foam::suspensionBox::arrangementNames
({
    { arrangement::random, "random" },
    { arrangement::lattice, "lattice" },
    { arrangement::stack, "stack" },
});

namespace
{

using namespace Foam;

//- Platelets that are placed at random are no nearer than this, in spacings:
//  they fill a tenth of what is possible, and forces are not huge
constexpr scalar nearestPlaces = 0.6;

//- Samples per time of diffusion over a spacing, those until equilibrium, and
//  how many there are before the error is looked at, and again
constexpr label samplesPerTime = 100;
constexpr label equilibration = 100;
constexpr label leastSamples = 128;

//- Blocks below which their scatter says nothing
constexpr label leastBlocks = 16;

//- A lattice at rest has no noise, but single precision would be some
plateletDynamics::engineSettings settingsOf
(
    const clayInteractions& interactions,
    const scalar spacing,
    const bool moving,
    const label seed
)
{
    plateletDynamics::engineSettings settings(interactions.engineAt(spacing));
    if (!moving)
    {
        settings.pairKernel = plateletDynamics::engineSettings::kernel::exact;
    }
    settings.seed += seed;
    return settings;
}

} // End anonymous namespace


Foam::scalar Foam::suspensionBox::spacingAt
(
    const clayInteractions& interactions,
    const scalar fraction,
    const arrangement how
)
{
    return
        how == arrangement::stack
      ? interactions.thickness()/fraction
      : Foam::cbrt(interactions.parcelVolume()/fraction);
}


Foam::suspensionBox::suspensionBox
(
    const clayInteractions& interactions,
    const scalar time,
    const scalar fraction,
    const scalar fractionOfCutOff,
    const arrangement how,
    const label atLeast,
    const label seed
)
:
    units_(interactions.units()),
    properties_(interactions.properties()),
    arrangement_(how),
    diffusionTime_(0)
{
    const bool moving = how == arrangement::random;
    const bool inRow = how == arrangement::stack;

    const plateletDynamics::engineSettings settings
    (
        settingsOf
        (
            interactions,
            spacingAt(interactions, fractionOfCutOff, how),
            moving,
            seed
        )
    );
    const scalar spacing = spacingAt(interactions, fraction, how);

    // Two cut-offs and a little wide
    const scalar room = 2.02*settings.cutOff*units_.length()/spacing;

    if ((inRow ? room : pow3(room)) > mostPlatelets)
    {
        colloid::errorAt
        (
            properties_.dict().subOrEmptyDict("solution"), "cutOff"
        )
            << "At the solid fraction " << fraction << " the cut-off of "
            << settings.cutOff*units_.length() << " m is "
            << room/2.02 << " spacings: two of them need a box of more than "
            << mostPlatelets << " platelets." << nl
            << "    Say cutOff auto (clayCloudProperties), or leave out the"
            << " method equilibrium" << exit(FatalIOError);
    }

    edgeNumber_ = label(std::ceil(max(room, Foam::cbrt(scalar(atLeast)))));
    number_ =
        inRow ? max(atLeast, label(std::ceil(room)))
      : moving ? max(atLeast, label(std::ceil(pow3(room))))
      : edgeNumber_*edgeNumber_*edgeNumber_;

    volume_ = number_*interactions.parcelVolume()/fraction;
    thermalEnergy_ = settings.thermalEnergy*units_.force()*units_.length();

    // A row is open to its sides
    const vector size
    (
        inRow ? vector(number_*spacing, 0, 0)
      : vector::uniform(Foam::cbrt(volume_))
    );
    plateletDynamics::periodicBox space;
    for (direction axis = 0; axis < 3; ++axis)
    {
        space.periodic[axis] = size[axis] > 0;
        space.upper[axis] = size[axis]/units_.length();
    }

    const scalar friction = interactions.friction(fraction);
    if (moving)
    {
        diffusionTime_ = sqr(spacing)*friction/thermalEnergy_;
    }

    plateletDynamics::platelets loaded;
    for (const point& place : places(size, seed))
    {
        loaded.append(loaded.size(), reduced(place, units_.length()));
        loaded.friction.back() = friction/units_.friction();
    }

    asFatalError
    (
        units_,
        properties_,
        [&]
        {
            engine_ = std::make_unique<plateletDynamics::engine>
            (
                space,
                plateletDynamics::boundarySurface(),
                interactions.force(time),
                settings,
                MPI_COMM_SELF
            );
            engine_->load(std::move(loaded));
        }
    );
}


Foam::pointField Foam::suspensionBox::places
(
    const vector& size,
    const label seed
) const
{
    pointField result(number_);

    if (arrangement_ != arrangement::random)
    {
        const label n =
            arrangement_ == arrangement::stack ? number_ : edgeNumber_;
        forAll(result, i)
        {
            const vector cell(i%n, i/n%n, i/(n*n));
            result[i] = cmptMultiply(cell + 0.5*vector::one, size)/n;
        }
        return result;
    }

    std::mt19937_64 random(seed);
    const auto uniform = [&]
    {
        return std::ldexp(scalar(random() >> 11), -53);
    };
    const scalar nearest = nearestPlaces*Foam::cbrt(volume_/number_);

    for (label placed = 0; placed < number_;)
    {
        const scalar x = uniform();
        const scalar y = uniform();
        const point place(cmptMultiply(size, vector(x, y, uniform())));

        bool free = true;
        for (label i = 0; i < placed && free; ++i)
        {
            vector apart(place - result[i]);
            for (direction axis = 0; axis < 3; ++axis)
            {
                apart[axis] -= size[axis]*std::round(apart[axis]/size[axis]);
            }
            free = magSqr(apart) > sqr(nearest);
        }
        if (free)
        {
            result[placed++] = place;
        }
    }
    return result;
}


void Foam::suspensionBox::advance(const scalar duration)
{
    asFatalError
    (
        units_, properties_, [&]{ engine_->advance(duration/units_.time()); }
    );
}


Foam::scalar Foam::suspensionBox::pressure()
{
    const label directions = arrangement_ == arrangement::stack ? 1 : 3;
    const scalar virial =
        asFatalError
        (
            units_, properties_, [&]{ return engine_->virial(); }
        )
       *units_.force()*units_.length();

    return (number_*thermalEnergy_ + virial/directions)/volume_;
}


Foam::scalar Foam::suspensionBox::standardError(const UList<scalar>& samples)
{
    scalar largest = 0;

    for
    (
        label size = 1;
        samples.size()/size >= leastBlocks;
        size *= 2
    )
    {
        const label blocks = samples.size()/size;
        scalarField means(blocks, Zero);
        forAll(means, block)
        {
            for (label i = 0; i < size; ++i)
            {
                means[block] += samples[block*size + i]/size;
            }
        }
        largest = max
        (
            largest,
            Foam::sqrt
            (
                sum(magSqr(means - average(means)))/(blocks*(blocks - 1.0))
            )
        );
    }
    return largest;
}


Foam::suspensionBox::estimate Foam::suspensionBox::sample
(
    const scalar accuracy,
    const label mostSteps
)
{
    if (arrangement_ != arrangement::random)
    {
        return {pressure(), 0, scalar(number_), 0};
    }

    const scalar interval = diffusionTime_/samplesPerTime;
    advance(equilibration*interval);

    DynamicList<scalar> samples;
    while (true)
    {
        for (label i = 0; i < leastSamples; ++i)
        {
            advance(interval);
            samples.append(pressure());
        }
        const scalar mean = average(samples);
        const scalar error = standardError(samples);
        const scalar steps = engine_->counters().steps;

        if (error <= accuracy*mag(mean) || steps >= mostSteps)
        {
            return {mean, error, scalar(number_), steps};
        }
    }
}
