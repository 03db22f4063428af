/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scales.H"
#include "KozenyCarmanFriction.H"
#include "StokesFriction.H"
#include "mathematicalConstants.H"
#include "quadrature.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::scales::scales
(
    const platelet& clay,
    const water& solution,
    const doubleLayer& repulsion,
    const plateletFriction& friction
)
:
    clay_(clay),
    water_(solution),
    doubleLayer_(repulsion.clone().release()),
    vanDerWaals_(clay),
    pair_(clay, solution, &repulsion, &vanDerWaals_),
    friction_(friction.clone().release())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::scales::DebyeLength() const
{
    return 1/water_.inverseDebyeLength();
}


Foam::scalar Foam::colloid::scales::spacing(const scalar fraction) const
{
    return clay_.cubicSpacing(fraction);
}


Foam::scalar Foam::colloid::scales::gapAtSpacing(const scalar fraction) const
{
    return spacing(fraction) - clay_.thickness;
}


Foam::scalar Foam::colloid::scales::rangeInSpacings
(
    const scalar tolerance,
    const scalar fraction
) const
{
    return rangeInSpacings
    (
        pair_,
        spacing(fraction),
        clay_.thickness,
        tolerance
    );
}


Foam::scalar Foam::colloid::scales::rangeInSpacings
(
    const pairInteraction& pair,
    const scalar spacing,
    const scalar thickness,
    const scalar tolerance
)
{
    const auto forceAt = [&](const scalar spacings)
    {
        return mag(pair.force(spacings*spacing - thickness));
    };

    const scalar small = tolerance*forceAt(1);

    // From far to near, since the net force may pass through zero and return:
    // the first place that is not small
    const label nSteps = 2000;
    const scalar ratio = std::pow(1000.0, 1.0/nSteps);

    label i = nSteps;
    while (i > 0 && forceAt(std::pow(ratio, i)) <= small)
    {
        --i;
    }

    if (i == nSteps)
    {
        return 1000;
    }

    scalar large = std::pow(ratio, i);
    scalar far = std::pow(ratio, i + 1);

    for (label j = 0; j < 50; ++j)
    {
        const scalar middle = 0.5*(large + far);

        (forceAt(middle) <= small ? far : large) = middle;
    }

    return far;
}


Foam::scalar Foam::colloid::scales::latticePressure
(
    const pairInteraction& pair,
    const scalar spacing,
    const scalar thickness
)
{
    const scalar far = cutOffInSpacings(pair, spacing, thickness, 1e-4);
    const label range = label(std::ceil(min(far, scalar(40))));
    scalar sum = 0;

    for (label i = -range; i <= range; ++i)
    {
        for (label j = -range; j <= range; ++j)
        {
            for (label k = -range; k <= range; ++k)
            {
                const label squared = i*i + j*j + k*k;
                if (squared > 0 && squared <= range*range)
                {
                    const scalar r = spacing*Foam::sqrt(scalar(squared));
                    sum += r*pair.force(r - thickness);
                }
            }
        }
    }
    return sum/(6*pow3(spacing));
}


Foam::scalar Foam::colloid::scales::pressureBeyond
(
    const scalar spacings,
    const pairInteraction& pair,
    const scalar spacing,
    const scalar thickness
)
{
    const auto forceAt = [&](const scalar r)
    {
        return mag(pair.force(r*spacing - thickness));
    };
    const auto beyond = [&](const scalar start)
    {
        // Panels in which an exponential and a power are smooth
        const scalar ratio = 1.05;

        scalar sum = 0;
        for (scalar r = start; r < 1000; r *= ratio)
        {
            sum += integralOverPanel
            (
                [&](const scalar x)
                {
                    return
                        4*constant::mathematical::pi*pow3(x)*forceAt(x);
                },
                r,
                ratio*r
            );
        }
        return sum;
    };

    // The six nearest, and the others as if they were spread evenly
    const scalar all = 6*forceAt(1) + beyond(1.2);

    // Nearer than the nearest is none: at contact forces are anything
    return all > 0 ? (spacings < 1 ? 1 : beyond(spacings)/all) : 0;
}


Foam::scalar Foam::colloid::scales::cutOffInSpacings
(
    const pairInteraction& pair,
    const scalar spacing,
    const scalar thickness,
    const scalar tolerance
)
{
    scalar near = 1;
    scalar far = 1000;

    if (pressureBeyond(near, pair, spacing, thickness) <= tolerance)
    {
        return near;
    }

    while (far > 1.001*near)
    {
        const scalar middle = std::sqrt(near*far);

        (
            pressureBeyond(middle, pair, spacing, thickness) > tolerance
          ? near : far
        ) = middle;
    }
    return far;
}



