/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceGap.H"
#include "error.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::colloid::refuseGap(const scalar gap)
{
    FatalErrorInFunction
        << "Gap " << gap << " m between two faces" << nl
        << "Double layer and van der Waals forces need a positive gap" << nl
        << exit(FatalError);
}


void Foam::colloid::requireFraction(const scalar fraction)
{
    if (!(fraction >= 0 && fraction < 1))
    {
        FatalErrorInFunction
            << "Solid fraction " << fraction << nl
            << "Valid: from 0 to below 1" << nl
            << exit(FatalError);
    }
}


// ************************************************************************* //
