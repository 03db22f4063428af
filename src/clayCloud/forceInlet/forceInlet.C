/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "forceInlet.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "polyMesh.H"
#include "readInRange.H"

namespace Foam
{
    defineTypeNameAndDebug(forceInlet, 0);
    addToRunTimeSelectionTable(clayInlet, forceInlet, dictionary);
}

namespace
{

//- Time in which the force follows, in relaxation times, and how far it goes: where
//  clay is nearly a gas (1 mol/m3) its row is mostly empty and needs more than 4
constexpr Foam::scalar slowly = 10;
constexpr Foam::scalar farthest = 20;

} // End anonymous namespace


Foam::forceInlet::forceInlet
(
    const word& name,
    const dictionary& dict,
    const scene& where
)
:
    clayInlet
    (
        name, dict, where, {1, 0, 1, GREAT}
    ),
    kind_("calibrated")
{
    wordList words(commonWords);
    words.append("force");
    colloid::checkWords(dict, words);

    // A number, else a word
    const token first(dict.found("force") ? dict.lookup("force")[0] : token());
    if (first.good() && !first.isWord())
    {
        kind_.clear();
        given_ = colloid::readInRange(dict, "force", 1e-30, 1, "N");
    }
    else
    {
        kind_ = dict.getOrDefault<word>("force", kind_);
        colloid::checkChoice
        (
            dict, "force", kind_, wordList({"calibrated", "pair", "osmotic"})
        );
    }
    force_ = forceAt(where.mesh.time().value());
}


Foam::scalar Foam::forceInlet::forceAt(const scalar time) const
{
    const clayInteractions& interactions = scene_.interactions;

    return
        kind_.empty() ? given_
      : kind_ == "pair" ? interactions.pairForce(spacing_, time)
      : interactions.latticePressure(spacing_, time)*sqr(spacing_);
}


Foam::scalar Foam::forceInlet::wanted
(
    const label,
    const counts& now,
    const scalar deltaT
)
{
    const scalar present = scene_.mesh.time().value();
    const scalar time = relaxationTime(present);

    if (kind_ == "calibrated")
    {
        factor_ *=
            Foam::exp((1 - now.before/numberIn(3))*deltaT/(slowly*time));
        factor_ = min(max(factor_, 1/farthest), farthest);
    }
    force_ = factor_*forceAt(present);

    return (numberIn(1) - now.inLayer)*deltaT/time;
}


void Foam::forceInlet::printKind(Ostream& os) const
{
    os  << ", pushed by " << force_ << " N"
        << (kind_ == "calibrated" ? " (calibrated as the run goes)" : "");
}
