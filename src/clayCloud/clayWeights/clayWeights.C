/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayWeights.H"

namespace
{

//- Cost of a platelet in cells of the flow
constexpr Foam::scalar perPlatelet = 20;

} // End anonymous namespace


bool Foam::writeClayWeights
(
    const fvMesh& mesh,
    const Cloud<clayPlatelet>& cloud
)
{
    volScalarField weights
    (
        IOobject
        (
            "clayWeights",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar("1", dimless, 1)
    );
    for (const clayPlatelet& platelet : cloud)
    {
        weights[platelet.cell()] += perPlatelet;
    }
    return weights.write();
}
