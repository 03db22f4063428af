/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scaleTable.H"
#include "coagulation.H"
#include "SubList.H"

#include <algorithm>
#include <cmath>
#include <iomanip>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr int whatWidth = 34;
constexpr int unitWidth = 9;
constexpr int valueWidth = 11;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::scaleTable::line
(
    Ostream& os,
    const char* what,
    const char* unit,
    const UList<scalar>& fractions,
    const law& value
) const
{
    std::ostringstream text;
    text<< "  " << std::left << std::setw(whatWidth) << what
        << std::setw(unitWidth) << unit << std::right << std::setprecision(4);

    for (const scalar fraction : fractions)
    {
        const scalar v = value(fraction);
        text<< std::setw(valueWidth);

        // A length of no rim, a ratio to no force
        if (std::isnan(v) || mag(v) >= GREAT)
        {
            text<< '-';
        }
        else
        {
            text<< v;
        }
    }

    os  << text.str().c_str() << nl;
}


void Foam::scaleTable::line
(
    Ostream& os,
    const char* what,
    const scalar value,
    const char* unit
) const
{
    line(os, what, unit, UList<scalar>(const_cast<scalar*>(&value), 1),
        [](const scalar v) { return v; });
}


void Foam::scaleTable::writeWater(Ostream& os) const
{
    const colloid::coagulation coagulation(properties_, doubleLayerModel_);
    const auto critical = coagulation.critical();
    const auto negative = coagulation.negative(water_.concentration);

    os  << "Water and platelet" << nl;
    line(os, "cation concentration", water_.concentration, "mol/m3");
    line(os, "Debye length", scales_.DebyeLength(), "m");
    line(os, "surface potential e psi/kT",
        water_.surfacePotential(properties_.clay()), "");
    line(os, "thermal energy kT", water_.thermalEnergy(), "J");
    line(os, "friction of a lone platelet", friction_->value(0), "N s/m");
    line(os, "diffusivity of a lone platelet", diffusivity_.value(0), "m2/s");
    line(os, "inertial time m/xi", scales_.inertialTime(0), "s");
    line(os, "settling velocity, alone", scales_.settlingVelocity(0), "m/s");

    if (viscosity_.gels())
    {
        line(os, "does not flow above fraction", viscosity_.gelFraction(), "");
    }

    if (critical.found)
    {
        line(os, "coagulates above (CCC)", critical.concentration, "mol/m3");
        line(os, "    first at fraction", critical.fraction, "");
    }
    else
    {
        os  << "  does not coagulate below 6000 mol/m3" << nl;
    }

    if (negative.found)
    {
        os  << nl
            << "  Above the CCC: aggregates, not a gel or sol; laws of repulsion"
            << " hold pairwise" << nl
            << "  D < 0, clay does not spread" << nl;
        line(os, "    from fraction", negative.lower, "");
        line(os, "    to fraction", negative.upper, "");
    }
}


void Foam::scaleTable::writeFractions
(
    Ostream& os,
    const UList<scalar>& phi
) const
{
    const colloid::platelet& clay = properties_.clay();

    os  << nl;
    line(os, "Solid fraction", "", phi, [](scalar f) { return f; });
    line(os, "spacing, stack delta/phi", "m", phi,
        [&](scalar f) { return clay.stackSpacing(f); });
    line(os, "spacing L, cubic (V/phi)^(1/3)", "m", phi,
        [&](scalar f) { return scales_.spacing(f); });
    line(os, "double layer force at L", "N", phi,
        [&](scalar f)
        { return doubleLayer_->force(scales_.gapAtSpacing(f)); });
    line(os, "van der Waals / double layer at L", "", phi,
        [&](scalar f) { return attractionOverRepulsion(f); });

    std::ostringstream range;
    range << "range of " << run_.tolerance << " of the force at L";
    line(os, range.str().c_str(), "spacings", phi,
        [&](scalar f)
        { return scales_.rangeInSpacings(run_.tolerance, f); });

    line(os, "kT/(F L)", "", phi,
        [&](scalar f) { return scales_.thermalOverForce(f); });
    line(os, "friction xi", "N s/m", phi,
        [&](scalar f) { return friction_->value(f); });
    line(os, "Kozeny-Carman / Stokes friction", "", phi,
        [&](scalar f)
        { return scales_.KozenyCarmanOverStokes(properties_.Kozeny(), f); });
    line(os, "settling / water velocity", "", phi,
        [&](scalar f) { return scales_.settlingOverFlow(f, run_.velocity); });
    line(os, "diffusivity D (eq. 3-4)", "m2/s", phi,
        [&](scalar f) { return diffusivity_.value(f); });
    line(os, "co-volume fraction p", "", phi,
        [&](scalar f) { return viscosity_.coVolumeFraction(f); });
    line(os, "relative viscosity, no gel stop", "", phi,
        [&](scalar f) { return viscosity_.uncappedViscosity(f); });
    line(os, "dt_crit, Euler, stack", "s", phi,
        [&](scalar f)
        { return scales_.criticalTimeStep(clay.stackGap(f), f); });
    line(os, "Stokes number, stack", "", phi,
        [&](scalar f) { return scales_.StokesNumber(clay.stackGap(f), f); });
}


