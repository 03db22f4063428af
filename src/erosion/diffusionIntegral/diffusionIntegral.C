/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusionIntegral.H"
#include "caseFile.H"
#include "errorAt.H"
#include "error.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::diffusionIntegral::interval(const scalar fraction) const
{
    const label above =
        std::upper_bound(fractions_.begin(), fractions_.end(), fraction)
      - fractions_.begin();

    return min(max(above - 1, label(0)), fractions_.size() - 2);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::diffusionIntegral::diffusionIntegral
(
    const std::function<scalar(scalar)>& diffusivity,
    const scalar edgeFraction,
    const scalar highestFraction,
    const label intervals
)
:
    fractions_(intervals + 1),
    integral_(intervals + 1, 0),
    D_(intervals + 1)
{
    if (!(edgeFraction > 0 && edgeFraction < highestFraction))
    {
        FatalErrorInFunction
            << "A gel from the solid fraction " << highestFraction
            << " down to that of its edge, " << edgeFraction << nl
            << "Valid: an edge above 0 and below the gel" << nl
            << exit(FatalError);
    }

    const auto D = [&](const scalar fraction)
    {
        const scalar value = diffusivity(fraction);

        if (!(value > 0))
        {
            colloid::errorAt
            (
                colloid::caseFile(fileName("constant/clayProperties")),
                wordList({"water", "concentration"})
            )
                << "D is " << value << " at the solid fraction " << fraction
                << ", and a gel spreads only where it is above 0" << nl
                << "Below the concentration at which clay coagulates, D < 0"
                << " is met at high" << nl
                << "fractions, where platelets all but touch: a lower fraction"
                << " in the hole" << nl << exit(FatalIOError);
        }

        return value;
    };

    forAll(fractions_, i)
    {
        fractions_[i] =
            edgeFraction
           *std::pow(highestFraction/edgeFraction, scalar(i)/intervals);
        D_[i] = D(fractions_[i]);
    }

    // Simpson, each interval in quarters
    for (label i = 0; i < intervals; ++i)
    {
        const scalar width = fractions_[i + 1] - fractions_[i];
        const auto inside = [&](const scalar part)
        {
            return D(fractions_[i] + part*width);
        };

        integral_[i + 1] =
            integral_[i]
          + width/12
           *(
                D_[i] + 4*inside(0.25) + 2*inside(0.5) + 4*inside(0.75)
              + D_[i + 1]
            );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::diffusionIntegral::value(const scalar fraction) const
{
    if (fraction < edgeFraction())
    {
        return (fraction - edgeFraction())*D_.first();
    }
    if (fraction > highestFraction())
    {
        return integral_.last() + (fraction - highestFraction())*D_.last();
    }

    const label i = interval(fraction);
    const scalar width = fractions_[i + 1] - fractions_[i];
    const scalar s = (fraction - fractions_[i])/width;
    const scalar rise = integral_[i + 1] - integral_[i];

    return
        integral_[i] + rise*s*s*(3 - 2*s)
      + width*s*(1 - s)*(D_[i]*(1 - s) - D_[i + 1]*s);
}


Foam::scalar Foam::diffusionIntegral::slope(const scalar fraction) const
{
    if (fraction < edgeFraction())
    {
        return D_.first();
    }
    if (fraction > highestFraction())
    {
        return D_.last();
    }

    const label i = interval(fraction);
    const scalar width = fractions_[i + 1] - fractions_[i];
    const scalar s = (fraction - fractions_[i])/width;
    const scalar mean = (integral_[i + 1] - integral_[i])/width;

    return
        6*mean*s*(1 - s) + D_[i]*(1 - s)*(1 - 3*s) + D_[i + 1]*s*(3*s - 2);
}


Foam::scalar Foam::diffusionIntegral::fraction(const scalar integral) const
{
    scalar lower = edgeFraction(), upper = highestFraction();

    if (integral <= 0)
    {
        return lower + integral/D_.first();
    }
    if (integral >= integral_.last())
    {
        return upper + (integral - integral_.last())/D_.last();
    }

    while (upper - lower > 1e-14*upper)
    {
        const scalar middle = 0.5*(lower + upper);
        (value(middle) < integral ? lower : upper) = middle;
    }

    return 0.5*(lower + upper);
}


// ************************************************************************* //
