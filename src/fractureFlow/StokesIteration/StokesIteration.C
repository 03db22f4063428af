/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "StokesIteration.H"

void Foam::StokesIteration::moveTo(const flowState& x)
{
    U_.primitiveFieldRef() = x.momentum;
    p_.primitiveFieldRef() = x.continuity;
}


void Foam::StokesIteration::orthonormalise
(
    flowState& step,
    flowState& change
) const
{
    for (std::size_t i = 0; i < steps_.size(); ++i)
    {
        const scalar overlap = system_.product(change, changes_[i]);
        change.add(-overlap, changes_[i]);
        step.add(-overlap, steps_[i]);
    }

    const scalar length = Foam::sqrt(system_.product(change, change));

    if (length > 0)
    {
        step.scale(1/length);
        change.scale(1/length);
    }
}


std::size_t Foam::StokesIteration::dispensable() const
{
    std::size_t shortest = maxSteps_;

    for (std::size_t i = 0; i < maxSteps_; ++i)
    {
        const bool recent = numbers_[i] + nRecent_ >= number_;

        if
        (
            !recent
         && (shortest == maxSteps_ || lengths_[i] < lengths_[shortest])
        )
        {
            shortest = i;
        }
    }

    return shortest;
}


void Foam::StokesIteration::keep
(
    const flowState& step,
    const flowState& change
)
{
    if (steps_.size() < maxSteps_)
    {
        latest_ = steps_.size();
        steps_.resize(latest_ + 1);
        changes_.resize(latest_ + 1);
        numbers_.resize(latest_ + 1);
        lengths_.resize(latest_ + 1);
    }
    else
    {
        latest_ = dispensable();
    }

    steps_[latest_] = step;
    changes_[latest_] = change;
    numbers_[latest_] = number_++;
    lengths_[latest_] = system_.stepLength(step);
}


Foam::StokesIteration::StokesIteration
(
    const StokesSystem& system,
    StokesPreconditioner& preconditioner,
    volVectorField& U,
    volScalarField& p,
    surfaceScalarField& phi,
    const flowState& r,
    const label maxSteps
)
:
    system_(system),
    preconditioner_(preconditioner),
    U_(U),
    p_(p),
    phi_(phi),
    x_(U.size()),
    r_(r),
    number_(0),
    latest_(0),
    maxSteps_(maxSteps),
    nRecent_(maxSteps/3),
    stagnant_(false)
{
    x_.momentum = U.primitiveField();
    x_.continuity = p.primitiveField();
}


void Foam::StokesIteration::advance()
{
    flowState step(U_.size());
    preconditioner_.apply(stagnant_ ? changes_[latest_] : r_, step);

    // The equations are affine: what a step changes shows in the residuals
    flowState ahead(x_);
    ahead.add(1, step);
    moveTo(ahead);

    flowState rAhead(U_.size());
    system_.residual(U_, p_, phi_, rAhead);

    flowState change(r_);
    change.add(-1, rAhead);

    orthonormalise(step, change);

    const scalar part = system_.product(r_, change);

    // A tenth of the residual's length shortens it by half a per cent
    stagnant_ = mag(part) < 0.1*size();

    x_.add(part, step);
    r_.add(-part, change);

    keep(step, change);
}


Foam::scalar Foam::StokesIteration::size() const
{
    return Foam::sqrt(system_.product(r_, r_));
}


void Foam::StokesIteration::evaluate()
{
    moveTo(x_);
    system_.residual(U_, p_, phi_, r_);
}
