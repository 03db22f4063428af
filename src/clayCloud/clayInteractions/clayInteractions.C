/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayInteractions.H"
#include "doubleLayer.H"
#include "errorAt.H"
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
    clayState& state,
    const periodicAxes& axes,
    const vector& g
)
:
    matter_(matter),
    properties_(properties),
    axes_(axes),
    g_(g),
    state_(state),
    weight_(Zero),
    warned_(false)
{
    chooseUnits();
    decide();

    if (properties_.cutOff() > 0 && properties_.cutOff() < state_.spacing)
    {
        IOWarningInFunction(properties_.dict().subDict("solution"))
            << "cutOff is " << properties_.cutOff() << " m, less than the mean"
            << " spacing of " << state_.spacing << " m:" << nl
            << "    platelets at their places do not act on each other" << nl
            << endl;
    }
}


Foam::scalar Foam::clayInteractions::thickness() const
{
    return state_.coarseGraining*matter_.clay().thickness;
}


Foam::scalar Foam::clayInteractions::parcelVolume() const
{
    return pow3(state_.coarseGraining)*matter_.clay().volume();
}


Foam::scalar Foam::clayInteractions::fractionAt(const scalar spacing) const
{
    return min(parcelVolume()/pow3(spacing), scalar(0.99));
}


Foam::scalar Foam::clayInteractions::spacingAt(const scalar fraction) const
{
    return Foam::cbrt(parcelVolume()/fraction);
}


Foam::scalar Foam::clayInteractions::pairForce
(
    const scalar spacing,
    const scalar time
) const
{
    return pairLaw(time).force(spacing - thickness());
}


