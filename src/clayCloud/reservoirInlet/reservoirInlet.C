/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "reservoirInlet.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "polyMesh.H"
#include "SubField.H"

namespace Foam
{
    defineTypeNameAndDebug(reservoirInlet, 0);
    addToRunTimeSelectionTable(clayInlet, reservoirInlet, dictionary);
}

namespace
{

//- Time of the controller in relaxation times, and that of its integral part in
//  these
constexpr Foam::scalar slowness = 3;
constexpr Foam::scalar slowlier = 10;

//- Share that may be missing from a layer that is filled
constexpr Foam::scalar nearly = 0.1;

} // End anonymous namespace


Foam::reservoirInlet::reservoirInlet
(
    const word& name,
    const dictionary& dict,
    const scene& where
)
:
    clayInlet
    (
        name, dict, where, {3.5, 0.6, 2.4}
    )
{
    colloid::checkWords(dict, commonWords);
}


Foam::scalar Foam::reservoirInlet::wanted
(
    const counts& now,
    const scalar deltaT
)
{
    const scalar time = slowness*relaxationTime(scene_.mesh.time().value());
    const scalar number = numberIn(2);
    const scalar missing = number - now.atPatch;

    // Not while a layer is filled: what is missing then is not missing later
    filled_ = filled_ || mag(missing) < nearly*number;
    if (filled_)
    {
        missed_ += missing*deltaT/(slowlier*time);
        missed_ = min(max(missed_, -number), number);
    }

    return
        (missing + missed_)*deltaT/time
      + density()*waterThrough()*deltaT;
}


Foam::scalar Foam::reservoirInlet::waterThrough() const
{
    if (!scene_.interactions.drag())
    {
        return 0;
    }

    const vectorField& U = waterAtPatch();
    const vectorField::subField areas
    (
        scene_.mesh.boundaryMesh()[layer_.patch()].faceAreas()
    );

    // OpenFOAM's areas point out of the mesh
    scalar sum = 0;
    forAll(U, i)
    {
        sum -= U[i] & areas[i];
    }
    return returnReduce(sum, sumOp<scalar>());
}
