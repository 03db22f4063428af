/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimErosion.H"
#include "checkWords.H"
#include "readInRange.H"
#include "surfaceFields.H"
#include "wallDist.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::rimErosion::readSource(const dictionary& dict)
{
    const dictionary& source = dict.subDict("source");
    colloid::checkWords(source, wordList({"patch", "centre", "radius"}));

    sourcePatch_ = -1;
    source_.clear();

    if (source.found("patch") == source.found("centre"))
    {
        FatalIOErrorInFunction(source)
            << "The source is a patch { patch <name>; } or a plug"
            << " { centre <point>; radius <length>; }" << exit(FatalIOError);
    }

    if (source.found("centre"))
    {
        const vector centre(source.get<vector>("centre"));
        const scalar radius = colloid::readInRange
        (
            source, "radius", 0, GREAT, "m"
        );

        distance_.reset
        (
            new volScalarField
            (
                IOobject("distance", time_.timeName(), mesh_),
                mesh_,
                dimensionedScalar(dimLength, Zero)
            )
        );
        source_.add("centre", centre);
        source_.add("radius", radius);

        const Vector<label>& solved = mesh_.solutionD();
        const auto fromEdge = [&](vector offset)
        {
            for (direction axis = 0; axis < 3; ++axis)
            {
                if (solved[axis] < 0)
                {
                    offset[axis] = 0;
                }
            }
            return mag(offset) - radius;
        };
        const vectorField& centres = mesh_.cellCentres();
        forAll(centres, celli)
        {
            distance_()[celli] = fromEdge(centres[celli] - centre);
        }
        distance_->correctBoundaryConditions();
        return;
    }

    const word patch(source.get<word>("patch"));
    sourcePatch_ = mesh_.boundaryMesh().findPatchID(patch);

    if (sourcePatch_ < 0)
    {
        colloid::checkChoice
        (
            source, "patch", patch, mesh_.boundaryMesh().names()
        );
    }
    source_.add("patch", patch);

    const wallDist fromPatch
    (
        mesh_, "meshWave", labelHashSet({sourcePatch_}), "source"
    );
    distance_.reset(new volScalarField("distance", fromPatch.y()));
}


Foam::Tuple2<Foam::scalar, Foam::scalar>
Foam::functionObjects::rimErosion::front(const scalar fraction) const
{
    const auto& alpha = lookupObject<volScalarField>("alpha.clay");
    const volScalarField& distance = distance_();
    const surfaceScalarField& areas = mesh_.magSf();

    scalar farthest = -GREAT;
    scalar weighted = 0;
    scalar area = 0;

    const auto add =
    [&](
        const scalar alphaHere,
        const scalar alphaThere,
        const scalar here,
        const scalar there,
        const scalar faceArea
    )
    {
        if ((alphaHere > fraction) != (alphaThere > fraction))
        {
            const scalar at =
                here
              + (there - here)*(alphaHere - fraction)/(alphaHere - alphaThere);

            farthest = max(farthest, at);
            weighted += faceArea*at;
            area += faceArea;
        }
    };

    forAll(mesh_.owner(), facei)
    {
        const label o = mesh_.owner()[facei];
        const label n = mesh_.neighbour()[facei];

        add
        (
            alpha[o], alpha[n], distance[o], distance[n],
            areas[facei]
        );
    }
    forAll(alpha.boundaryField(), patchi)
    {
        const auto& patch = alpha.boundaryField()[patchi];

        if (!patch.coupled())
        {
            continue;
        }
        // Seen from both sides
        const scalarField here(patch.patchInternalField());
        const scalarField there(patch.patchNeighbourField());
        const auto& patchDistance = distance.boundaryField()[patchi];
        const scalarField from(patchDistance.patchInternalField());
        const scalarField to(patchDistance.patchNeighbourField());

        forAll(here, i)
        {
            add
            (
                here[i], there[i], from[i], to[i],
                0.5*areas.boundaryField()[patchi][i]
            );
        }
    }

    reduce(farthest, maxOp<scalar>());
    reduce(weighted, sumOp<scalar>());
    reduce(area, sumOp<scalar>());

    return
        area > 0
      ? Tuple2<scalar, scalar>(farthest, weighted/area)
      : Tuple2<scalar, scalar>(noFront, noFront);
}
