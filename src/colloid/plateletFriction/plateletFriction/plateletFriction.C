/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "plateletFriction.H"
#include "checkWords.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace colloid
{
    defineTypeNameAndDebug(plateletFriction, 0);
    defineRunTimeSelectionTable(plateletFriction, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::colloid::plateletFriction>
Foam::colloid::plateletFriction::New
(
    const word& model,
    const dictionary& dict,
    const platelet& clay,
    const water& solution
)
{
    checkChoice
    (
        dict,
        "model",
        model,
        dictionaryConstructorTablePtr_->sortedToc()
    );

    return dictionaryConstructorTablePtr_->cfind(model)()
    (
        dict,
        clay,
        solution
    );
}


// ************************************************************************* //
