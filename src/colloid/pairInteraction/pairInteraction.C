/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pairInteraction.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::colloid::pairInteraction::freeEnergy(const scalar gap) const
{
    return
        (doubleLayer_ ? doubleLayer_->energy(gap) : 0)
      - (vanDerWaals_ ? vanDerWaals_->energy(gap) : 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::pairInteraction::pairInteraction
(
    const platelet& clay,
    const water& solution,
    const doubleLayer* repulsion,
    const vanDerWaals* attraction,
    const scalar coarseGraining
)
:
    doubleLayer_(repulsion ? repulsion->clone().release() : nullptr),
    vanDerWaals_(attraction ? new vanDerWaals(*attraction) : nullptr),
    alpha_(coarseGraining),
    inverseAlpha_(1/coarseGraining),
    contactGap_(clay.contactGap),
    contactForce_(freeForce(contactGap_)),
    contactEnergy_(freeEnergy(contactGap_))
{
    const scalar barrier =
        10*solution.thermalEnergy()
      + std::max(scalar(0), -contactEnergy_)
      + std::max(scalar(0), -contactForce_)*contactGap_;

    contactStiffness_ = std::max
    (
        2*barrier/(contactGap_*contactGap_),
       -freeSlope(contactGap_)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::pairInteraction::energy(const scalar gap) const
{
    const scalar h = inverseAlpha_*gap;

    if (h < contactGap_)
    {
        const scalar depth = contactGap_ - h;

        return
            alpha_
           *(
                contactEnergy_
              + depth*(contactForce_ + 0.5*contactStiffness_*depth)
            );
    }

    return alpha_*freeEnergy(h);
}


// ************************************************************************* //
