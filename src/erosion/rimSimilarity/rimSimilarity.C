/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimSimilarity.H"
#include "caseFile.H"
#include "errorAt.H"
#include "error.H"
#include "interpolateXY.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Gauss: places in (0, 1) and weights
constexpr label points = 3;
const scalar place[points] =
{
    0.5 - 0.5*std::sqrt(0.6), 0.5, 0.5 + 0.5*std::sqrt(0.6)
};
const scalar weight[points] = {5.0/18, 8.0/18, 5.0/18};

constexpr label maxIterations = 200;

// Part of the most that a Newton step may take q towards 0
constexpr scalar towardsZero = 0.9;


scalar positive
(
    const char* what,
    const std::function<scalar(scalar)>& law,
    const scalar fraction
)
{
    const scalar value = law(fraction);

    if (!(value > 0) || !std::isfinite(value))
    {
        colloid::errorAt
        (
            colloid::caseFile(fileName("constant/clayProperties")),
            wordList({"water", "concentration"})
        )
            << what << " is " << value << " at the solid fraction " << fraction
            << ", and a rim needs it above 0 there" << nl
            << "D < 0 is where clay coagulates: a lower concentration or"
            << " Hamaker, or a" << nl
            << "higher surfaceCharge, lets it spread. clayScales prints the"
            << " limit (CCC)" << nl
            << exit(FatalIOError);
    }

    return value;
}


