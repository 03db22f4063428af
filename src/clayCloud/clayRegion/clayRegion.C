/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayRegion.H"
#include "checkWords.H"
#include "readInRange.H"

#include "bitSet.H"
#include "indexedOctree.H"
#include "polyMesh.H"
#include "SubField.H"
#include "treeDataFace.H"

#include <memory>

const Foam::wordList Foam::clayRegion::words
({
    "region", "box", "zone", "patch", "thickness"
});


Foam::clayRegion::clayRegion(const polyMesh& mesh, const dictionary& dict)
:
    mesh_(mesh)
{
    const boundBox& meshBounds = mesh.bounds();
    const word kind(dict.get<word>("region"));
    colloid::checkChoice
    (
        dict, "region", kind, wordList({"box", "cellZone", "patchLayer"})
    );

    if (kind == "box")
    {
        ITstream& is = dict.lookup("box");
        const boundBox asked{point(is), point(is)};
        colloid::checkAllRead(dict, "box", is);

        bounds_ = boundBox
        (
            max(asked.min(), meshBounds.min()),
            min(asked.max(), meshBounds.max())
        );

        if (cmptMin(bounds_.span()) <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "The box " << asked.min() << ' ' << asked.max()
                << " is empty or outside the mesh, which spans "
                << meshBounds.min() << ' ' << meshBounds.max()
                << exit(FatalIOError);
        }
        if (bounds_ != asked)
        {
            Info<< "    The box " << asked.min() << ' ' << asked.max()
                << " m reaches beyond the mesh; inside is" << nl << "    "
                << bounds_.min() << ' ' << bounds_.max() << " m" << nl;
        }
        volume_ = bounds_.volume();
        contains_ = [this](const point& x, label){ return bounds_.contains(x); };
    }
    else if (kind == "cellZone")
    {
        const word name(dict.get<word>("zone"));
        colloid::checkChoice(dict, "zone", name, mesh.cellZones().names());

        const labelUList& cells = mesh.cellZones()[name];
        bounds_ = boundBox::invertedBox;
        volume_ = 0;
        for (const label celli : cells)
        {
            for (const label pointi : mesh.cellPoints()[celli])
            {
                bounds_.add(mesh.points()[pointi]);
            }
            volume_ += mesh.cellVolumes()[celli];
        }

        const bitSet inZone(mesh.nCells(), cells);
        contains_ =
            [inZone](const point&, label celli){ return inZone.test(celli); };
    }
    else
    {
        const word name(dict.get<word>("patch"));
        const scalar thickness = dict.getCheck<scalar>
        (
            "thickness", [](scalar t){ return t > 0; }
        );
        colloid::checkChoice(dict, "patch", name, mesh.boundaryMesh().names());

        const polyPatch& patch = mesh.boundaryMesh()[name];
        bounds_ = boundBox(patch.localPoints(), false);
        bounds_.min() =
            max(bounds_.min() - thickness*vector::one, meshBounds.min());
        bounds_.max() =
            min(bounds_.max() + thickness*vector::one, meshBounds.max());
        volume_ = thickness*sum(mag(patch.faceAreas()));

        // Slightly larger than the patch: a tree of a flat patch must have
        // a volume
        treeBoundBox treeBounds(patch.localPoints());
        treeBounds.min() -= thickness*vector::one;
        treeBounds.max() += thickness*vector::one;

        auto faces = std::make_shared<indexedOctree<treeDataFace>>
        (
            treeDataFace(false, patch), treeBounds, 10, 10, 3
        );
        contains_ =
            [faces, thickness](const point& x, label)
            {
                return faces->findNearest(x, sqr(thickness)).hit();
            };
    }
}


Foam::label Foam::clayRegion::cellOf(const point& x) const
{
    const label celli = mesh_.findCell(x);

    return celli >= 0 && contains_(x, celli) ? celli : -1;
}
