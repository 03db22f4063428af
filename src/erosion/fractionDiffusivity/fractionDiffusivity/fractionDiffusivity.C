/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fractionDiffusivity.H"
#include "checkWords.H"

namespace Foam
{
    defineTypeNameAndDebug(fractionDiffusivity, 0);
    defineRunTimeSelectionTable(fractionDiffusivity, dictionary);
}


Foam::fractionDiffusivity::fractionDiffusivity
(
    const dictionary& dict,
    wordList validWords
)
{
    validWords.append("model");
    validWords.append("negative");
    colloid::checkWords(dict, validWords);

    const word negative
    (
        dict.getOrDefault<word>("negative", "equilibrium", keyType::LITERAL)
    );
    colloid::checkChoice
    (
        dict, "negative", negative, wordList({"equilibrium", "refuse"})
    );
    refusesNegative_ = negative == "refuse";
}


Foam::autoPtr<Foam::fractionDiffusivity> Foam::fractionDiffusivity::New
(
    const dictionary& dict,
    const colloid::clayProperties& matter
)
{
    const word model(dict.get<word>("model", keyType::LITERAL));

    colloid::checkChoice
    (
        dict, "model", model, dictionaryConstructorTablePtr_->sortedToc()
    );

    auto constructor = *dictionaryConstructorTablePtr_->cfind(model);
    auto diffusivity = constructor(dict, matter);

    Info<< "Diffusivity " << model << ": ";
    diffusivity->describe(Info);
    Info<< endl;

    return diffusivity;
}
