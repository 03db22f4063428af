/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoRegionRim.H"
#include "caseFile.H"
#include "errorAt.H"
#include "error.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr Foam::label maxIterations = 25;
constexpr Foam::label maxHalvings = 60;

// Change at which Newton's method has converged, over the value
constexpr Foam::scalar converged = 1e-13;

// For the derivatives by the gel's width, over it
constexpr Foam::scalar nudge = 1e-6;

// Of the gel's width over that at the start, and of the hole's fraction over
// the edge's: what is less is spent
constexpr Foam::scalar spentWidth = 1e-3;
constexpr Foam::scalar spentFraction = 1.0001;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::twoRegionRim::towardsRim
(
    const scalarField& phi,
    const scalar width
) const
{
    return
        D_.value(phi.last())/logRatio(middle(phi.size() - 1, width), width);
}


Foam::scalar Foam::twoRegionRim::outwards
(
    const label k,
    const scalarField& phi,
    const scalar width,
    const scalar deltaT
) const
{
    const scalar diffusion =
        (D_.value(phi[k]) - D_.value(phi[k + 1]))
       /logRatio(middle(k, width), middle(k + 1, width));

    // What the moving face sweeps up. That of the hole stands still
    const scalar swept =
        k == 0 ? 0 : ringArea(face(k, width_), face(k, width))/deltaT;

    return diffusion - 0.5*(phi[k] + phi[k + 1])*swept;
}


Foam::scalarField Foam::twoRegionRim::residual
(
    const scalarField& phi,
    const scalar width,
    const scalar deltaT
) const
{
    const label cells = controls_.cells;
    scalarField left(cells + 2);

    const scalar loss = scene_.lossRate(scene_.holeRadius + width)/perVolume();
    const scalar toRim = towardsRim(phi, width);

    scalar flux = cells > 0 ? outwards(0, phi, width, deltaT) : toRim;

    if (scene_.plugVolume < GREAT)
    {
        const scalar volume = scene_.plugVolume*scene_.density/perVolume();
        left[0] = volume*(phi[0] - phi_[0])/deltaT + flux;
    }
    else
    {
        left[0] = phi[0] - phi_[0];
    }

    for (label k = 1; k <= cells; ++k)
    {
        const scalar out =
            k < cells ? outwards(k, phi, width, deltaT) : loss;

        left[k] =
            (
                phi[k]*ringArea(face(k - 1, width), face(k, width))
              - phi_[k]*ringArea(face(k - 1, width_), face(k, width_))
            )/deltaT
          + out - flux;
        flux = out;
    }

    left[cells + 1] =
        D_.edgeFraction()*ringArea(width_, width)/deltaT - toRim + loss;

    return left;
}


