/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "quadraticGradient.H"

#include "CPCCellToCellStencil.H"
#include "bitSet.H"

namespace
{

//- Two images nearly as near as each other, relative to the period: a cell half
//  a period away says nothing about the direction
constexpr Foam::scalar halfWay = 0.5 - 1e-6;

} // End anonymous namespace


void Foam::quadraticGradient::makeStencils(const polyMesh& mesh)
{
    // It numbers the faces of boundaries too, after the cells of their rank
    const CPCCellToCellStencil around(mesh);
    const globalIndex& withFaces = around.globalNumbering();
    const globalIndex numbering(mesh.nCells());

    labelListList neighbours(mesh.nCells());
    bitSet atBoundary(mesh.nCells());
    forAll(neighbours, celli)
    {
        DynamicList<label> cells(around[celli].size());
        for (const label global : around[celli])
        {
            const label proci = withFaces.whichProcID(global);
            const label local = withFaces.toLocal(proci, global);

            if (local >= numbering.localSize(proci))
            {
                atBoundary.set(celli);
            }
            else if (proci != Pstream::myProcNo() || local != celli)
            {
                cells.append(numbering.toGlobal(proci, local));
            }
        }
        neighbours[celli] = cells;
    }

    // The neighbours' neighbours: what each cell knows, to where it is asked
    labelListList asked(neighbours);
    List<Map<label>> compact(Pstream::nProcs());
    const mapDistribute toNeighbours(numbering, asked, compact);
    labelListList known(neighbours);
    toNeighbours.distribute(known);

    stencils_ = neighbours;
    forAll(stencils_, celli)
    {
        if (atBoundary.test(celli))
        {
            labelHashSet cells(neighbours[celli]);
            for (const label i : asked[celli])
            {
                cells.insert(known[i]);
            }
            cells.erase(numbering.toGlobal(celli));
            stencils_[celli] = cells.sortedToc();
        }
    }

    List<Map<label>> compactWidened(Pstream::nProcs());
    map_.reset(new mapDistribute(numbering, stencils_, compactWidened));
}


Foam::quadraticGradient::quadraticGradient
(
    const fvMesh& mesh,
    const periodicAxes& axes
)
:
    weights_(mesh.nCells())
{
    makeStencils(mesh);

    pointField centres(mesh.cellCentres());
    map_->distribute(centres);

    forAll(stencils_, celli)
    {
        DynamicList<label> cells(stencils_[celli].size());
        DynamicList<vector> separations(stencils_[celli].size());

        for (const label i : stencils_[celli])
        {
            const vector separation
            (
                axes.nearestImage(centres[i] - centres[celli])
            );
            bool clear = true;
            for (direction axis = 0; axis < 3; ++axis)
            {
                clear = clear
                 && (
                        !axes.periodic(axis)
                     || mag(separation[axis]) < halfWay*axes.period(axis)
                    );
            }
            if (clear)
            {
                cells.append(i);
                separations.append(separation);
            }
        }
        stencils_[celli] = cells;

        const labelList& points = mesh.cellPoints()[celli];
        vectorField corners(points.size());
        forAll(points, i)
        {
            corners[i] = mesh.points()[points[i]] - mesh.cellCentres()[celli];
        }
        weights_[celli] = weights(separations, corners);
    }
}


Foam::vectorField Foam::quadraticGradient::gradient
(
    const scalarField& values
) const
{
    scalarField collected(values);
    map_->distribute(collected);

    vectorField result(stencils_.size(), Zero);
    forAll(stencils_, celli)
    {
        const labelList& cells = stencils_[celli];
        forAll(cells, i)
        {
            result[celli] +=
                weights_[celli][i]*(collected[cells[i]] - values[celli]);
        }
    }
    return result;
}
