/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayInteractions.H"
#include "checkWords.H"
#include "coagulation.H"
#include "doubleLayer.H"
#include "mathematicalConstants.H"
#include "pairInteraction.H"
#include "scales.H"
#include "vanDerWaals.H"

namespace
{

using namespace Foam;

//- A force law of colloid in the engine's units
class reducedForce
:
    public plateletDynamics::gapForce
{
    const colloid::pairInteraction law_;
    const scalar length_;
    const scalar force_;

public:

    reducedForce
    (
        const colloid::pairInteraction& law,
        const reducedUnits& units
    )
    :
        law_(law),
        length_(units.length()),
        force_(units.force())
    {}

    virtual double force(double gap) const
    {
        return law_.force(gap*length_)/force_;
    }

    virtual double slope(double gap) const
    {
        return law_.slope(gap*length_)*length_/force_;
    }

    virtual double contactGap() const
    {
        return law_.contactGap()/length_;
    }
};

} // End anonymous namespace


Foam::clayInteractions::clayInteractions
(
    const colloid::clayProperties& matter,
    const cloudProperties& properties,
    const clayState& state,
    const periodicAxes& axes,
    const vector& g
)
:
    matter_(matter),
    properties_(properties),
    state_(state),
    weight_(Zero),
    warned_(false)
{
    const scalar time = state.placedAt;

    decideEffects(time, g);
    decideFriction(time);
    chooseUnits(time);
    chooseCutOff(time, axes);
    chooseEngine();
}


Foam::scalar Foam::clayInteractions::thickness() const
{
    return state_.coarseGraining*matter_.clay().thickness;
}


Foam::scalar Foam::clayInteractions::parcelVolume() const
{
    return pow3(state_.coarseGraining)*matter_.clay().volume();
}


Foam::scalar Foam::clayInteractions::placedFraction() const
{
    return min(parcelVolume()/pow3(state_.spacing), scalar(0.99));
}


Foam::colloid::pairInteraction Foam::clayInteractions::pairLaw
(
    const scalar time
) const
{
    const colloid::water water(matter_.waterAt(time));
    const autoPtr<colloid::doubleLayer> repulsion
    (
        matter_.newDoubleLayer(properties_.doubleLayerDict(), water)
    );
    const colloid::vanDerWaals attraction(matter_.clay());

    return colloid::pairInteraction
    (
        matter_.clay(),
        water,
        doubleLayerOn_ ? repulsion.get() : nullptr,
        vanDerWaalsOn_ ? &attraction : nullptr,
        state_.coarseGraining
    );
}


void Foam::clayInteractions::decideEffects(const scalar time, const vector& g)
{
    const colloid::platelet& clay = matter_.clay();
    const colloid::water water(matter_.waterAt(time));
    const scalar alpha = state_.coarseGraining;
    const scalar tolerance = properties_.tolerance();

    doubleLayerOn_ = effects_.decide
    (
        "doubleLayer", properties_.effect("doubleLayer"), "(always)", 1,
        tolerance
    );
    dragOn_ = effects_.decide
    (
        "drag", properties_.effect("drag"), "(always)", 1, tolerance
    );

    const autoPtr<colloid::doubleLayer> repulsion
    (
        matter_.newDoubleLayer(properties_.doubleLayerDict(), water)
    );
    const colloid::scales scales
    (
        clay, water, *repulsion, *matter_.newFriction("Stokes", water)
    );
    const scalar fraction = placedFraction();

    // Where platelets come nearer than placed, and where they have spread
    scalar attraction = 0;
    for (const scalar spacings : {0.5, 1.0, 1.5})
    {
        attraction = max
        (
            attraction,
            scales.vanDerWaalsOverDoubleLayer
            (
                max
                (
                    spacings*clay.cubicSpacing(fraction) - clay.thickness,
                    clay.contactGap
                )
            )
        );
    }
    vanDerWaalsOn_ = effects_.decide
    (
        "vanDerWaals",
        properties_.effect("vanDerWaals"),
        "F_vdW/F_DDL, 0.5-1.5 spacings",
        attraction,
        tolerance
    );
    if (vanDerWaalsOn_)
    {
        warnOfCoagulation(water.concentration);
    }

    effects_.unavailable
    (
        "Brownian",
        properties_,
        "kT/(F spacing)",
        scales.thermalOverForce(fraction),
        tolerance
    );

    const scalar force = mag(pairLaw(time).force(state_.spacing - thickness()));
    const scalar thermalForce = alpha*water.thermalEnergy()/state_.spacing;
    const vector weight(alpha*clay.volume()*(clay.density - water.density)*g);

    if
    (
        effects_.decide
        (
            "gravity",
            properties_.effect("gravity"),
            "weight/max(F, kT/spacing)",
            mag(weight)/max(force, thermalForce),
            tolerance
        )
    )
    {
        weight_ = weight;
    }
}


