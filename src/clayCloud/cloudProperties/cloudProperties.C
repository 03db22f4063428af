/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudProperties.H"
#include "checkWords.H"
#include "Time.H"
#include "keyType.H"

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

    const dictionary solution(section("solution"));
    solution.getCheckOrDefault<scalar>
    (
        "tolerance", 1e-2, [](scalar t) { return t > 0 && t < 1; }
    );

    colloid::checkChoice
    (
        section("filter"),
        "kernel",
        section("filter").getOrDefault<word>("kernel", "cubic"),
        wordList({"cubic"})
    );

    if (section("inlets").size())
    {
        FatalIOErrorInFunction(dict_.subDict("inlets"))
            << "Inlets are not available in this version; leave 'inlets'"
            << " empty and place the clay with setClay"
            << exit(FatalIOError);
    }
}


Foam::dictionary Foam::cloudProperties::section(const word& name) const
{
    const dictionary* found = dict_.findDict(name, keyType::LITERAL);
    return found ? *found : dictionary(dict_.name() + '.' + name);
}


Foam::scalar Foam::cloudProperties::numberOrAuto
(
    const dictionary& dict,
    const word& keyword
) const
{
    const entry* found = dict.findEntry(keyword, keyType::LITERAL);

    if (!found)
    {
        return -1;
    }

    const token first(found->stream()[0]);

    if (first.isWord() && first.wordToken() == "auto")
    {
        return -1;
    }
    if (!first.isNumber() || first.number() <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << keyword << "' is " << first
            << "; it should be auto or a number > 0"
            << exit(FatalIOError);
    }
    return first.number();
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
    return section("solution").getOrDefault<word>("integrator", "auto");
}


Foam::scalar Foam::cloudProperties::engineDeltaT() const
{
    return numberOrAuto(section("solution"), "engineDeltaT");
}


Foam::scalar Foam::cloudProperties::tolerance() const
{
    return section("solution").getOrDefault<scalar>("tolerance", 1e-2);
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
    return numberOrAuto(section("solution"), "cutOff");
}


Foam::scalar Foam::cloudProperties::skin() const
{
    return numberOrAuto(section("solution"), "skin");
}


Foam::label Foam::cloudProperties::maxNeighbours() const
{
    return section("solution").getCheckOrDefault<label>
    (
        "maxNeighbours", 500, [](label n) { return n > 0; }
    );
}


Foam::scalar Foam::cloudProperties::coarseGraining() const
{
    const dictionary solution(section("solution"));

    if (!solution.found("coarseGraining"))
    {
        return 1;
    }

    const scalar alpha = numberOrAuto(solution, "coarseGraining");

    if (alpha > 0 && alpha < 1)
    {
        FatalIOErrorInFunction(solution)
            << "coarseGraining is " << alpha
            << "; a parcel stands for coarseGraining^3 platelets, so it is"
            << " at least 1" << exit(FatalIOError);
    }
    return alpha;
}


Foam::scalar Foam::cloudProperties::filterLength() const
{
    return numberOrAuto(section("filter"), "length");
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
