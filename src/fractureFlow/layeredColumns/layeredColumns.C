/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layeredColumns.H"
#include "surfaceFields.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"
#include "fractureFlow.H"

#include <algorithm>

Foam::labelHashSet Foam::layeredColumns::findPatches() const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const labelHashSet found(patches.patchSet(List<wordRe>(1, patchName_)));

    if (found.empty())
    {
        const wordList names(patches.names());

        FatalIOErrorInFunction(context_)
            << "gelPatch " << patchName_ << " is not on the mesh" << nl
            << "Its patches are "
            << flatOutput(SubList<word>(names, patches.nNonProcessor()))
            << exit(FatalIOError);
    }

    return found;
}


Foam::label Foam::layeredColumns::oppositeFace
(
    const label celli,
    const label facei
) const
{
    const face& from = mesh_.faces()[facei];
    label opposite = -1;

    for (const label otheri : mesh_.cells()[celli])
    {
        const face& other = mesh_.faces()[otheri];

        const bool touches = std::any_of
        (
            other.begin(),
            other.end(),
            [&from](const label pointi) { return from.found(pointi); }
        );

        if (other.size() == from.size() && !touches)
        {
            if (opposite != -1)
            {
                return -1;
            }
            opposite = otheri;
        }
    }

    return opposite;
}


bool Foam::layeredColumns::onProcessorBoundary(const label facei) const
{
    const polyPatch& pp =
        mesh_.boundaryMesh()[mesh_.boundaryMesh().whichPatch(facei)];

    return isA<processorPolyPatch>(pp) && !isA<processorCyclicPolyPatch>(pp);
}


bool Foam::layeredColumns::walk
(
    const labelUList& firstFaces,
    boolList& crossed,
    boolList& leaves,
    labelHashSet& lastPatches
)
{
    for (const label firstFace : firstFaces)
    {
        label facei = firstFace;
        label celli = mesh_.faceOwner()[facei];

        while (true)
        {
            const label outer = oppositeFace(celli, facei);

            if (outer == -1 || crossed[celli])
            {
                return false;
            }

            crossed[celli] = true;
            cells_.append(celli);
            outerFaces_.append(outer);

            if (!mesh_.isInternalFace(outer))
            {
                if (onProcessorBoundary(outer))
                {
                    leaves[outer - mesh_.nInternalFaces()] = true;
                }
                else
                {
                    lastPatches.insert(mesh_.boundaryMesh().whichPatch(outer));
                }
                break;
            }

            facei = outer;
            celli =
                mesh_.faceOwner()[outer] == celli
              ? mesh_.faceNeighbour()[outer]
              : mesh_.faceOwner()[outer];
        }
    }

    return true;
}


void Foam::layeredColumns::build()
{
    labelList firstFaces;
    for (const label patchi : patches_.sortedToc())
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        firstFaces.append(identity(patch.size(), patch.start()));
    }

    boolList crossed(mesh_.nCells(), false);
    labelHashSet lastPatches;
    bool layered = true;

    // Each round walks as far as this rank's part of the mesh reaches
    while (layered && returnReduce(firstFaces.size(), sumOp<label>()) > 0)
    {
        boolList leaves(mesh_.nFaces() - mesh_.nInternalFaces(), false);

        layered = walk(firstFaces, crossed, leaves, lastPatches);
        reduce(layered, andOp<bool>());

        syncTools::swapBoundaryFaceList(mesh_, leaves);

        DynamicList<label> enters;
        forAll(leaves, i)
        {
            const label facei = mesh_.nInternalFaces() + i;

            if (leaves[i] && onProcessorBoundary(facei))
            {
                enters.append(facei);
            }
        }
        firstFaces.transfer(enters);
        waves_.append({cells_.size(), firstFaces});
    }

    const label missed =
        returnReduce(mesh_.nCells() - cells_.size(), sumOp<label>());

    if (!layered || missed > 0)
    {
        FatalIOErrorInFunction(context_)
            << "The mesh is not layered away from patch " << patchName_ << ": "
            << (
                layered
              ? Foam::name(missed) + " cells are in no column of cells that"
                " stands on it"
              : string("a column of cells on it meets a cell without one"
                " opposite face, or another column")
               ) << nl
            << "A divergence-free localViscosity flow needs such columns."
            << " On this mesh use model Stokes"
            << (
                fractureFlow::dictionaryConstructorTablePtr_->found("HeleShaw")
              ? " or HeleShaw" : ""
               ) << exit(FatalIOError);
    }

    checkLastPatches(lastPatches);
}


void Foam::layeredColumns::checkLastPatches
(
    const labelHashSet& lastPatches
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    // Plain patches are open; walls, symmetry, cyclics etc. are other types
    for (label patchi = 0; patchi < patches.nNonProcessor(); ++patchi)
    {
        const polyPatch& pp = patches[patchi];

        if
        (
            returnReduce(lastPatches.found(patchi), orOp<bool>())
         && (pp.type() != polyPatch::typeName || patches_.found(patchi))
        )
        {
            FatalIOErrorInFunction(context_)
                << "Columns of cells from patch " << patchName_
                << " end at patch " << pp.name() << " of type " << pp.type()
                << nl << "The water that the gel displaces leaves there, so"
                << " it has to be an open patch (type patch, not "
                << patchName_ << " itself)"
                << exit(FatalIOError);
        }
    }
}


Foam::layeredColumns::layeredColumns
(
    const fvMesh& mesh,
    const wordRe& patchName,
    const dictionary& context
)
:
    mesh_(mesh),
    patchName_(patchName),
    context_(context),
    patches_(findPatches()),
    cells_(mesh.nCells()),
    outerFaces_(mesh.nCells()),
    waves_()
{
    build();
}


void Foam::layeredColumns::completeFlux(surfaceScalarField& phi) const
{
    const label nInternal = mesh_.nInternalFaces();
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    // By mesh face, so that a column needs not know patches
    scalarField flux(mesh_.nFaces(), Zero);
    SubField<scalar>(flux, nInternal) = phi.primitiveField();

    forAll(phi.boundaryField(), patchi)
    {
        const fvsPatchScalarField& values = phi.boundaryField()[patchi];

        if (!patches_.found(patchi))
        {
            SubField<scalar>(flux, values.size(), patches[patchi].start()) =
                values;
        }
    }

    label i = 0;
    for (const wave& w : waves_)
    {
        for (; i < w.end; ++i)
        {
            scalar inflow = 0;

            for (const label facei : mesh_.cells()[cells_[i]])
            {
                if (facei != outerFaces_[i])
                {
                    inflow +=
                        mesh_.faceOwner()[facei] == cells_[i]
                      ? -flux[facei]
                      : flux[facei];
                }
            }

            flux[outerFaces_[i]] =
                mesh_.faceOwner()[outerFaces_[i]] == cells_[i]
              ? inflow
              : -inflow;
        }

        // What leaves a rank through a face enters the next one
        scalarField outflow
        (
            SubField<scalar>(flux, flux.size() - nInternal, nInternal)
        );
        syncTools::swapBoundaryFaceList(mesh_, outflow);

        for (const label facei : w.entering)
        {
            flux[facei] = -outflow[facei - nInternal];
        }
    }

    phi.primitiveFieldRef() = SubField<scalar>(flux, nInternal);

    forAll(phi.boundaryField(), patchi)
    {
        fvsPatchScalarField& values = phi.boundaryFieldRef()[patchi];

        values = SubField<scalar>
        (
            flux,
            values.size(),
            patches[patchi].start()
        );
    }
}