Foam::scalar Foam::colloid::scales::criticalTimeStep
(
    const scalar gap,
    const scalar fraction
) const
{
    const scalar stiffness = mag(pair_.slope(gap));

    return stiffness > VSMALL ? friction_->value(fraction)/stiffness : GREAT;
}


Foam::scalar Foam::colloid::scales::latticeStiffness
(
    const scalar fraction
) const
{
    return
        4*mag(pair_.slope(gapAtSpacing(fraction)))/friction_->value(fraction);
}


Foam::scalar Foam::colloid::scales::engineTimeStep(const scalar fraction) const
{
    const scalar step = 0.1*spacing(fraction);
    const scalar thermal =
        0.5*step*step*friction_->value(fraction)/water_.thermalEnergy();

    // 0.5/stiffness without dividing by a force that has underflowed
    const scalar stiffness = latticeStiffness(fraction);

    return stiffness*thermal > 0.5 ? 0.5/stiffness : thermal;
}


Foam::scalar Foam::colloid::scales::inertialTime(const scalar fraction) const
{
    return clay_.mass()/friction_->value(fraction);
}


Foam::scalar Foam::colloid::scales::inertiaNumber
(
    const scalar gap,
    const scalar fraction
) const
{
    return
        inertialTime(fraction)
       *mag(pair_.slope(gap))/friction_->value(fraction);
}


Foam::scalar Foam::colloid::scales::StokesNumber
(
    const scalar gap,
    const scalar fraction
) const
{
    const scalar velocity = 2*mag(pair_.force(gap))/friction_->value(fraction);

    return inertialTime(fraction)*velocity/clay_.thickness;
}


Foam::scalar Foam::colloid::scales::settlingVelocity
(
    const scalar fraction
) const
{
    return
        (clay_.density - water_.density)*clay_.volume()
       *physicalConstants::standardGravity
       /friction_->value(fraction);
}


Foam::scalar Foam::colloid::scales::vanDerWaalsOverDoubleLayer
(
    const scalar gap
) const
{
    const scalar repulsion = doubleLayer_->force(gap);
    const scalar attraction = vanDerWaals_.force(gap);

    // Not by division: the repulsion may have underflowed
    return repulsion*GREAT > attraction ? attraction/repulsion : GREAT;
}


Foam::scalar Foam::colloid::scales::KozenyCarmanOverStokes
(
    const scalar Kozeny,
    const scalar fraction
) const
{
    const scalar alone = StokesFriction(clay_, water_).value(0);
    const scalar among =
        KozenyCarmanFriction(clay_, water_, Kozeny).value(fraction);

    return among/alone - 1;
}


Foam::scalar Foam::colloid::scales::thermalOverForce
(
    const scalar fraction
) const
{
    const scalar work =
        mag(pair_.force(gapAtSpacing(fraction)))*spacing(fraction);

    return
        work*GREAT > water_.thermalEnergy()
      ? water_.thermalEnergy()/work
      : GREAT;
}


Foam::scalar Foam::colloid::scales::doubleLayerOverThermal
(
    const scalar fraction
) const
{
    const pairInteraction repulsion
    (
        clay_, water_, doubleLayer_.get(), nullptr
    );
    const scalar kT = water_.thermalEnergy();

    // Bisection for the gap of which the energy is kT
    scalar near = clay_.contactGap;
    scalar far = 1e3*max(DebyeLength(), clay_.thickness);
    for (int i = 0; i < 60; ++i)
    {
        const scalar middle = 0.5*(near + far);
        (repulsion.energy(middle) > kT ? near : far) = middle;
    }
    const scalar excluded =
        2*constant::mathematical::pi/3
       *pow3((near + clay_.thickness)/spacing(fraction));

    return max
    (
        doubleLayer_->force(gapAtSpacing(fraction))*spacing(fraction)/kT,
        excluded
    );
}


Foam::scalar Foam::colloid::scales::settlingOverFlow
(
    const scalar fraction,
    const scalar waterVelocity
) const
{
    const scalar settling = mag(settlingVelocity(fraction));

    return
        mag(waterVelocity)*GREAT > settling
      ? settling/mag(waterVelocity)
      : GREAT;
}


Foam::scalar Foam::colloid::scales::rimThickness
(
    const scalar length,
    const scalar waterVelocity,
    const scalar diffusivity,
    const scalar relativeViscosity
)
{
    return
        10*std::sqrt(length*diffusivity*relativeViscosity/waterVelocity);
}


Foam::scalar Foam::colloid::scales::rimDiffusionTime
(
    const scalar rimThickness,
    const scalar diffusivity
)
{
    return rimThickness*rimThickness/diffusivity;
}


Foam::scalar Foam::colloid::scales::rimSteadyTime
(
    const scalar length,
    const scalar waterVelocity,
    const scalar relativeViscosity
)
{
    return 0.7*length*relativeViscosity/waterVelocity;
}


// ************************************************************************* //
