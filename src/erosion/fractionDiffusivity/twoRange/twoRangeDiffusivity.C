/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoRangeDiffusivity.H"
#include "readInRange.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fractionDiffusivities
{
    defineTypeNameAndDebug(twoRangeDiffusivity, 0);
    addToRunTimeSelectionTable
    (
        fractionDiffusivity, twoRangeDiffusivity, dictionary
    );
}
}

namespace
{

class gelOrSol
:
    public Foam::fractionDiffusivity::inWater
{
    const Foam::scalar gel_;
    const Foam::scalar sol_;
    const Foam::scalar fraction_;

public:

    gelOrSol
    (
        const Foam::scalar gel,
        const Foam::scalar sol,
        const Foam::scalar fraction
    )
    :
        gel_(gel),
        sol_(sol),
        fraction_(fraction)
    {}

    virtual Foam::scalar value(const Foam::scalar alpha) const
    {
        return alpha >= fraction_ ? gel_ : sol_;
    }
};

} // End anonymous namespace


Foam::fractionDiffusivities::twoRangeDiffusivity::twoRangeDiffusivity
(
    const dictionary& dict,
    const colloid::clayProperties&
)
:
    fractionDiffusivity(dict, {"gel", "sol", "fraction"}),
    gel_(colloid::readInRange(dict, "gel", 1e-20, 1, "m2/s")),
    sol_(colloid::readInRange(dict, "sol", 1e-20, 1, "m2/s")),
    fraction_(colloid::readInRange(dict, "fraction", 1e-6, 0.9, "(-)"))
{}


Foam::autoPtr<Foam::fractionDiffusivity::inWater>
Foam::fractionDiffusivities::twoRangeDiffusivity::at
(
    const colloid::water&
) const
{
    return autoPtr<inWater>(new gelOrSol(gel_, sol_, fraction_));
}


void Foam::fractionDiffusivities::twoRangeDiffusivity::describe
(
    Ostream& os
) const
{
    os  << gel_ << " m2/s from the fraction " << fraction_ << " on, below "
        << sol_ << " m2/s";
}
