/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "potentialInWater.H"
#include "caseFile.H"
#include "errorAt.H"
#include "quadrature.H"
#include "error.H"

#include <algorithm>
#include <cmath>

namespace
{

using Foam::scalar;

// Nodes lie at first*(exp(s) - 1) with s evenly spaced: even below it, by a
// fixed ratio above
constexpr scalar first = 1e-5;
constexpr int panels = 2000;

} // End anonymous namespace


Foam::coexistence Foam::potentialInWater::phasesOf
(
    const fractionDiffusivity& model,
    const fractionDiffusivity::inWater& D,
    const scalar largest,
    const scalar concentration
)
{
    // Without a pressure D alone says where it is negative
    const bool hasPressure = D.pressureSlope(0.5*largest) != 0;

    const coexistence phases
    (
        [&](const scalar alpha)
        {
            return hasPressure ? D.pressureSlope(alpha) : D.value(alpha);
        },
        largest
    );

    if
    (
        phases.kind() != coexistence::state::onePhase
     && (
            model.refusesNegative() || !hasPressure
         || phases.kind() == coexistence::state::noGel
        )
    )
    {
        colloid::errorAt
        (
            colloid::caseFile(fileName("constant/erosionProperties")),
            wordList({"diffusivity"})
        )
            << "The diffusivity " << model.type() << " is negative between the"
            << " solid fractions " << phases.lower() << " and "
            << phases.upper() << " at " << concentration << " mol/m3" << nl
            << (
                   model.refusesNegative()
                 ? "    and erosionProperties says 'negative refuse'"
                 : hasPressure
                 ? "    and no gel up to the largest fraction (packing) is in"
                   " equilibrium with a sol"
                 : "    and this model has no osmotic pressure to tell which"
                   " phases are in equilibrium"
               )
            << nl << "Above the critical coagulation concentration clay does"
            << " not spread: clayScales prints it for this clay"
            << exit(FatalIOError);
    }
    return phases;
}


Foam::potentialInWater::potentialInWater
(
    const fractionDiffusivity& model,
    const colloid::water& solution,
    const scalar largest
)
:
    largest_(largest),
    length_(std::log1p(largest/first)/panels),
    phases_
    (
        phasesOf(model, *model.at(solution), largest, solution.concentration)
    )
{
    const auto law = model.at(solution);
    const bool twoPhases = phases_.kind() == coexistence::state::twoPhases;

    const std::function<scalar(scalar)> D = [&](const scalar alpha)
    {
        return
            twoPhases && alpha > phases_.sol() && alpha < phases_.gel()
          ? 0
          : max(law->value(alpha), scalar(0));
    };

    nodes_.resize(panels + 1);
    nodes_[0] = {0, 0, D(0), D(0)};

    for (int i = 1; i <= panels; ++i)
    {
        node& upper = nodes_[i];
        node& lower = nodes_[i - 1];
        upper.alpha = i == panels ? largest : first*std::expm1(i*length_);

        // The phases lie within panels: their kinks are integrated apart
        std::vector<scalar> ends{lower.alpha, upper.alpha};
        for (const scalar kink : {phases_.sol(), phases_.gel()})
        {
            if (kink > lower.alpha && kink < upper.alpha)
            {
                ends.insert(ends.end() - 1, kink);
            }
        }

        scalar sum = 0;
        for (std::size_t k = 1; k < ends.size(); ++k)
        {
            sum += colloid::integralOverPanel(D, ends[k - 1], ends[k]);
        }
        upper.potential = lower.potential + sum;
        upper.slopeBelow = upper.slopeAbove = D(upper.alpha);

        // A cubic is monotone with end slopes up to three times its mean one
        // (Fritsch and Carlson 1980)
        const scalar most = 3*sum/(upper.alpha - lower.alpha);
        lower.slopeAbove = min(lower.slopeAbove, most);
        upper.slopeBelow = min(upper.slopeBelow, most);
    }
}


Foam::potentialInWater::place Foam::potentialInWater::find
(
    const scalar alpha
) const
{
    if (alpha <= 0)
    {
        return {alpha, 0, 0};
    }
    if (alpha >= largest_)
    {
        return {alpha, panels - 1, 1};
    }
    std::size_t i =
        std::min<std::size_t>(panels - 1, std::log1p(alpha/first)/length_);

    // Round-off of the logarithm
    if (alpha < nodes_[i].alpha && i > 0)
    {
        --i;
    }
    return
    {
        alpha,
        i,
        (alpha - nodes_[i].alpha)/(nodes_[i + 1].alpha - nodes_[i].alpha)
    };
}


Foam::potentialInWater::point Foam::potentialInWater::at
(
    const place& where
) const
{
    if (where.alpha <= 0)
    {
        const scalar D = nodes_.front().slopeAbove;
        return {where.alpha*D, D};
    }
    if (where.alpha >= largest_)
    {
        const node& last = nodes_.back();
        return
        {
            last.potential + (where.alpha - largest_)*last.slopeBelow,
            last.slopeBelow
        };
    }

    const node& a = nodes_[where.panel];
    const node& b = nodes_[where.panel + 1];
    const scalar h = b.alpha - a.alpha;
    const scalar t = where.share;
    const scalar rise = b.potential - a.potential;

    return
    {
        a.potential + rise*t*t*(3 - 2*t)
      + h*t*(1 - t)*(a.slopeAbove*(1 - t) - b.slopeBelow*t),

        6*t*(1 - t)*rise/h
      + a.slopeAbove*(1 - t)*(1 - 3*t) + b.slopeBelow*t*(3*t - 2)
    };
}