void Foam::clayInteractions::warnOfCoagulation(const scalar concentration) const
{
    const auto negative =
        colloid::coagulation(matter_, properties_.doubleLayerDict())
       .negative(concentration);

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


void Foam::clayInteractions::decideFriction(const scalar time)
{
    using choice = cloudProperties::choice;

    const colloid::water water(matter_.waterAt(time));
    const word model(matter_.frictionModel());

    const bool packing = effects_.decide
    (
        "KozenyCarman",
        model == "auto" ? choice::automatic
      : model == "KozenyCarman" ? choice::on : choice::off,
        "2nd/1st term of friction",
        colloid::scales
        (
            matter_.clay(),
            water,
            *matter_.newDoubleLayer("compression", water),
            *matter_.newFriction("Stokes", water)
        ).KozenyCarmanOverStokes(matter_.Kozeny(), placedFraction()),
        properties_.tolerance()
    );

    friction_ = matter_.newFriction
    (
        model == "auto" ? word(packing ? "KozenyCarman" : "Stokes") : model,
        water
    );
}


void Foam::clayInteractions::chooseUnits(const scalar time)
{
    const scalar spacing = state_.spacing;

    // Where the forces are nothing (far apart in salt water), the thermal one
    const scalar force = max
    (
        mag(pairLaw(time).force(spacing - thickness())),
        state_.coarseGraining*matter_.waterAt(time).thermalEnergy()/spacing
    );

    units_.reset(new reducedUnits(spacing, force, friction(placedFraction())));
}


void Foam::clayInteractions::chooseCutOff
(
    const scalar time,
    const periodicAxes& axes
)
{
    const scalar spacing = state_.spacing;
    const colloid::pairInteraction law(pairLaw(time));

    scalar halfPeriod = GREAT;
    for (direction axis = 0; axis < 3; ++axis)
    {
        if (axes.periodic(axis))
        {
            halfPeriod = min(halfPeriod, 0.5*axes.period(axis));
        }
    }

    cutOff_ = properties_.cutOff();

    if (cutOff_ > 0)
    {
        if (cutOff_ > halfPeriod)
        {
            FatalIOErrorInFunction(properties_.dict().subDict("solution"))
                << "cutOff is " << cutOff_ << " m, but the periodic box is"
                << " only " << 2*halfPeriod << " m wide." << nl
                << "    At most half of that, or a larger mesh"
                << exit(FatalIOError);
        }
    }
    else if
    (
        halfPeriod == GREAT && state_.entered <= properties_.maxNeighbours()
    )
    {
        // Few platelets in open space: all pairs, however far they move apart
        cutOff_ = 1e3*max(scalar(state_.entered), scalar(1))*spacing;
    }
    else
    {
        const scalar furthest = cbrt
        (
            properties_.maxNeighbours()/(4*constant::mathematical::pi/3)
        );
        const scalar spacings = min
        (
            furthest,
            colloid::scales::rangeInSpacings
            (
                law, spacing, thickness(), properties_.tolerance()
            )
        );

        // Room for the taper of the last tenth
        cutOff_ = min(max(spacings, scalar(1.5))/0.9*spacing, halfPeriod);
    }
}


Foam::scalar Foam::clayInteractions::forceLeftOut(const scalar time) const
{
    const colloid::pairInteraction law(pairLaw(time));

    return
        mag(law.force(0.9*cutOff_ - thickness()))
       /max(mag(law.force(state_.spacing - thickness())), VSMALL);
}


void Foam::clayInteractions::chooseEngine()
{
    using plateletDynamics::engineSettings;

    settings_.thickness = thickness()/units_->length();
    settings_.cutOff = cutOff_/units_->length();
    settings_.spacing = state_.spacing/units_->length();
    settings_.skin = max(properties_.skin(), scalar(0))/units_->length();
    settings_.pairKernel =
        properties_.exactKernel() || cutOff_ > 100*state_.spacing
      ? engineSettings::kernel::exact
      : engineSettings::kernel::fast;
    settings_.tableTolerance = 1e-3*properties_.tolerance();
    settings_.integrator = properties_.integrator();
    settings_.stepTolerance = 1e-2*properties_.tolerance();
    settings_.deltaT =
        max(properties_.engineDeltaT(), scalar(0))/units_->time();
    settings_.bodyForce = reduced(weight_, units_->force());
}


std::shared_ptr<const plateletDynamics::gapForce>
Foam::clayInteractions::force(const scalar time) const
{
    // A cut-off of the water at the start may not do for dilute water
    const scalar leftOut = forceLeftOut(time);

    if (leftOut > 2*forceLeftOut(state_.placedAt) + properties_.tolerance())
    {
        if (!warned_)
        {
            WarningInFunction
                << "At " << time << " s the cut-off of " << cutOff_
                << " m leaves out " << leftOut << " of the force at the mean"
                << " spacing." << nl
                << "    Set cutOff (clayCloudProperties) for the most dilute"
                << " water of the run" << nl << endl;
        }
        warned_ = true;
    }

    return std::make_shared<reducedForce>(pairLaw(time), *units_);
}


Foam::scalar Foam::clayInteractions::friction(const scalar fraction) const
{
    return state_.coarseGraining*friction_->value(fraction);
}


bool Foam::clayInteractions::frictionIsLocal() const
{
    return friction_->varies();
}


Foam::scalar Foam::clayInteractions::filterLength() const
{
    const scalar length = properties_.filterLength();

    return length > 0 ? length : 3*state_.spacing;
}


void Foam::clayInteractions::print
(
    Ostream& os,
    const std::string& kernelName
) const
{
    const auto said = [](const scalar number)
    {
        return number > 0 ? "user" : "auto";
    };

    os  << nl << "Platelets" << nl
        << "    coarseGraining   " << state_.coarseGraining
        << " (a parcel stands for " << pow3(state_.coarseGraining) << ")" << nl
        << "    mean spacing     " << state_.spacing << " m, solid fraction "
        << placedFraction() << nl
        << "    friction         " << friction(placedFraction())
        << " N s/m" << (frictionIsLocal() ? ", follows alpha.clay" : "") << nl
        << "    cutOff           " << cutOff_ << " m ("
        << said(properties_.cutOff()) << "), "
        << cutOff_/state_.spacing << " spacings; force left out "
        << forceLeftOut(state_.placedAt) << nl
        << "    skin             ";
    if (properties_.skin() > 0)
    {
        os  << properties_.skin() << " m (given)" << nl;
    }
    else
    {
        os  << "auto, by how fast platelets move" << nl;
    }
    os  << "    kernel           " << kernelName.c_str() << nl
        << "    integrator       " << settings_.integrator.c_str()
        << (
               settings_.integrator == "auto"
             ? " (RKC2 or BogackiShampine)" : ""
           )
        << ", engineDeltaT "
        << said(properties_.engineDeltaT()) << nl
        << "    filter length    " << filterLength() << " m ("
        << said(properties_.filterLength()) << "), time scale "
        << properties_.filterTimeScale() << " s" << nl
        << "    tolerance        " << properties_.tolerance() << nl << nl;

    effects_.print(os);
}