// 1/q averaged where q is linear between two values
scalar meanInverse(const scalar a, const scalar b)
{
    const scalar difference = b/a - 1;

    return
    (
        mag(difference) < 1e-4
      ? 1 - difference/2 + difference*difference/3
      : std::log1p(difference)/difference
    )/a;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::rimSimilarity::solve
(
    const scalarField& stiffness,
    const scalarField& source
)
{
    const label n = fractions_.size() - 1;

    // What is to be least; ln q over its first guess, to keep digits
    scalarField guess(n + 1, 0);
    const auto energy = [&](const scalarField& q)
    {
        scalar sum = 0;
        for (label i = 1; i <= n; ++i)
        {
            const scalar step = q[i] - q[i - 1];
            sum += 0.5*stiffness[i - 1]*step*step
                 - 2*source[i]*std::log(q[i]/guess[i]);
        }
        return sum;
    };

    // A straight line, with the factor that makes the energy least
    scalar bending = 0;
    for (label i = 1; i <= n; ++i)
    {
        const scalar step = fractions_[i] - fractions_[i - 1];
        bending += stiffness[i - 1]*step*step;
    }
    guess = fractions_;
    guess *= std::sqrt(2*sum(source)/bending);
    flux_ = guess;

    scalar least = energy(flux_);
    scalarField diagonal(n + 1), change(n + 1, 0);

    for (label iteration = 0; iteration < maxIterations; ++iteration)
    {
        // Newton's equations, eliminated from phi = 0 up
        for (label i = 1; i <= n; ++i)
        {
            const scalar below = stiffness[i - 1];
            const scalar above = i < n ? stiffness[i] : 0;

            diagonal[i] =
                below + above + 2*source[i]/(flux_[i]*flux_[i]);
            change[i] =
                2*source[i]/flux_[i] - below*(flux_[i] - flux_[i - 1])
              + (i < n ? above*(flux_[i + 1] - flux_[i]) : 0);

            if (i > 1)
            {
                diagonal[i] -= below*below/diagonal[i - 1];
                change[i] += below*change[i - 1]/diagonal[i - 1];
            }
        }

        scalar largest = 0;
        scalar factor = 1;
        for (label i = n; i > 0; --i)
        {
            if (i < n)
            {
                change[i] += stiffness[i]*change[i + 1];
            }
            change[i] /= diagonal[i];

            const scalar relative = change[i]/flux_[i];
            largest = max(largest, mag(relative));
            if (relative < -towardsZero)
            {
                factor = min(factor, -towardsZero/relative);
            }
        }

        if (largest < 1e-10)
        {
            return;
        }

        // Until it helps; round-off near the solution does not count
        for (label halving = 0; ; ++halving)
        {
            scalarField tried(flux_);
            for (label i = 1; i <= n; ++i)
            {
                tried[i] += factor*change[i];
            }
            const scalar value = energy(tried);

            if
            (
                value <= least + 1e-12*mag(least) + VSMALL
             || halving == 40
            )
            {
                flux_ = tried;
                least = value;
                break;
            }
            factor /= 2;
        }
    }

    FatalErrorInFunction
        << "The rim's profile was not found in " << maxIterations
        << " iterations, edge's fraction " << fractions_[n] << nl
        << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rimSimilarity::rimSimilarity
(
    const form equation,
    const laws& matter,
    const scalar edgeFraction,
    const label intervals
)
:
    fractions_(intervals + 1),
    flux_(intervals + 1, 0),
    distances_(intervals + 1, 0)
{
    if (!(edgeFraction > 0 && edgeFraction < 1) || intervals < 2)
    {
        FatalErrorInFunction
            << "A rim's edge with the solid fraction " << edgeFraction
            << ", " << intervals << " intervals" << nl
            << "Valid: above 0 and below 1, two intervals or more" << nl
            << exit(FatalError);
    }

    const scalar flowing = min(edgeFraction, matter.flowFraction);

    forAll(fractions_, i)
    {
        const scalar part = scalar(i)/intervals;
        fractions_[i] = flowing*part*part*part;
    }

    scalarField stiffness(intervals), source(intervals + 1, 0);
    scalarField conductance(intervals, 0);

    for (label i = 0; i < intervals; ++i)
    {
        const scalar width = fractions_[i + 1] - fractions_[i];
        scalar resistance = 0;

        for (label k = 0; k < points; ++k)
        {
            const scalar phi = fractions_[i] + place[k]*width;
            const scalar D =
                positive("D", matter.diffusivity, phi)/matter.freeDiffusivity;
            const scalar eta =
                positive("The viscosity", matter.viscosity, phi);

            const bool conserves = equation == form::conservative;
            const scalar part = weight[k]*width*(conserves ? D/eta : D);

            resistance += weight[k]*(conserves ? 1 : 1/eta);
            source[i] += part*(1 - place[k]);
            source[i + 1] += part*place[k];
            conductance[i] += weight[k]*width*D;
        }

        stiffness[i] = 1/(resistance*width);
    }

    solve(stiffness, source);
    edgeLoss_ = flux_.last();

    // z of phi, dz = -D_r dphi/q
    distances_.last() = 0;
    for (label i = intervals - 1; i > 0; --i)
    {
        distances_[i] =
            distances_[i + 1]
          + conductance[i]*meanInverse(flux_[i], flux_[i + 1]);
    }

    distances_[0] = GREAT;

    if (flowing < edgeFraction)
    {
        // The layer that only conducts, before the rest
        const label layers = 50;
        const scalar width = (edgeFraction - flowing)/layers;

        scalarField above(layers), into(layers);
        scalar depth = 0;
        forAll(above, i)
        {
            for (label k = 0; k < points; ++k)
            {
                depth += weight[k]*width
                   *positive
                    (
                        "D",
                        matter.diffusivity,
                        flowing + (i + place[k])*width
                    )/matter.freeDiffusivity/edgeLoss_;
            }
            above[i] = flowing + (i + 1)*width;
            into[i] = -depth;
        }

        fractions_.append(above);
        distances_.append(into);
        flux_.append(scalarField(layers, edgeLoss_));

        for (label i = 1; i < distances_.size(); ++i)
        {
            distances_[i] += depth;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::rimSimilarity::distance(const scalar fraction) const
{
    // Between phi = 0, infinitely far, and the next fraction there is nothing
    return
        fraction < fractions_[1] ? GREAT
      : interpolateXY(fraction, fractions_, distances_);
}


Foam::scalar Foam::rimSimilarity::fraction(const scalar distance) const
{
    if (distance >= distances_[1])
    {
        return 0;
    }

    // z falls with phi
    label below = 1, above = distances_.size() - 1;
    while (above - below > 1)
    {
        const label middle = (below + above)/2;
        (distances_[middle] > distance ? below : above) = middle;
    }

    const scalar part =
        (distances_[below] - distance)
       /(distances_[below] - distances_[above]);

    return
        fractions_[below]
      + min(part, scalar(1))*(fractions_[above] - fractions_[below]);
}


// ************************************************************************* //
