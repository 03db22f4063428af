/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "uniformFlow.H"
#include "checkWords.H"
#include "readInRange.H"
#include "unreadField.H"
#include "linear.H"
#include "wallPolyPatch.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fractureFlows
{
    defineTypeNameAndDebug(uniformFlow, 0);
    addToRunTimeSelectionTable(fractureFlow, uniformFlow, dictionary);
}
}


void Foam::fractureFlows::uniformFlow::warnOfWallsInTheWay() const
{
    const vector velocity(velocity_->value(mesh().time().value()));

    const polyBoundaryMesh& patches = mesh().boundaryMesh();

    // The sums are collective, and ranks differ in processor patches only
    for (label patchi = 0; patchi < patches.nNonProcessor(); ++patchi)
    {
        const polyPatch& pp = patches[patchi];

        const scalar outflow = gSum(mag(velocity & pp.faceAreas()));

        const scalar largest = mag(velocity)*gSum(mag(pp.faceAreas()));

        // 1e-6: what blockMesh leaves of a plane wall in ascii points
        if (isA<wallPolyPatch>(pp) && outflow > 1e-6*largest)
        {
            WarningInFunction
                << "The uniform flow passes through wall patch " << pp.name()
                << nl << "    A flow that goes round it: model Stokes" << endl;
        }
    }
}


Foam::fractureFlows::uniformFlow::uniformFlow
(
    fvMesh& mesh,
    const volScalarField& alpha,
    const dictionary& coeffs
)
:
    fractureFlow(mesh, alpha, coeffs, IOobject::NO_READ)
{
    colloid::checkWords(coeffs, wordList({"U", "UCoeffs"}));
    colloid::sayUnread
    (
        mesh.time(), "U", "U of uniformCoeffs (fractureFlowProperties) is"
    );
    colloid::sayUnread(mesh.time(), "p", "model uniform has no pressure");
    velocity_ = colloid::readFunction1<vector>(coeffs, "U", "m/s");

    warnOfWallsInTheWay();
}


void Foam::fractureFlows::uniformFlow::solve()
{
    URef() == dimensionedVector
    (
        "U",
        dimVelocity,
        velocity_->value(mesh().time().value())
    );

    phiRef() = linearInterpolate(U()) & mesh().Sf();
}
