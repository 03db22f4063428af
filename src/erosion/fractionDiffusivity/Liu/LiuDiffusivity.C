/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "LiuDiffusivity.H"
#include "diffusivity.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fractionDiffusivities
{
    defineTypeNameAndDebug(LiuDiffusivity, 0);
    addToRunTimeSelectionTable(fractionDiffusivity, LiuDiffusivity, dictionary);
}
}

namespace
{

class LiuInWater
:
    public Foam::fractionDiffusivity::inWater
{
    const Foam::colloid::diffusivity law_;

public:

    explicit LiuInWater(const Foam::colloid::diffusivity& law)
    :
        law_(law)
    {}

    virtual Foam::scalar value(const Foam::scalar alpha) const
    {
        return law_.value(alpha);
    }

    virtual Foam::scalar pressureSlope(const Foam::scalar alpha) const
    {
        return law_.timesFriction(alpha);
    }
};

} // End anonymous namespace


Foam::fractionDiffusivities::LiuDiffusivity::LiuDiffusivity
(
    const dictionary& dict,
    const colloid::clayProperties& matter
)
:
    fractionDiffusivity(dict, {"doubleLayer"}),
    matter_(matter),
    doubleLayer_(dict.subOrEmptyDict("doubleLayer"))
{}


Foam::autoPtr<Foam::fractionDiffusivity::inWater>
Foam::fractionDiffusivities::LiuDiffusivity::at
(
    const colloid::water& solution
) const
{
    return autoPtr<inWater>
    (
        new LiuInWater
        (
            colloid::diffusivity
            (
                matter_.clay(),
                solution,
                *matter_.newDoubleLayer(doubleLayer_, solution),
                *matter_.newFriction(solution)
            )
        )
    );
}


void Foam::fractionDiffusivities::LiuDiffusivity::describe(Ostream& os) const
{
    os  << "platelets as stacked sheets (TR-17-13 eq. 3-4)";
}
