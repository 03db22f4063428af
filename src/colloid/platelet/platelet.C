/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "platelet.H"

#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::platelet::faceArea() const
{
    return physicalConstants::pi*diameter*diameter/4;
}


Foam::scalar Foam::colloid::platelet::volume() const
{
    return faceArea()*thickness;
}


Foam::scalar Foam::colloid::platelet::specificSurface() const
{
    return 2/thickness + 4/diameter;
}


Foam::scalar Foam::colloid::platelet::mass() const
{
    return density*volume();
}


Foam::scalar Foam::colloid::platelet::frictionRadius() const
{
    // 4 S_p/(pi delta_p^2) = (diameter/thickness)^2
    const scalar aspect = diameter/thickness;
    const scalar q = std::sqrt((aspect - 1)*(aspect + 1));

    return 0.5*thickness*q/std::atan(q);
}


Foam::scalar Foam::colloid::platelet::stackSpacing(const scalar fraction) const
{
    return thickness/fraction;
}


Foam::scalar Foam::colloid::platelet::stackGap(const scalar fraction) const
{
    return thickness*(1 - fraction)/fraction;
}


Foam::scalar Foam::colloid::platelet::stackFraction(const scalar gap) const
{
    return thickness/(thickness + gap);
}


Foam::scalar Foam::colloid::platelet::cubicSpacing(const scalar fraction) const
{
    return std::cbrt(volume()/fraction);
}


// ************************************************************************* //
