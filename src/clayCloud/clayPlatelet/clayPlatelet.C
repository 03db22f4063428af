/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayPlatelet.H"
#include "clayCloud.H"

namespace Foam
{
    defineTemplateTypeNameAndDebug(Cloud<clayPlatelet>, 0);
}


Foam::clayPlatelet::clayPlatelet
(
    const polyMesh& mesh,
    const point& position,
    const label celli,
    const properties& what
)
:
    particle(mesh, position, celli),
    properties_(what)
{}


bool Foam::clayPlatelet::move
(
    clayCloud& cloud,
    trackingData& td,
    const scalar
)
{
    td.switchProcessor = false;
    td.keepParticle = true;

    while (!td.switchProcessor && stepFraction() < 1)
    {
        const scalar left = 1 - stepFraction();
        trackToAndHitFace(left*properties_.displacement, left, cloud, td);
    }

    return td.keepParticle;
}


bool Foam::clayPlatelet::hitPatch(clayCloud&, trackingData&)
{
    if (mesh().boundaryMesh()[patch()].coupled())
    {
        return false;
    }

    stepFraction() = 1;
    return true;
}


void Foam::clayPlatelet::hitProcessorPatch(clayCloud& cloud, trackingData& td)
{
    cloud.transferred();
    td.switchProcessor = true;
}
