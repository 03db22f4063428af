/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noFlow.H"
#include "checkWords.H"
#include "unreadField.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fractureFlows
{
    defineTypeNameAndDebug(noFlow, 0);
    addToRunTimeSelectionTable(fractureFlow, noFlow, dictionary);
}
}


Foam::fractureFlows::noFlow::noFlow
(
    fvMesh& mesh,
    const volScalarField& alpha,
    const dictionary& coeffs
)
:
    fractureFlow(mesh, alpha, coeffs, IOobject::NO_READ)
{
    colloid::checkWords(coeffs, wordList());
    colloid::sayUnread(mesh.time(), "U", "model none, the water is at rest");
    colloid::sayUnread(mesh.time(), "p", "model none has no pressure");

    // phi may have been left in the time directory by another model
    phiRef() = dimensionedScalar(phi().dimensions(), Zero);
}


void Foam::fractureFlows::noFlow::solve()
{}
