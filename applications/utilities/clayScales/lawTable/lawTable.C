/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lawTable.H"

#include <iomanip>
#include <ostream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::lawTable::writeRow
(
    std::ostream& os,
    const scalar gap,
    const scalar fraction
) const
{
    const scalar values[] =
    {
        gap,
        fraction,
        water_.inverseDebyeLength(),
        water_.surfacePotential(clay_),
        compression_.midPotential(gap),
        doubleLayer_->force(gap),
        vanDerWaals_.force(gap),
        friction_.value(fraction),
        diffusivity_.value(fraction),
        viscosity_.coVolumeFraction(fraction),
        viscosity_.uncappedViscosity(fraction)
    };

    const char* separator = "";

    for (const scalar value : values)
    {
        os  << separator << value;
        separator = ",";
    }

    os  << '\n';
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::lawTable::lawTable
(
    const colloid::clayProperties& properties,
    const colloid::water& solution,
    const dictionary& doubleLayerModel
)
:
    clay_(properties.clay()),
    water_(solution),
    doubleLayer_(properties.newDoubleLayer(doubleLayerModel, solution)),
    compression_(clay_, solution),
    vanDerWaals_(clay_),
    friction_(clay_, solution, properties.Kozeny()),
    diffusivity_(clay_, solution, *doubleLayer_, friction_),
    viscosity_(properties.viscosity(solution))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::lawTable::write
(
    std::ostream& os,
    const UList<scalar>& gaps,
    const UList<scalar>& fractions
) const
{
    os  << "gap,fraction,inverseDebyeLength,surfacePotential,midPotential,"
        << "doubleLayerForce,vanDerWaalsForce,friction,diffusivity,coVolume,"
        << "relativeViscosity\n"
        << std::scientific << std::setprecision(14);

    for (const scalar gap : gaps)
    {
        writeRow(os, gap, clay_.stackFraction(gap));
    }

    for (const scalar fraction : fractions)
    {
        writeRow(os, clay_.stackGap(fraction), fraction);
    }
}


// ************************************************************************* //
