/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayInteractions.H"
#include "integrator.H"
#include "pairInteraction.H"
#include "scales.H"
#include "Time.H"
#include "vanDerWaals.H"

namespace
{

using namespace Foam;

//- By what the mean spacing, and concentration and speed of the water, change
//  until all is decided anew
constexpr scalar otherSpacing = 1.15;
constexpr scalar otherWater = 1.5;

//- Whether two positive numbers differ by more than a factor
bool differ(const scalar a, const scalar b, const scalar factor)
{
    return a > factor*b || b > factor*a;
}

} // End anonymous namespace


bool Foam::clayInteractions::reconsider
(
    const scalar time,
    const scalar spacing,
    const std::function<scalar()>& waterSpeed
)
{
    using choice = cloudProperties::choice;

    const bool changed =
        differ(spacing, state_.decidedSpacing, otherSpacing)
     || differ
        (
            matter_.waterAt(time).concentration,
            matter_.waterAt(state_.decidedAt).concentration,
            otherWater
        )
     || (
            properties_.effect("drag") == choice::automatic
         && differ(waterSpeed(), state_.decidedSpeed, otherWater)
        );

    if (!changed)
    {
        return false;
    }

    const effectTable before(effects_);
    const scalar cutOffBefore = cutOff_;
    const scalar spacingBefore = state_.decidedSpacing;
    const scalar timeBefore = state_.decidedAt;

    state_.decidedAt = time;
    state_.decidedSpacing = spacing;
    state_.decidedSpeed = waterSpeed();
    decide();

    Info<< "At " << time << " s the scene has changed: mean spacing "
        << spacingBefore << " -> " << spacing << " m, concentration "
        << matter_.waterAt(timeBefore).concentration << " -> "
        << matter_.waterAt(time).concentration << " mol/m3, cut-off "
        << cutOffBefore << " -> " << cutOff_ << " m" << nl;
    effects_.printChanges(Info, before);
    return true;
}


void Foam::clayInteractions::decide()
{
    effects_ = effectTable();
    decideEffects();
    decideFriction();
    chooseCutOff();
    settings_ = engineFor(state_.decidedSpacing, cutOff_);
    settings_.bodyForce = reduced(weight_, units_->force());
}


void Foam::clayInteractions::decideEffects()
{
    using choice = cloudProperties::choice;

    const scalar time = state_.decidedAt;
    const colloid::platelet& clay = matter_.clay();
    const colloid::water water(matter_.waterAt(time));
    const scalar alpha = state_.coarseGraining;
    const scalar tolerance = properties_.tolerance();

    const autoPtr<colloid::doubleLayer> repulsion
    (
        matter_.newDoubleLayer(properties_.doubleLayerDict(), water)
    );
    const autoPtr<colloid::plateletFriction> Stokes
    (
        matter_.newFriction("Stokes", water)
    );
    const colloid::scales scales(clay, water, *repulsion, *Stokes);
    const scalar fraction = fractionAt(state_.decidedSpacing);

    // Attraction counts where platelets come nearer than the mean, and where they
    // have spread, next to the double layer and to random motion; and wherever
    // nothing keeps platelets from sticking together
    const scalar thermalForce = water.thermalEnergy()/scales.spacing(fraction);
    const auto negative =
        colloid::coagulation(matter_, properties_.doubleLayerDict())
       .negative(water.concentration);
    scalar attraction = negative.found ? 1 : 0;
    for (const scalar spacings : {0.5, 1.0, 1.5})
    {
        const scalar gap = max
        (
            spacings*scales.spacing(fraction) - clay.thickness,
            clay.contactGap
        );
        attraction = max
        (
            attraction,
            colloid::vanDerWaals(clay).force(gap)
           /max
            (
                repulsion->force(gap),
                properties_.effect("Brownian") == choice::off
              ? VSMALL : thermalForce
            )
        );
    }
    vanDerWaalsOn_ = effects_.decide
    (
        "vanDerWaals",
        properties_.effect("vanDerWaals"),
        "F_vdW/max(F_DDL, kT/spacing)",
        attraction,
        tolerance
    );

    // Where there is attraction, what holds it off counts
    const scalar byRepulsion = scales.doubleLayerOverThermal(fraction);
    doubleLayerOn_ = effects_.decide
    (
        "doubleLayer",
        properties_.effect("doubleLayer"),
        "its pressure/(n kT)",
        vanDerWaalsOn_ ? max(byRepulsion, scalar(1)) : byRepulsion,
        tolerance
    );
    if (vanDerWaalsOn_)
    {
        warnOfCoagulation(water.concentration, negative);
    }

    decideBrownian(scales.thermalOverForce(fraction));

    const scalar force =
        mag(pairLaw(time).force(state_.decidedSpacing - thickness()));
    const scalar against =
        max(force, alpha*water.thermalEnergy()/state_.decidedSpacing);

    dragOn_ = effects_.decide
    (
        "drag",
        properties_.effect("drag"),
        "xi U/max(F, kT/spacing)",
        alpha*Stokes->value(0)*state_.decidedSpeed/against,
        tolerance
    );

    const vector weight(alpha*clay.volume()*(clay.density - water.density)*g_);
    const bool gravityOn = effects_.decide
    (
        "gravity",
        properties_.effect("gravity"),
        "weight/max(F, kT/spacing)",
        mag(weight)/against,
        tolerance
    );
    weight_ = gravityOn ? weight : vector(Zero);
}


