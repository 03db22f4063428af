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

//- Time in which the force follows, in relaxation times, and how far it goes
constexpr Foam::scalar slowly = 10;
constexpr Foam::scalar farthest = 4;

} // End anonymous namespace


Foam::scalar Foam::forceInlet::readForce
(
    const dictionary& dict,
    const scene& where
)
{
    const clayInteractions& interactions = where.interactions;
    const scalar scale = interactions.coarseGraining();
    const scalar time = where.mesh.time().value();
    const scalar spacing = interactions.spacingAt(dict.get<scalar>("fraction"));

    // A word, else a number
    const token first(dict.found("force") ? dict.lookup("force")[0] : token());
    if (first.good() && !first.isWord())
    {
        return
            scale*colloid::readInRange(dict, "force", 1e-30, 1, "N");
    }
    const word kind
    (
        dict.getOrDefault<word>("force", "calibrated")
    );
    colloid::checkChoice
    (
        dict, "force", kind, wordList({"calibrated", "pair", "osmotic"})
    );

    return
        kind == "pair" ? interactions.pairForce(spacing, time)
      : interactions.latticePressure(spacing, time)*sqr(spacing);
}


Foam::forceInlet::forceInlet
(
    const word& name,
    const dictionary& dict,
    const scene& where
)
:
    clayInlet
    (
        name, dict, where, {1, 0, 1}
    ),
    calibrated_
    (
        !dict.found("force")
     || dict.lookup("force")[0] == token(word("calibrated"))
    ),
    firstForce_(readForce(dict, where)),
    force_(firstForce_)
{
    wordList words(commonWords);
    words.append("force");
    colloid::checkWords(dict, words);
}


Foam::scalar Foam::forceInlet::wanted(const counts& now, const scalar deltaT)
{
    const scalar time = relaxationTime(scene_.mesh.time().value());

    if (calibrated_)
    {
        force_ *=
            Foam::exp((1 - now.before/numberIn(3))*deltaT/(slowly*time));
        force_ =
            min(max(force_, firstForce_/farthest), farthest*firstForce_);
    }
    return (numberIn(1) - now.inLayer)*deltaT/time;
}


void Foam::forceInlet::printKind(Ostream& os) const
{
    os  << ", pushed by " << force_/scene_.interactions.coarseGraining()
        << " N" << (calibrated_ ? " (calibrated as the run goes)" : "");
}
