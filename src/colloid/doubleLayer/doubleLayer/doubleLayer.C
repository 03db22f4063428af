/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "doubleLayer.H"
#include "checkWords.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace colloid
{
    defineTypeNameAndDebug(doubleLayer, 0);
    defineRunTimeSelectionTable(doubleLayer, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::colloid::doubleLayer> Foam::colloid::doubleLayer::New
(
    const dictionary& dict,
    const platelet& clay,
    const water& solution
)
{
    const word model
    (
        dict.getOrDefault<word>("model", "compression", keyType::LITERAL)
    );

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
