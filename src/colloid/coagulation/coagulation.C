/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coagulation.H"
#include "constantFriction.H"
#include "diffusivity.H"

#include <cmath>
#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using colloid::coagulation;

// Scan of the solid fraction in steps of 3 %; the wells of D are wider
constexpr scalar leastFraction = 1e-6;
constexpr scalar greatestFraction = 0.9;
constexpr label nFractions = 500;

constexpr scalar leastConcentration = 1e-4;
constexpr scalar greatestConcentration = 6000;


scalar fractionAt(const scalar i)
{
    return
        leastFraction
       *std::pow(greatestFraction/leastFraction, i/(nFractions - 1));
}


// Position of the minimum of f in [a, b] by golden section
scalar minimum
(
    const std::function<scalar(scalar)>& f,
    scalar a,
    scalar b
)
{
    const scalar golden = 0.5*(std::sqrt(5.0) - 1);

    scalar x = b - golden*(b - a);
    scalar y = a + golden*(b - a);
    scalar fx = f(x);
    scalar fy = f(y);

    for (label i = 0; i < 60; ++i)
    {
        if (fx < fy)
        {
            b = y;
            y = x;
            fy = fx;
            x = b - golden*(b - a);
            fx = f(x);
        }
        else
        {
            a = x;
            x = y;
            fx = fy;
            y = a + golden*(b - a);
            fy = f(y);
        }
    }

    return 0.5*(a + b);
}


// Position of the sign change of f between a and b by bisection
scalar root(const std::function<scalar(scalar)>& f, scalar a, scalar b)
{
    const bool negativeAtA = f(a) < 0;

    for (label i = 0; i < 60; ++i)
    {
        const scalar middle = 0.5*(a + b);

        ((f(middle) < 0) == negativeAtA ? a : b) = middle;
    }

    return 0.5*(a + b);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::coagulation::coagulation
(
    const clayProperties& properties,
    const dictionary& doubleLayerModel
)
:
    properties_(properties),
    model_(doubleLayerModel),
    water_(properties.waterAt(0))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::colloid::coagulation::extreme Foam::colloid::coagulation::least
(
    const scalar concentration
) const
{
    water solution(water_);
    solution.concentration = concentration;

    const diffusivity D
    (
        properties_.clay(),
        solution,
        properties_.newDoubleLayer(model_, solution)(),
        constantFriction(1)
    );

    const auto atIndex = [&](const scalar i)
    {
        return D.timesFriction(fractionAt(i));
    };

    // The least one so far is kept at each new greatest one: it lies on the
    // dilute side of the barrier
    label leastSoFar = 0;
    label leastBeforeBarrier = 0;
    scalar leastValue = atIndex(0);
    bool hasBarrier = false;

    // A rise above free diffusion, and by more than rounding
    scalar barrier = 1.001*solution.thermalEnergy();

    for (label i = 1; i < nFractions; ++i)
    {
        const scalar value = atIndex(i);

        if (value < leastValue)
        {
            leastValue = value;
            leastSoFar = i;
        }

        if (value > barrier)
        {
            barrier = value;
            leastBeforeBarrier = leastSoFar;
            hasBarrier = true;
        }
    }

    // No barrier: attraction at every spacing that matters
    if (!hasBarrier)
    {
        leastBeforeBarrier = leastSoFar;
    }

    const scalar i = minimum
    (
        atIndex,
        max(leastBeforeBarrier - 1, 0),
        min(leastBeforeBarrier + 1, nFractions - 1)
    );

    extreme found;
    found.value = atIndex(i);
    found.fraction = fractionAt(i);

    return found;
}


Foam::colloid::coagulation::criticalState
Foam::colloid::coagulation::critical() const
{
    const auto atLogarithm = [&](const scalar logarithm)
    {
        return least(std::exp(logarithm)).value;
    };

    const scalar first = std::log(leastConcentration);
    const scalar last = std::log(greatestConcentration);
    const label nSteps = 100;

    criticalState state;
    scalar lower = first;

    for (label i = 0; i <= nSteps; ++i)
    {
        const scalar upper = first + i*(last - first)/nSteps;

        if (atLogarithm(upper) < 0)
        {
            const scalar critical =
                i == 0 ? first : root(atLogarithm, lower, upper);

            state.found = true;
            state.concentration = std::exp(critical);
            state.fraction = least(state.concentration).fraction;
            break;
        }

        lower = upper;
    }

    return state;
}


Foam::colloid::coagulation::range Foam::colloid::coagulation::negative
(
    const scalar concentration
) const
{
    range between;

    const extreme bottom(least(concentration));

    if (bottom.value >= 0)
    {
        return between;
    }

    water solution(water_);
    solution.concentration = concentration;

    const diffusivity D
    (
        properties_.clay(),
        solution,
        properties_.newDoubleLayer(model_, solution)(),
        constantFriction(1)
    );

    const auto atLogarithm = [&](const scalar logarithm)
    {
        return D.timesFriction(std::exp(logarithm));
    };

    const scalar middle = std::log(bottom.fraction);
    const scalar step =
        std::log(greatestFraction/leastFraction)/(nFractions - 1);

    // D is kT/xi where platelets are far apart
    scalar lower = middle;
    while (atLogarithm(lower) < 0)
    {
        lower -= step;
    }

    between.found = true;
    between.lower = std::exp(root(atLogarithm, lower, lower + step));
    between.upper = greatestFraction;

    for
    (
        scalar upper = middle;
        upper < std::log(greatestFraction);
        upper += step
    )
    {
        if (atLogarithm(upper) >= 0)
        {
            between.upper = std::exp(root(atLogarithm, upper - step, upper));
            break;
        }
    }

    return between;
}


// ************************************************************************* //
