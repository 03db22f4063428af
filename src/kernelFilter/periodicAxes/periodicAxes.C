/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodicAxes.H"

#include "PstreamReduceOps.H"
#include "SubField.H"
#include "cyclicPolyPatch.H"
#include "processorCyclicPolyPatch.H"

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

//- Relative to the extent of the mesh: how well blockMesh's, decomposePar's
//  and ascii files' digits let two faces match
constexpr scalar matching = 1e-5;

//- What a rank finds: error text, and per axis the smallest and the largest
//  separation of its faces
struct finding
{
    string refusal;
    vector least = vector::uniform(GREAT);
    vector most = vector::uniform(-GREAT);
};


const char* axisName(const direction axis)
{
    static const char* const names[] = {"x", "y", "z"};
    return names[axis];
}


//- Look at the pairs of faces of one cyclic patch
void lookAt
(
    const word& name,
    const vectorField& faceCentres,
    const vectorField& faceAreas,
    const vectorField& otherCentres,
    const vectorField& otherAreas,
    const scalar extent,
    finding& found
)
{
    forAll(faceCentres, facei)
    {
        const vector separation(otherCentres[facei] - faceCentres[facei]);

        direction axis = 0;
        for (direction i = 1; i < 3; ++i)
        {
            if (mag(separation[i]) > mag(separation[axis]))
            {
                axis = i;
            }
        }
        vector aside(separation);
        aside[axis] = 0;

        if
        (
            mag(faceAreas[facei] + otherAreas[facei])
          > 100*matching*mag(faceAreas[facei])
        )
        {
            found.refusal =
                "patch " + name + " is rotational (or its two sides are not "
                "the same): only translational cyclics are supported";
            return;
        }
        if (mag(aside) > matching*extent)
        {
            found.refusal =
                "patch " + name + " is not a translation along x, y or z: "
                "turn the mesh so that its periodic directions are axes";
            return;
        }

        const scalar period = mag(separation[axis]);
        found.least[axis] = min(found.least[axis], period);
        found.most[axis] = max(found.most[axis], period);
    }
}


void refuse(const string& reason)
{
    FatalErrorInFunction
        << "This mesh can't be treated as periodic: " << reason.c_str()
        << exit(FatalError);
}

} // End anonymous namespace

} // End namespace Foam


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

Foam::periodicAxes::periodicAxes(const polyMesh& mesh)
:
    bounds_(mesh.points(), true),
    periodic_(false)
{
    finding found;
    const scalar extent = bounds_.mag();

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            const auto& other =
                refCast<const cyclicPolyPatch>(patch).neighbPatch();
            lookAt
            (
                patch.name(),
                patch.faceCentres(),
                patch.faceAreas(),
                other.faceCentres(),
                other.faceAreas(),
                extent,
                found
            );
        }
        else if (isA<processorCyclicPolyPatch>(patch))
        {
            const auto& half = refCast<const processorCyclicPolyPatch>(patch);
            lookAt
            (
                half.referPatchName(),
                half.faceCentres(),
                half.faceAreas(),
                half.neighbFaceCentres(),
                half.neighbFaceAreas(),
                extent,
                found
            );
        }
        else if
        (
            isA<coupledPolyPatch>(patch)
        && !isA<processorPolyPatch>(patch)
        && found.refusal.empty()
        )
        {
            found.refusal =
                "patch " + patch.name() + " is of type " + patch.type()
              + ": only cyclic patches are supported";
        }
    }

    List<string> refusals(Pstream::nProcs());
    refusals[Pstream::myProcNo()] = found.refusal;
    Pstream::gatherList(refusals);
    Pstream::scatterList(refusals);
    reduce(found.least, minOp<vector>());
    reduce(found.most, maxOp<vector>());

    for (const string& refusal : refusals)
    {
        if (!refusal.empty())
        {
            refuse(refusal);
        }
    }

    for (direction axis = 0; axis < 3; ++axis)
    {
        if (found.most[axis] < 0)
        {
            continue;
        }

        const scalar length = upper(axis) - lower(axis);
        OStringStream reason;

        if (found.most[axis] - found.least[axis] > matching*length)
        {
            reason
                << "along " << axisName(axis) << " it has cyclic patches "
                << found.least[axis] << " m and " << found.most[axis]
                << " m apart; there can be one period per axis";
            refuse(reason.str());
        }
        if (mag(found.most[axis] - length) > matching*length)
        {
            reason
                << "its cyclic patches along " << axisName(axis) << " are "
                << found.most[axis] << " m apart, but it reaches over "
                << length << " m; the period must be the whole extent";
            refuse(reason.str());
        }
        periodic_[axis] = true;
    }
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

Foam::vector Foam::periodicAxes::nearestImage(vector separation) const
{
    for (direction axis = 0; axis < 3; ++axis)
    {
        if (periodic_[axis])
        {
            const scalar length = period(axis);
            separation[axis] -= length*std::round(separation[axis]/length);
        }
    }
    return separation;
}