void Foam::scaleTable::writeRim(Ostream& os, const UList<scalar>& phi) const
{
    os  << nl << "Rim of a gel of this fraction: -length " << run_.length
        << " m, -velocity " << run_.velocity << " m/s" << nl;

    line(os, "viscosity at the gel's edge", "", phi,
        [&](scalar f) { return edgeViscosity(f); });
    line(os, "rim thickness (eq. 3-33)", "m", phi,
        [&](scalar f) { return rimThickness(f); });
    line(os, "time thickness^2/D (eq. 3-38)", "s", phi,
        [&](scalar f)
        {
            return colloid::scales::rimDiffusionTime
            (
                rimThickness(f), diffusivity_.value(f)
            );
        });
    line(os, "steady after 0.7 Lx eta_r/u0", "s", phi,
        [&](scalar f)
        {
            return colloid::scales::rimSteadyTime
            (
                run_.length, run_.velocity, edgeViscosity(f)
            );
        });
}


void Foam::scaleTable::writeCost(Ostream& os, const UList<scalar>& phi) const
{
    const law hours = [&](scalar f)
    {
        return
            rims(f)
          ? rimPlatelets(f)*rimSteps(f)*run_.secondsPerParticleStep/3600
          : GREAT;
    };

    os  << nl << "Cost of this rim until steady, 2.1 cut-offs deep, at "
        << run_.secondsPerParticleStep << " s of a" << nl
        << "core per platelet and step (default 1e-6: TR-17-13); clayFoam's"
        << " last lines" << nl
        << "tell your own figure, give it as -secondsPerParticleStep" << nl;

    line(os, "platelets", "", phi,
        [&](scalar f) { return rimPlatelets(f); });
    line(os, "engine step", "s", phi,
        [&](scalar f) { return scales_.engineTimeStep(f); });
    line(os, "engine steps", "", phi,
        [&](scalar f) { return rimSteps(f); });
    line(os, "core time, every platelet", "h", phi, hours);

    // Depth and step follow the parcels: parcels as alpha^-2, steps as
    // alpha^-2
    line(os, "coarseGraining for one core hour", "", phi,
        [&](scalar f)
        {
            return
                rims(f) ? std::pow(max(hours(f), scalar(1)), 0.25) : GREAT;
        });
}


void Foam::scaleTable::writeNotes(Ostream& os, const UList<scalar>& phi) const
{
    const auto any = [&](const auto& is)
    {
        return std::any_of(phi.begin(), phi.end(), is);
    };

    if (any([&](scalar f) { return !rims(f); }))
    {
        os  << nl
            << "  D < 0: van der Waals attraction outweighs repulsion there"
            << " (coagulation);" << nl
            << "  '-': there is no rim, and no time or cost of one" << nl;
    }

    if (any([&](scalar f) { return attractionOverRepulsion(f) >= GREAT; }))
    {
        os  << nl << "  '-' of van der Waals / double layer: above " << GREAT
            << ", no repulsion is left at L" << nl;
    }
}


bool Foam::scaleTable::rims(const scalar fraction) const
{
    return diffusivity_.value(fraction) > 0;
}


Foam::scalar Foam::scaleTable::attractionOverRepulsion
(
    const scalar fraction
) const
{
    return scales_.vanDerWaalsOverDoubleLayer(scales_.gapAtSpacing(fraction));
}


Foam::scalar Foam::scaleTable::edgeViscosity(const scalar fraction) const
{
    return viscosity_.uncappedViscosity
    (
        viscosity_.gels() ? min(fraction, viscosity_.gelFraction()) : fraction
    );
}


Foam::scalar Foam::scaleTable::rimThickness(const scalar fraction) const
{
    return
        rims(fraction)
      ? colloid::scales::rimThickness
        (
            run_.length,
            run_.velocity,
            diffusivity_.value(fraction),
            edgeViscosity(fraction)
        )
      : GREAT;
}


Foam::scalar Foam::scaleTable::rimPlatelets(const scalar fraction) const
{
    const scalar depth =
        2.1*scales_.rangeInSpacings(run_.tolerance, fraction)
       *scales_.spacing(fraction);

    return
        0.5*fraction*run_.length*rimThickness(fraction)*depth
       /properties_.clay().volume();
}


Foam::scalar Foam::scaleTable::rimSteps(const scalar fraction) const
{
    return
        colloid::scales::rimSteadyTime
        (
            run_.length, run_.velocity, edgeViscosity(fraction)
        )
       /scales_.engineTimeStep(fraction);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::scaleTable::scaleTable
(
    const colloid::clayProperties& properties,
    const colloid::water& solution,
    const dictionary& doubleLayerModel,
    const run& whatToRun
)
:
    properties_(properties),
    water_(solution),
    doubleLayerModel_(doubleLayerModel),
    run_(whatToRun),
    doubleLayer_(properties.newDoubleLayer(doubleLayerModel, solution)),
    friction_
    (
        properties.newFriction
        (
            properties.frictionModel() == "auto"
          ? word("KozenyCarman")
          : properties.frictionModel(),
            solution
        )
    ),
    scales_(properties.clay(), solution, *doubleLayer_, *friction_),
    diffusivity_(properties.clay(), solution, *doubleLayer_, *friction_),
    viscosity_(properties.viscosity(solution))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::scaleTable::write
(
    Ostream& os,
    const UList<scalar>& fractions
) const
{
    writeWater(os);

    const label columns = 3;

    for (label from = 0; from < fractions.size(); from += columns)
    {
        const SubList<scalar> phi
        (
            fractions, min(columns, fractions.size() - from), from
        );

        writeFractions(os, phi);
        writeRim(os, phi);
        writeCost(os, phi);
        writeNotes(os, phi);
    }

    os  << endl;
}


// ************************************************************************* //
