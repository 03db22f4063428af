/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vanDerWaals.H"
#include "physicalConstants.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::vanDerWaals::vanDerWaals(const platelet& clay)
:
    thickness_(clay.thickness),
    scale_
    (
        clay.Hamaker*clay.faceArea()*clay.thickness*clay.thickness
       /(3*physicalConstants::pi)
    )
{}


// ************************************************************************* //