bool Foam::twoRegionRim::solve
(
    scalarField& phi,
    scalar& width,
    const scalar deltaT
) const
{
    const label last = controls_.cells;
    const bool held = scene_.plugVolume >= GREAT;

    scalarField diagonal(last + 1), above(last + 1, 0), below(last + 1, 0);
    scalarField change(last + 1), byRim(last + 1);

    for (label iteration = 0; iteration < maxIterations; ++iteration)
    {
        const scalarField left(residual(phi, width, deltaT));
        const scalar step = nudge*width;
        const scalarField leftBeyond(residual(phi, width + step, deltaT));

        // The unknowns' matrix: tridiagonal
        diagonal = 0;
        diagonal[0] =
            held ? 1 : scene_.plugVolume*scene_.density/perVolume()/deltaT;
        for (label k = 1; k <= last; ++k)
        {
            diagonal[k] = ringArea(face(k - 1, width), face(k, width))/deltaT;
        }
        for (label k = 0; k < last; ++k)
        {
            const scalar conductance =
                1/logRatio(middle(k, width), middle(k + 1, width));
            const scalar swept =
                k == 0 ? 0
              : 0.5*ringArea(face(k, width_), face(k, width))/deltaT;
            const scalar fromInside =
                conductance*D_.slope(phi[k]) - swept;
            const scalar fromOutside =
               -conductance*D_.slope(phi[k + 1]) - swept;

            // Out of the one and into the other
            if (k > 0 || !held)
            {
                diagonal[k] += fromInside;
                above[k] = fromOutside;
            }
            diagonal[k + 1] -= fromOutside;
            below[k + 1] = -fromInside;
        }

        const scalar rimByPhi =
            D_.slope(phi[last])/logRatio(middle(last, width), width);
        if (last == 0 && !held)
        {
            diagonal[0] += rimByPhi;
        }

        // Changes as they are with the rim held, and by what it moves
        for (label k = 0; k <= last; ++k)
        {
            change[k] = -left[k];
            byRim[k] = -(leftBeyond[k] - left[k])/step;

            if (k > 0)
            {
                const scalar factor = below[k]/diagonal[k - 1];
                diagonal[k] -= factor*above[k - 1];
                change[k] -= factor*change[k - 1];
                byRim[k] -= factor*byRim[k - 1];
            }
        }
        for (label k = last; k >= 0; --k)
        {
            if (k < last)
            {
                change[k] -= above[k]*change[k + 1];
                byRim[k] -= above[k]*byRim[k + 1];
            }
            change[k] /= diagonal[k];
            byRim[k] /= diagonal[k];
        }

        const scalar moves =
            (-left[last + 1] + rimByPhi*change[last])
           /(
                (leftBeyond[last + 1] - left[last + 1])/step
              - rimByPhi*byRim[last]
            );

        if (!std::isfinite(moves) || mag(moves) > 0.5*width)
        {
            return false;
        }

        scalar largest = mag(moves)/width;
        width += moves;
        forAll(phi, k)
        {
            const scalar by = change[k] + byRim[k]*moves;
            phi[k] += by;
            largest = max(largest, mag(by)/D_.edgeFraction());

            if (phi[k] <= 0 || phi[k] >= 1)
            {
                return false;
            }
        }

        if (largest < converged)
        {
            return true;
        }
        if (iteration > 4 && largest < 1e3*converged)
        {
            // Round-off
            return true;
        }
    }

    return false;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::twoRegionRim::advance(const scalar time)
{
    while (time_ < time)
    {
        if
        (
            width_
          < spentWidth*(controls_.startRadius - 1)*scene_.holeRadius
         || phi_[0] < spentFraction*D_.edgeFraction()
        )
        {
            return false;
        }

        scalar deltaT = 0;
        for (label halving = 0; ; ++halving)
        {
            if (halving == maxHalvings)
            {
                colloid::errorAt
                (
                    colloid::caseFile(fileName("system/clayRimDict")),
                    wordList({"expansion"})
                )
                    << "No step is found from time " << time_
                    << " s, with the rim at " << radius()
                    << " m and the hole's fraction " << phi_[0] << nl
                    << exit(FatalIOError);
            }

            deltaT = min(deltaT_, time - time_);

            scalarField phi(phi_);
            scalar width = width_;
            scalar part = GREAT;

            if (solve(phi, width, deltaT))
            {
                part = max
                (
                    mag(width - width_)/(controls_.growth*width_),
                    mag(phi[0] - phi_[0])/(controls_.growth*phi_[0])
                );
            }

            if (part > 2)
            {
                deltaT_ = 0.5*deltaT;
                continue;
            }

            feed_ =
                controls_.cells > 0
              ? outwards(0, phi, width, deltaT)
              : towardsRim(phi, width);
            loss_ = scene_.lossRate(scene_.holeRadius + width)/perVolume();
            phi_ = phi;
            width_ = width;

            if (deltaT == deltaT_ || part > 1)
            {
                deltaT_ = deltaT*min(scalar(2), 1/max(part, SMALL));
            }
            break;
        }

        cameIn_ += feed_*deltaT;
        eroded_ += loss_*deltaT;

        // The end itself, without the round-off of the sum
        time_ = deltaT == time - time_ ? time : time_ + deltaT;
    }

    return true;
}


// ************************************************************************* //
