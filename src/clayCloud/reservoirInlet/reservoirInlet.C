/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "reservoirInlet.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "DynamicList.H"
#include "polyMesh.H"

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
        name, dict, where, {3.5, 0.6, 2.4, 5}
    ),
    holding_(pieces_.size())
{
    colloid::checkWords(dict, commonWords);
}


Foam::scalar Foam::reservoirInlet::wanted
(
    const label piece,
    const counts& now,
    const scalar deltaT
)
{
    const scalar time = slowness*relaxationTime(scene_.mesh.time().value());
    const scalar number = numberIn(2)*pieces_.share(piece);
    const scalar missing = number - now.atPatch;
    holding& has = holding_[piece];

    // What has gone since the last time
    if (has.interval > 0)
    {
        const scalar rate = (has.inLayer - now.inLayer)/has.interval;
        has.rate += (1 - Foam::exp(-has.interval/time))*(rate - has.rate);
    }

    // Not while a layer is filled: what is missing then is not missing later
    has.filled = has.filled || mag(missing) < nearly*number;
    if (has.filled)
    {
        has.missed += missing*deltaT/(slowlier*time);
        has.missed = min(max(has.missed, -number), number);
    }

    return (missing + has.missed)*deltaT/time + has.rate*deltaT;
}


void Foam::reservoirInlet::supplied
(
    const label piece,
    const label inLayer,
    const scalar deltaT
)
{
    holding_[piece].inLayer = inLayer;
    holding_[piece].interval = deltaT;
}


Foam::scalarList Foam::reservoirInlet::memory() const
{
    DynamicList<scalar> all;
    for (const holding& has : holding_)
    {
        all.append
        ({
            has.missed, scalar(has.filled), has.rate, scalar(has.inLayer),
            has.interval
        });
    }
    return scalarList(all);
}


void Foam::reservoirInlet::remember(const scalarList& memory)
{
    // In other pieces (of another fraction, another mesh) it is learnt anew
    if (memory.size() != 5*holding_.size())
    {
        return;
    }
    label i = 0;
    for (holding& has : holding_)
    {
        has.missed = memory[i++];
        has.filled = memory[i++] > 0;
        has.rate = memory[i++];
        has.inLayer = memory[i++];
        has.interval = memory[i++];
    }
}
