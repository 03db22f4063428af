/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimMatter.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rimMatter::rimMatter
(
    const colloid::clayProperties& properties,
    const dictionary& diffusivity,
    const scalar time
)
:
    properties_(properties),
    water_(properties.waterAt(time)),
    viscosity_(properties.viscosity(water_)),
    model_(fractionDiffusivity::New(diffusivity, properties)),
    D_(model_->at(water_).release())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::function<Foam::scalar(Foam::scalar)>
Foam::rimMatter::diffusivity() const
{
    return [D = D_](const scalar fraction) { return D->value(fraction); };
}


bool Foam::rimMatter::spreads(const scalar fraction) const
{
    constexpr label places = 500;

    for (label i = 1; i <= places; ++i)
    {
        if (!(D_->value(fraction*i/places) > 0))
        {
            return false;
        }
    }

    return true;
}


Foam::erosionBracket::matter Foam::rimMatter::laws() const
{
    return
        erosionBracket::matter::of(diffusivity(), D_->value(0), viscosity_);
}


Foam::erosionBracket Foam::rimMatter::bracket(const scalar edgeFraction) const
{
    return erosionBracket(laws(), edgeFraction);
}


// ************************************************************************* //
