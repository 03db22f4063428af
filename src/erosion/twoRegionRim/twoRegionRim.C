/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoRegionRim.H"
#include "error.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Of a pseudo-steady profile, where it is asked for
constexpr Foam::label profilePoints = 100;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::twoRegionRim::perVolume() const
{
    return
        constant::mathematical::twoPi*scene_.aperture*scene_.density;
}


Foam::scalar Foam::twoRegionRim::face
(
    const label j,
    const scalar width
) const
{
    return width*j/max(controls_.cells, label(1));
}


Foam::scalar Foam::twoRegionRim::middle
(
    const label k,
    const scalar width
) const
{
    return k == 0 ? 0 : 0.5*(face(k - 1, width) + face(k, width));
}


Foam::scalar Foam::twoRegionRim::ringArea
(
    const scalar inner,
    const scalar outer
) const
{
    return (outer - inner)*(scene_.holeRadius + 0.5*(inner + outer));
}


Foam::scalar Foam::twoRegionRim::logRatio
(
    const scalar inner,
    const scalar outer
) const
{
    return std::log1p((outer - inner)/(scene_.holeRadius + inner));
}


Foam::scalar Foam::twoRegionRim::clayVolume() const
{
    if (controls_.cells > 0)
    {
        scalar sum = 0;
        for (label k = 1; k < phi_.size(); ++k)
        {
            sum += phi_[k]*ringArea(face(k - 1, width_), face(k, width_));
        }
        return sum;
    }

    const scalarField r(radii());
    const scalarField phi(fractions());
    scalar sum = 0;
    for (label i = 1; i < r.size(); ++i)
    {
        sum += 0.5*(phi[i - 1] + phi[i])
           *ringArea(r[i - 1] - scene_.holeRadius, r[i] - scene_.holeRadius);
    }
    return sum;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::twoRegionRim::twoRegionRim
(
    const scene& place,
    const std::function<scalar(scalar)>& diffusivity,
    const scalar edgeFraction,
    const controls& settings
)
:
    scene_(place),
    controls_(settings),
    D_(diffusivity, edgeFraction, place.holeFraction),
    width_((settings.startRadius - 1)*place.holeRadius),
    phi_(settings.cells + 1)
{
    // The steady profile
    const scalar all = D_.value(scene_.holeFraction);
    const scalar logarithm = logRatio(0, width_);

    forAll(phi_, k)
    {
        phi_[k] = D_.fraction
        (
            all*logRatio(middle(k, width_), width_)/logarithm
        );
    }

    startClay_ = clayVolume();

    // So long as diffusion takes to cross a part of the gel
    deltaT_ = sqr(controls_.growth*width_)/D_.slope(scene_.holeFraction);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::twoRegionRim::radii() const
{
    if (controls_.cells > 0)
    {
        scalarField r(phi_.size() + 1);
        forAll(phi_, k)
        {
            r[k] = scene_.holeRadius + middle(k, width_);
        }
        r.last() = radius();
        return r;
    }

    scalarField r(profilePoints + 1);
    forAll(r, i)
    {
        r[i] = scene_.holeRadius + width_*i/profilePoints;
    }
    return r;
}


Foam::scalarField Foam::twoRegionRim::fractions() const
{
    if (controls_.cells > 0)
    {
        scalarField phi(phi_);
        phi.append(D_.edgeFraction());
        return phi;
    }

    scalarField phi(radii());
    const scalar all =
        D_.value(phi_[0])/logRatio(0, width_);

    for (scalar& value : phi)
    {
        value = D_.fraction
        (
            all*logRatio(value - scene_.holeRadius, width_)
        );
    }
    return phi;
}


Foam::scalar Foam::twoRegionRim::steadyRadius() const
{
    const scalar all = D_.value(phi_[0])*perVolume();

    // In the logarithm of r_R/r_i: the feed falls, the loss does not
    scalar lower = 0, upper = 60;
    while (upper - lower > 1e-13*upper)
    {
        const scalar middle = 0.5*(lower + upper);
        const scalar loss =
            scene_.lossRate(scene_.holeRadius*std::exp(middle));
        (all > loss*middle ? lower : upper) = middle;
    }

    return scene_.holeRadius*std::exp(0.5*(lower + upper));
}


// ************************************************************************* //
