/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fractureFlow.H"
#include "checkWords.H"

Foam::autoPtr<Foam::fractureFlow> Foam::fractureFlow::New
(
    fvMesh& mesh,
    const volScalarField& alpha
)
{
    IOobject io
    (
        "fractureFlowProperties",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        FatalErrorInFunction
            << "No " << io.objectPath() << " that can be read" << nl
            << "It says how the water flows; for water at rest it holds the"
            << " line    model none;"
            << exit(FatalError);
    }

    return New(mesh, alpha, IOdictionary(io));
}


Foam::autoPtr<Foam::fractureFlow> Foam::fractureFlow::New
(
    fvMesh& mesh,
    const volScalarField& alpha,
    const dictionary& properties
)
{
    // The coefficients of models that are not in use may stay in the file
    const wordList models(dictionaryConstructorTablePtr_->sortedToc());
    wordList validWords(1, "model");

    for (const word& model : models)
    {
        validWords.append(model + "Coeffs");
    }
    colloid::checkWords(properties, validWords);

    const word model(properties.get<word>("model"));

    colloid::checkChoice(properties, "model", model, models);

    Info<< "Flow model " << model << endl;

    auto constructor = *dictionaryConstructorTablePtr_->cfind(model);

    const word coeffsName(model + "Coeffs");

    if (properties.found(coeffsName))
    {
        return constructor(mesh, alpha, properties.subDict(coeffsName));
    }

    // Named, so that an error about a missing entry names the file
    dictionary noCoeffs;
    noCoeffs.name() = properties.name()/coeffsName;

    return constructor(mesh, alpha, noCoeffs);
}
