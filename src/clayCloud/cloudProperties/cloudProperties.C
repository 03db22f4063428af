/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudProperties.H"
#include "checkWords.H"
#include "Time.H"
#include "HashSet.H"
#include "integrator.H"
#include "keyType.H"
#include "readInRange.H"

#include <algorithm>

const Foam::Enum<Foam::cloudProperties::choice>
Foam::cloudProperties::choiceNames
({
    { choice::on, "on" },
    { choice::off, "off" },
    { choice::automatic, "auto" },
});

const Foam::Enum<Foam::cloudProperties::patchAction>
Foam::cloudProperties::patchActionNames
({
    { patchAction::automatic, "auto" },
    { patchAction::platelet, "platelet" },
    { patchAction::reflect, "reflect" },
    { patchAction::absorb, "absorb" },
});


// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The entry's number, -1 where it is `auto` or absent
scalar numberOrAuto
(
    const dictionary& dict,
    const word& keyword,
    const scalar lower,
    const scalar upper,
    const char* unit
)
{
    return
        colloid::numberOrWord(dict, keyword, "auto", lower, upper, unit)
       .value_or(-1);
}


//- The same of a length
scalar lengthOrAuto(const dictionary& dict, const word& keyword)
{
    return numberOrAuto(dict, keyword, 1e-12, 1e3, "m");
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

Foam::cloudProperties::cloudProperties(const Time& runTime)
:
    dict_
    (
        IOobject
        (
            "clayCloudProperties",
            runTime.constant(),
            runTime,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        )
    )
{
    using colloid::checkWords;

    checkWords
    (
        dict_,
        wordList
        ({
            "effects", "doubleLayer", "solution", "filter", "patches", "inlets"
        })
    );
    checkWords
    (
        section("effects"),
        wordList({"doubleLayer", "vanDerWaals", "Brownian", "drag", "gravity"})
    );
    checkWords
    (
        section("solution"),
        wordList
        ({
            "integrator", "engineDeltaT", "tolerance", "kernel",
            "coarseGraining", "cutOff", "skin", "maxNeighbours", "seed"
        })
    );
    checkWords
    (
        section("filter"), wordList({"kernel", "length", "timeScale"})
    );

    tolerance();
    seed();
    integrator();

    colloid::checkChoice
    (
        section("filter"),
        "kernel",
        section("filter").getOrDefault<word>("kernel", "cubic"),
        wordList({"cubic"})
    );

    checkInlets();
}


Foam::dictionary Foam::cloudProperties::section(const word& name) const
{
    const dictionary* found = dict_.findDict(name, keyType::LITERAL);
    return found ? *found : dictionary(dict_.name() + '.' + name);
}


Foam::cloudProperties::choice
Foam::cloudProperties::effect(const word& name) const
{
    const bool alwaysOn = (name == "doubleLayer" || name == "drag");

    return choiceNames.getOrDefault
    (
        name,
        section("effects"),
        alwaysOn ? choice::on : choice::automatic
    );
}


Foam::dictionary Foam::cloudProperties::doubleLayerDict() const
{
    return section("doubleLayer");
}


Foam::word Foam::cloudProperties::integrator() const
{
    const dictionary solution(section("solution"));
    const word name(solution.getOrDefault<word>("integrator", "auto"));

    wordList valid;
    for (const std::string& one : plateletDynamics::integrator::names())
    {
        valid.append(word(one));
    }
    colloid::checkChoice(solution, "integrator", name, valid);
    return name;
}


Foam::scalar Foam::cloudProperties::engineDeltaT() const
{
    return numberOrAuto(section("solution"), "engineDeltaT", 1e-18, 1e12, "s");
}


Foam::scalar Foam::cloudProperties::tolerance() const
{
    return colloid::readInRange
    (
        section("solution"), "tolerance", 1e-2, 1e-12, 0.999, "(-)"
    );
}


bool Foam::cloudProperties::exactKernel() const
{
    const dictionary solution(section("solution"));
    const word kernel(solution.getOrDefault<word>("kernel", "auto"));

    colloid::checkChoice
    (
        solution, "kernel", kernel, wordList({"auto", "exact"})
    );
    return kernel == "exact";
}


Foam::scalar Foam::cloudProperties::cutOff() const
{
    return lengthOrAuto(section("solution"), "cutOff");
}


Foam::scalar Foam::cloudProperties::skin() const
{
    return lengthOrAuto(section("solution"), "skin");
}


Foam::label Foam::cloudProperties::maxNeighbours() const
{
    return section("solution").getCheckOrDefault<label>
    (
        "maxNeighbours", 500, [](label n) { return n > 0; }
    );
}


Foam::label Foam::cloudProperties::seed() const
{
    return label
    (
        colloid::readInRange(section("solution"), "seed", 1, 0, labelMax, "(-)")
    );
}


Foam::scalar Foam::cloudProperties::coarseGraining() const
{
    const dictionary solution(section("solution"));

    if (!solution.found("coarseGraining"))
    {
        return 1;
    }

    return numberOrAuto(solution, "coarseGraining", 1, 1e6, "(-)");
}


Foam::scalar Foam::cloudProperties::filterLength() const
{
    return lengthOrAuto(section("filter"), "length");
}


Foam::scalar Foam::cloudProperties::filterTimeScale() const
{
    return section("filter").getCheckOrDefault<scalar>
    (
        "timeScale", 0, [](scalar t) { return t >= 0; }
    );
}


Foam::cloudProperties::patchAction
Foam::cloudProperties::actionOf(const word& patchName) const
{
    const dictionary patches(section("patches"));

    // A literal name, else the last pattern that fits
    const entry* found = patches.findEntry(patchName, keyType::REGEX);

    if (!found)
    {
        return patchAction::automatic;
    }

    const word action(found->get<word>());
    colloid::checkChoice
    (
        patches,
        found->keyword(),
        action,
        wordList({"auto", "platelet", "reflect", "absorb"})
    );
    return patchActionNames[action];
}


void Foam::cloudProperties::checkInlets() const
{
    wordHashSet patches;

    for (const entry& inlet : section("inlets"))
    {
        if (!inlet.isDict())
        {
            FatalIOErrorInFunction(dict_.subDict("inlets"))
                << "'" << inlet.keyword() << "' should be a dictionary:   "
                << inlet.keyword()
                << " { type reservoir; patch gel; fraction 0.005; }"
                << exit(FatalIOError);
        }
        if (!patches.insert(inlet.dict().get<word>("patch")))
        {
            FatalIOErrorInFunction(inlet.dict())
                << "Two inlets are on patch " << inlet.dict().get<word>("patch")
                << exit(FatalIOError);
        }
        colloid::readInRange(inlet.dict(), "fraction", 1e-9, 0.99, "(-)");
    }
}


Foam::dictionary Foam::cloudProperties::inlets() const
{
    return section("inlets");
}


bool Foam::cloudProperties::isInlet(const word& patchName) const
{
    for (const entry& inlet : inlets())
    {
        if (inlet.dict().get<word>("patch") == patchName)
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::cloudProperties::largestInletFraction() const
{
    scalar largest = 0;
    for (const entry& inlet : inlets())
    {
        largest = max(largest, inlet.dict().get<scalar>("fraction"));
    }
    return largest;
}


void Foam::cloudProperties::checkPatches(const wordList& names) const
{
    const dictionary patches(section("patches"));

    for (const entry& e : patches)
    {
        const keyType& key = e.keyword();

        if
        (
            std::none_of
            (
                names.begin(), names.end(),
                [&](const word& name){ return key.match(name); }
            )
        )
        {
            FatalIOErrorInFunction(patches)
                << "No patch fits '" << key << "'; the patches are "
                << flatOutput(names);

            const word nearest(colloid::nearestWord(key, names));
            if (nearest.size())
            {
                FatalIOError<< ". Is it " << nearest << '?';
            }
            FatalIOError<< exit(FatalIOError);
        }
    }
}