Foam::scalar Foam::clayInteractions::latticePressure
(
    const scalar spacing,
    const scalar time
) const
{
    const scalar thermal =
        BrownianOn_
      ? state_.coarseGraining*matter_.waterAt(time).thermalEnergy() : 0;

    return
        thermal/pow3(spacing)
      + colloid::scales::latticePressure(pairLaw(time), spacing, thickness());
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


void Foam::clayInteractions::chooseUnits()
{
    using choice = cloudProperties::choice;

    // Of what may act, whatever counts now
    doubleLayerOn_ = properties_.effect("doubleLayer") != choice::off;
    vanDerWaalsOn_ = properties_.effect("vanDerWaals") == choice::on;

    const scalar time = state_.placedAt;
    const colloid::water water(matter_.waterAt(time));
    const scalar spacing = state_.spacing;

    // Where the forces are nothing (far apart in salt water), the thermal one
    const scalar force = max
    (
        mag(pairLaw(time).force(spacing - thickness())),
        state_.coarseGraining*water.thermalEnergy()/spacing
    );
    const scalar friction =
        state_.coarseGraining*matter_.newFriction("Stokes", water)->value(0);

    units_.reset(new reducedUnits(spacing, force, friction));
}


Foam::scalar Foam::clayInteractions::cutOffAt(const scalar spacing) const
{
    if (properties_.cutOff() > 0)
    {
        return properties_.cutOff();
    }

    const colloid::pairInteraction law(pairLaw(state_.decidedAt));
    const scalar furthest = cbrt
    (
        properties_.maxNeighbours()/(4*constant::mathematical::pi/3)
    );
    const scalar thermalEnergy =
        BrownianOn_
      ? state_.coarseGraining
       *matter_.waterAt(state_.decidedAt).thermalEnergy()
      : 0;

    // For clay that has spread by a factor: the tolerance of its pressure,
    // with n kT where platelets move at random
    const auto longEnough = [&](const scalar spread)
    {
        const scalar distance = spread*spacing;
        const scalar work =
            distance*mag(law.force(distance - thickness()));

        return spread*colloid::scales::cutOffInSpacings
        (
            law,
            distance,
            thickness(),
            properties_.tolerance()*(1 + thermalEnergy/max(work, VSMALL))
        );
    };

    // Also as at the edge of a gel, where a larger share is beyond
    const scalar spacings =
        min(furthest, max(longEnough(1), longEnough(1.5)));

    // The taper of the last tenth takes about half of what is there
    return max(spacings, scalar(1.5))/0.95*spacing;
}


void Foam::clayInteractions::chooseCutOff()
{
    scalar halfPeriod = GREAT;
    for (direction axis = 0; axis < 3; ++axis)
    {
        if (axes_.periodic(axis))
        {
            halfPeriod = min(halfPeriod, 0.5*axes_.period(axis));
        }
    }

    if (properties_.cutOff() > halfPeriod)
    {
        colloid::errorAt(properties_.dict().subDict("solution"), "cutOff")
            << "cutOff is " << properties_.cutOff() << " m, but the periodic"
            << " box is only " << 2*halfPeriod << " m wide." << nl
            << "    At most half of that, or a larger mesh"
            << exit(FatalIOError);
    }

    if (properties_.cutOff() > 0 && properties_.cutOff() <= thickness())
    {
        colloid::errorAt(properties_.dict().subDict("solution"), "cutOff")
            << "cutOff is " << properties_.cutOff() << " m, not longer than the"
            << " thickness of a "
            << (state_.coarseGraining > 1 ? "parcel" : "platelet") << ", "
            << thickness() << " m." << nl
            << "    It is a distance of centres: at least the mean spacing, "
            << state_.decidedSpacing << " m, or auto" << exit(FatalIOError);
    }

    // Few platelets in open space: all pairs, however far they move apart
    const bool allPairs =
        properties_.cutOff() < 0
     && halfPeriod == GREAT
     && state_.entered <= properties_.maxNeighbours()
     && properties_.inlets().empty();

    cutOff_ =
        allPairs
      ? 1e3*max(scalar(state_.entered), scalar(1))*state_.spacing
      : min(cutOffAt(state_.decidedSpacing), halfPeriod);

    if (properties_.skin() > cutOff_)
    {
        colloid::errorAt(properties_.dict().subDict("solution"), "skin")
            << "skin is " << properties_.skin() << " m, wider than the cut-off"
            << " of " << cutOff_ << " m." << nl
            << "    At most that, or auto" << exit(FatalIOError);
    }
}


Foam::scalar Foam::clayInteractions::pressureLeftOut(const scalar time) const
{
    return colloid::scales::pressureBeyond
    (
        0.95*cutOff_/state_.decidedSpacing,
        pairLaw(time),
        state_.decidedSpacing,
        thickness()
    );
}


plateletDynamics::engineSettings Foam::clayInteractions::engineFor
(
    const scalar spacing,
    const scalar cutOff
) const
{
    using plateletDynamics::engineSettings;

    engineSettings settings;
    settings.thickness = thickness()/units_->length();
    settings.cutOff = cutOff/units_->length();
    settings.spacing = spacing/units_->length();
    settings.skin = max(properties_.skin(), scalar(0))/units_->length();
    settings.pairKernel =
        properties_.exactKernel() || cutOff > 100*spacing
      ? engineSettings::kernel::exact
      : engineSettings::kernel::fast;
    // The same from 1e-3 to 1e-2: single precision does not give much more
    const scalar tolerance = properties_.tolerance();
    settings.tableTolerance = max(1e-3*tolerance, min(1e-5, 1e-2*tolerance));
    settings.integrator = properties_.integrator();
    settings.stepTolerance = 1e-1*properties_.tolerance();
    settings.deltaT =
        max(properties_.engineDeltaT(), scalar(0))/units_->time();
    settings.seed = properties_.seed();

    if (BrownianOn_)
    {
        const colloid::water water(matter_.waterAt(state_.decidedAt));
        settings.thermalEnergy =
            state_.coarseGraining*water.thermalEnergy()
           /(units_->force()*units_->length());

        // A random displacement is small against the length over which forces
        // change: the bias of the distribution goes as its fourth power
        const scalar length =
            doubleLayerOn_
          ? min
            (
                state_.coarseGraining/water.inverseDebyeLength(),
                spacing
            )
          : spacing;
        settings.thermalStep =
            min(pow(properties_.tolerance(), 0.25)*length, 0.1*cutOff)
           /units_->length();
    }
    return settings;
}


plateletDynamics::engineSettings Foam::clayInteractions::engineAt
(
    const scalar spacing
) const
{
    plateletDynamics::engineSettings settings
    (
        engineFor(spacing, cutOffAt(spacing))
    );

    // A step for the case may be too long here
    settings.deltaT = 0;
    return settings;
}


std::shared_ptr<const plateletDynamics::gapForce>
Foam::clayInteractions::force(const scalar time) const
{
    // A cut-off of the water at the start may not do for dilute water
    const scalar leftOut = pressureLeftOut(time);

    if
    (
        leftOut
      > 2*pressureLeftOut(state_.decidedAt) + properties_.tolerance()
    )
    {
        if (!warned_)
        {
            WarningInFunction
                << "At " << time << " s the cut-off of " << cutOff_
                << " m leaves out " << leftOut << " of the osmotic pressure."
                << nl
                << "    Set cutOff (clayCloudProperties) for the most dilute"
                << " water of the run" << nl << endl;
        }
        warned_ = true;
    }

    return std::make_shared<reducedForce>(pairLaw(time), *units_);
}


std::string Foam::clayInteractions::forcesAre() const
{
    return
        doubleLayerOn_ && vanDerWaalsOn_ ? "doubleLayer and vdW"
      : doubleLayerOn_ ? "doubleLayer"
      : vanDerWaalsOn_ ? "vanDerWaals" : "forces";
}


Foam::scalar Foam::clayInteractions::friction(const scalar fraction) const
{
    return state_.coarseGraining*friction_->value(fraction);
}


Foam::scalar Foam::clayInteractions::mobilitySlope(const scalar fraction) const
{
    return -friction_->slope(fraction)/friction_->value(fraction);
}


Foam::scalar Foam::clayInteractions::diffusivity() const
{
    return
        BrownianOn_
      ? matter_.waterAt(state_.decidedAt).thermalEnergy()/friction_->value(0)
      : 0;
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
        << "    mean spacing     " << state_.decidedSpacing
        << " m, solid fraction " << fractionAt(state_.decidedSpacing) << nl
        << "    friction         " << friction(fractionAt(state_.decidedSpacing))
        << " N s/m" << (frictionIsLocal() ? ", follows alpha.clay" : "") << nl
        << "    cutOff           " << cutOff_ << " m ("
        << said(properties_.cutOff()) << "), "
        << cutOff_/state_.decidedSpacing << " spacings; pressure left out "
        << pressureLeftOut(state_.decidedAt) << nl
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
               settings_.integrator != "auto" ? ""
             : BrownianOn_ ? " (LeimkuhlerMatthews)"
             : " (RKC2 or BogackiShampine)"
           )
        << ", engineDeltaT "
        << said(properties_.engineDeltaT()) << nl
        << "    seed             " << properties_.seed()
        << (BrownianOn_ ? "" : " (not in use)") << nl
        << "    filter length    " << filterLength() << " m ("
        << said(properties_.filterLength()) << "), time scale "
        << properties_.filterTimeScale() << " s" << nl
        << "    tolerance        " << properties_.tolerance() << nl << nl;

    effects_.print(os);
}
