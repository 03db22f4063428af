/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "constantDiffusivity.H"
#include "readInRange.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fractionDiffusivities
{
    defineTypeNameAndDebug(constantDiffusivity, 0);
    addToRunTimeSelectionTable
    (
        fractionDiffusivity, constantDiffusivity, dictionary
    );
}
}

namespace
{

class sameEverywhere
:
    public Foam::fractionDiffusivity::inWater
{
    const Foam::scalar value_;

public:

    explicit sameEverywhere(const Foam::scalar value)
    :
        value_(value)
    {}

    virtual Foam::scalar value(const Foam::scalar) const
    {
        return value_;
    }
};

} // End anonymous namespace


Foam::fractionDiffusivities::constantDiffusivity::constantDiffusivity
(
    const dictionary& dict,
    const colloid::clayProperties&
)
:
    fractionDiffusivity(dict, {"value"}),
    value_(colloid::readInRange(dict, "value", 1e-20, 1, "m2/s"))
{}


Foam::autoPtr<Foam::fractionDiffusivity::inWater>
Foam::fractionDiffusivities::constantDiffusivity::at
(
    const colloid::water&
) const
{
    return autoPtr<inWater>(new sameEverywhere(value_));
}


void Foam::fractionDiffusivities::constantDiffusivity::describe
(
    Ostream& os
) const
{
    os  << value_ << " m2/s";
}
