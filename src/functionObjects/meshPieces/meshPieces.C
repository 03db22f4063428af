/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPieces.H"
#include "caseFile.H"
#include "errorAt.H"
#include "patchWave.H"
#include "volFields.H"


Foam::meshPieces::meshPieces
(
    const fvMesh& mesh,
    const periodicAxes& axes,
    const FixedList<label, 3>& wanted,
    const scalar width,
    const scalar margin
)
:
    pieceOf_(mesh.nCells(), Zero),
    size_(1)
{
    const vectorField& centres = mesh.cellCentres();

    for (direction axis = 0; axis < 3; ++axis)
    {
        const scalar extent = axes.upper(axis) - axes.lower(axis);
        const label number =
            wanted[axis] > 0 ? wanted[axis]
          : label(max(scalar(1), min(extent/width, scalar(4))));

        forAll(pieceOf_, celli)
        {
            const scalar share =
                (centres[celli][axis] - axes.lower(axis))/extent;

            pieceOf_[celli] +=
                size_*max(label(0), min(label(share*number), number - 1));
        }
        size_ *= number;
    }

    labelHashSet patches;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!patch.coupled() && patch.type() != "empty")
        {
            patches.insert(patch.index());
        }
    }
    if (margin > 0 && patches.size())
    {
        const patchWave toPatches(mesh, patches);
        forAll(pieceOf_, celli)
        {
            if (toPatches.distance()[celli] < margin)
            {
                pieceOf_[celli] = -1;
            }
        }
    }

    label counting = 0;
    for (const label piece : pieceOf_)
    {
        counting += piece >= 0;
    }
    if (returnReduce(counting, sumOp<label>()) == 0)
    {
        colloid::errorAt
        (
            colloid::caseFile(fileName("system/controlDict")), wordList({"margin"})
        )
            << "No cell counts: all are nearer than the margin of " << margin
            << " m to a patch." << nl << "    A smaller margin, or margin 0"
            << exit(FatalIOError);
    }
}
