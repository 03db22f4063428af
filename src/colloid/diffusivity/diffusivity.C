/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusivity.H"
#include "faceGap.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::colloid::diffusivity::force(const scalar gap) const
{
    return doubleLayer_->force(gap) - vanDerWaals_.force(gap);
}


Foam::scalar Foam::colloid::diffusivity::slope(const scalar gap) const
{
    return doubleLayer_->slope(gap) - vanDerWaals_.slope(gap);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::diffusivity::diffusivity
(
    const platelet& clay,
    const water& solution,
    const doubleLayer& repulsion,
    const plateletFriction& friction
)
:
    clay_(clay),
    thermalEnergy_(solution.thermalEnergy()),
    doubleLayer_(repulsion.clone().release()),
    vanDerWaals_(clay),
    friction_(friction.clone().release())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::diffusivity::value(const scalar fraction) const
{
    return terms(fraction).sum();
}


Foam::colloid::diffusivity::parts Foam::colloid::diffusivity::terms
(
    const scalar fraction
) const
{
    requireFraction(fraction);

    const scalar xi = friction_->value(fraction);

    parts d;
    d.thermal = thermalEnergy_/xi;

    // Lone platelets: gaps beyond 1e10 m have no forces
    if (fraction > 1e-20)
    {
        const scalar gap = clay_.stackGap(fraction);
        const scalar spacing = clay_.stackSpacing(fraction);

        d.doubleLayer = -spacing*doubleLayer_->slope(gap)*spacing/xi;
        d.vanDerWaals = spacing*vanDerWaals_.slope(gap)*spacing/xi;
    }

    return d;
}


Foam::scalar Foam::colloid::diffusivity::timesFriction
(
    const scalar fraction
) const
{
    return value(fraction)*friction_->value(fraction);
}


Foam::scalar Foam::colloid::diffusivity::stackWithAllNeighbours
(
    const scalar fraction
) const
{
    requireFraction(fraction);

    const scalar spacing = clay_.stackSpacing(fraction);

    scalar sum = 0;

    // The terms of van der Waals fall as 1/j^4, and their sum's rest after j
    // as a third of j times the last one
    for (label j = 1; j <= 100000; ++j)
    {
        const scalar distance = j*spacing;
        const scalar term =
            -distance*slope(distance - clay_.thickness)*distance;

        sum += term;

        if (j*mag(term) < 1e-13*mag(sum))
        {
            break;
        }
    }

    return sum/friction_->value(fraction);
}


Foam::scalar Foam::colloid::diffusivity::cubicUniaxial
(
    const scalar fraction
) const
{
    requireFraction(fraction);

    const scalar spacing = clay_.cubicSpacing(fraction);

    return
       -spacing*slope(spacing - clay_.thickness)*spacing
       /friction_->value(fraction);
}


Foam::scalar Foam::colloid::diffusivity::cubicIsotropic
(
    const scalar fraction
) const
{
    requireFraction(fraction);

    const scalar spacing = clay_.cubicSpacing(fraction);
    const scalar gap = spacing - clay_.thickness;

    return
        spacing*(2*force(gap) - spacing*slope(gap))
       /(3*friction_->value(fraction));
}


// ************************************************************************* //