void Foam::clayInteractions::decideBrownian(const scalar measure)
{
    using choice = cloudProperties::choice;

    const char* const measureIs = "kT/(F spacing)";
    const scalar tolerance = properties_.tolerance();
    const choice said = properties_.effect("Brownian");
    const word integrator(properties_.integrator());
    const bool canDo =
        plateletDynamics::integrator::canMoveAtRandom(integrator);

    if (said == choice::automatic && !canDo)
    {
        BrownianOn_ = false;
        effects_.note
        (
            "Brownian", measureIs, measure, tolerance, false, "integrator"
        );
        if (measure >= tolerance)
        {
            WarningInFunction
                << "Random motion counts here (" << measureIs << " is "
                << measure << "), but the integrator " << integrator
                << " does none." << nl << "    Take the integrator auto or"
                << " LeimkuhlerMatthews, or say Brownian off" << nl << endl;
        }
        return;
    }

    BrownianOn_ = effects_.decide
    (
        "Brownian", said, measureIs, measure, tolerance
    );
    if (BrownianOn_ && !canDo)
    {
        FatalIOErrorInFunction(properties_.dict())
            << "The effect Brownian is on, but the integrator " << integrator
            << " does no random motion." << nl
            << "    Take the integrator auto or LeimkuhlerMatthews"
            << exit(FatalIOError);
    }
}


void Foam::clayInteractions::warnOfCoagulation
(
    const scalar concentration,
    const colloid::coagulation::range& negative
) const
{
    if (negative.found)
    {
        WarningInFunction
            << "At " << concentration << " mol/m3 attraction wins: between the"
            << " solid fractions " << negative.lower << " and "
            << negative.upper << nl
            << "    diffusivity is negative and platelets aggregate (clayScales"
            << " shows the critical concentration)" << nl << endl;
    }
}


void Foam::clayInteractions::decideFriction()
{
    using choice = cloudProperties::choice;

    const colloid::water water(matter_.waterAt(state_.decidedAt));
    const word model(matter_.frictionModel());
    const scalar packing = colloid::scales
    (
        matter_.clay(),
        water,
        *matter_.newDoubleLayer("compression", water),
        *matter_.newFriction("Stokes", water)
    ).KozenyCarmanOverStokes
    (
        matter_.Kozeny(), fractionAt(state_.decidedSpacing)
    );

    const bool KozenyCarmanOn = effects_.decide
    (
        "KozenyCarman",
        model == "auto" ? choice::automatic
      : model == "KozenyCarman" ? choice::on : choice::off,
        "2nd/1st term of friction",
        packing,
        properties_.tolerance()
    );

    friction_ = matter_.newFriction
    (
        model == "auto" ? word(KozenyCarmanOn ? "KozenyCarman" : "Stokes")
      : model,
        water
    );

    effects_.note
    (
        "localFraction",
        "2nd/1st term of friction",
        packing,
        properties_.tolerance(),
        friction_->varies(),
        model == "auto" && !KozenyCarmanOn ? "auto" : "friction"
    );
}
