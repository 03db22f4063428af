/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "listArrangement.H"
#include "addToRunTimeSelectionTable.H"
#include "boundBox.H"
#include "caseFile.H"
#include "checkWords.H"
#include "placesFile.H"
#include "polyMesh.H"

namespace Foam
{
    defineTypeNameAndDebug(listArrangement, 0);
    addToRunTimeSelectionTable(arrangement, listArrangement, dictionary);
}


Foam::listArrangement::listArrangement
(
    const dictionary& dict,
    const scene& where
)
:
    arrangement(where),
    file_(colloid::caseFile(dict, "file"))
{
    colloid::checkWords
    (
        dict, wordList({"arrangement", "file", "spacing", "fixed"})
    );

    if (dict.found("spacing"))
    {
        spacing_ = dict.getCheck<scalar>
        (
            "spacing", [](scalar s){ return s > 0; }
        );
    }
}


Foam::scalar Foam::listArrangement::estimatedSpacing
(
    const pointField& places
) const
{
    const vector span(boundBox(places, false).span());

    scalar extent = 1;
    label dimensions = 0;
    for (direction axis = 0; axis < 3; ++axis)
    {
        if (span[axis] > 0)
        {
            extent *= span[axis];
            ++dimensions;
        }
    }

    if (dimensions == 0)
    {
        return cbrt(sum(scene_.mesh.cellVolumes()));
    }

    // n layers have n - 1 spacings between the outermost
    const scalar layers = pow(scalar(places.size()), 1.0/dimensions);
    return pow(extent, 1.0/dimensions)/max(layers - 1, scalar(1));
}


Foam::pointField Foam::listArrangement::place(Random&)
{
    const pointField places(placesFile(file_).places());

    forAll(places, i)
    {
        if (scene_.mesh.findCell(places[i]) < 0)
        {
            FatalErrorInFunction
                << "Place " << i << " of the list " << file_ << ", " << places[i]
                << " m, is outside the mesh, which spans "
                << scene_.mesh.bounds().min() << ' '
                << scene_.mesh.bounds().max() << " m" << exit(FatalError);
        }
    }

    if (spacing_ == 0)
    {
        spacing_ = estimatedSpacing(places);
    }
    return places;
}
