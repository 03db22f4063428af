/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayProperties.H"
#include "checkWords.H"
#include "errorAt.H"
#include "readInRange.H"

#include "IOdictionary.H"
#include "StringStream.H"
#include "Time.H"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const wordList sections
({
    "platelet", "water", "friction", "viscosity", "flocculation"
});

// What sea water, brines and rain cover [mol/m3]; NaCl saturates at 6100
constexpr scalar lowestConcentration = 1e-6;
constexpr scalar highestConcentration = 6100;

const wordList parameterSets({"default", "KTH", "Kratos"});

//- What is not given is this. The parameter sets differ in the entries that
//  are found in the second table
struct defaultEntry
{
    const char* section;
    const char* keyword;
    token value;
    const char* unit;
};


std::vector<defaultEntry> defaultEntries()
{
    const colloid::platelet p;
    const colloid::water w;

    return
    {
        {"platelet", "diameter", token(p.diameter), "m"},
        {"platelet", "thickness", token(p.thickness), "m"},
        {"platelet", "density", token(p.density), "kg/m3"},
        {"platelet", "surfaceCharge", token(p.surfaceCharge), "C/m2"},
        {"platelet", "Hamaker", token(p.Hamaker), "J"},
        {"platelet", "contactGap", token(p.contactGap), "m"},
        {"water", "valence", token(w.valence), ""},
        {"water", "temperature", token(w.temperature), "K"},
        {"water", "relativePermittivity", token(w.relativePermittivity), ""},
        {"water", "viscosity", token(w.viscosity), "Pa s"},
        {"water", "density", token(w.density), "kg/m3"},
        {"friction", "model", token(word("auto")), ""},
        {"friction", "Kozeny", token(scalar(5)), ""},
        {"friction", "fraction", token(word("local")), ""},
        {"viscosity", "model", token(word("LiuCoVolume")), ""},
        {"viscosity", "coreThickness", token(scalar(1)), "Debye lengths"},
        {"viscosity", "gelCoVolume", token(scalar(1.6)), ""},
        {"viscosity", "gelStop", token(word("on")), ""},
        {"viscosity", "gelViscosity", token(scalar(1e6)), "times water's"},
        {"flocculation", "active", token(word("off")), ""},
        {"flocculation", "fraction", token(scalar(0.005)), ""}
    };
}


struct setEntry
{
    const char* parameterSet;
    const char* section;
    const char* keyword;
    scalar value;
};

const std::vector<setEntry> setEntries
{
    {"KTH", "friction", "Kozeny", 14.12},
    {"Kratos", "platelet", "Hamaker", 1e-18}
};


dictionary readFile(const Time& runTime)
{
    IOobject io
    (
        "clayProperties",
        runTime.constant(),
        runTime,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        FatalErrorInFunction
            << "No readable file " << runTime.constant()/"clayProperties"
            << " in the case " << runTime.globalPath() << nl << nl
            << "It says what clay and water are. The shortest one that works:"
            << nl << nl
            << "    FoamFile { version 2.0; format ascii; class dictionary;"
            << " object clayProperties; }" << nl
            << "    water { concentration 0.1; }    // [mol/m3]" << nl << nl
            << "All entries: etc/caseDicts/clayProperties in bentoFoam." << nl
            << exit(FatalError);
    }

    return IOdictionary(io);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::colloid::clayProperties::complete()
{
    wordList topWords(sections);
    topWords.append("parameterSet");
    checkWords(dict_, topWords);

    parameterSet_ = dict_.getOrDefault<word>
    (
        "parameterSet", "default", keyType::LITERAL
    );
    checkChoice(dict_, "parameterSet", parameterSet_, parameterSets);

    for (const word& section : sections)
    {
        if (!dict_.found(section, keyType::LITERAL))
        {
            dict_.add(section, dictionary());
        }
    }

    HashTable<wordList> known;

    for (const defaultEntry& d : defaultEntries())
    {
        known(d.section).append(d.keyword);
    }

    known("water").append("concentration");
    known("water").append("concentrationCoeffs");
    known("friction").append("value");

    for (const word& section : sections)
    {
        checkWords(dict_.subDict(section), known[section]);
    }

    for (const defaultEntry& d : defaultEntries())
    {
        dictionary& section = dict_.subDict(d.section);

        if (section.found(d.keyword, keyType::LITERAL))
        {
            continue;
        }

        token value(d.value);

        for (const setEntry& s : setEntries)
        {
            if
            (
                parameterSet_ == s.parameterSet
             && word(d.section) == s.section
             && word(d.keyword) == s.keyword
            )
            {
                value = token(s.value);
            }
        }

        // As a token: a number passed as text would lose digits
        section.add(new primitiveEntry(d.keyword, value));

        // For reading, whatever writePrecision is
        OStringStream shown;
        shown.precision(6);
        shown << value;

        std::ostringstream line;
        line<< std::left << std::setw(14) << d.section
            << std::setw(22) << d.keyword
            << std::setw(14) << shown.str() << d.unit;
        defaults_.append(line.str());
    }
}


void Foam::colloid::clayProperties::readPlatelet()
{
    const dictionary& d = dict_.subDict("platelet");

    clay_.diameter = readInRange(d, "diameter", 1e-9, 1e-4, "m");
    clay_.thickness = readInRange
    (
        d,
        "thickness",
        1e-10,
        0.5*clay_.diameter,
        "m (half of the diameter)"
    );
    clay_.density = readInRange(d, "density", 1, 25000, "kg/m3");
    clay_.surfaceCharge = readInRange(d, "surfaceCharge", 1e-6, 10, "C/m2");
    clay_.Hamaker = readInRange(d, "Hamaker", 0, 1e-15, "J");
    clay_.contactGap = readInRange
    (
        d,
        "contactGap",
        1e-12,
        clay_.diameter,
        "m (the diameter)"
    );
}


void Foam::colloid::clayProperties::readWater()
{
    const dictionary& d = dict_.subDict("water");

    water_.valence = readInRange(d, "valence", 1, 4, "(-)");
    water_.temperature = readInRange(d, "temperature", 250, 400, "K");
    water_.relativePermittivity =
        readInRange(d, "relativePermittivity", 1, 300, "(-)");
    water_.viscosity = readInRange(d, "viscosity", 1e-6, 1e3, "Pa s");
    water_.density = readInRange(d, "density", 1, 25000, "kg/m3");

    if (!d.found("concentration", keyType::LITERAL))
    {
        FatalIOErrorInFunction(d)
            << "The concentration of the cation is missing in water" << nl
            << "It decides everything and has no default, e.g."
            << "  water { concentration 0.1; }" << nl
            << "Valid: a number from " << lowestConcentration << " to "
            << highestConcentration << " mol/m3, or a Function1 of time" << nl
            << exit(FatalIOError);
    }

    concentration_ = readFunction1<scalar>(d, "concentration", "mol/m3");

    // Now rather than in the middle of a run
    waterAt(0);

    if (water_.valence != 1)
    {
        IOWarningInFunction(d)
            << "valence " << water_.valence << " is a symmetric "
            << water_.valence << ':' << water_.valence << " salt in these laws:"
            << nl << "    not calcium bentonite, since CaCl2 has another Debye"
            << " length and its sheets" << nl
            << "    attract each other by ion correlations, which the theory"
            << " has not" << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::clayProperties::clayProperties(const dictionary& dict)
:
    dict_(dict)
{
    complete();
    readPlatelet();
    readWater();

    // Refuses what is impossible before anybody asks for it
    viscosity(waterAt(0));

    checkChoice
    (
        dict_.subDict("friction"),
        "model",
        frictionModel(),
        wordList({"auto", "Stokes", "KozenyCarman", "constant"})
    );

    newFriction("KozenyCarman", waterAt(0));

    if (frictionModel() == "constant")
    {
        newFriction("constant", waterAt(0));
    }
}


Foam::colloid::clayProperties::clayProperties(const Time& runTime)
:
    clayProperties(readFile(runTime))
{
    writeDefaults(Info);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::colloid::water Foam::colloid::clayProperties::waterAt
(
    const scalar time
) const
{
    water solution(water_);
    solution.concentration = concentration_->value(time);

    if
    (
        solution.concentration < lowestConcentration
     || solution.concentration > highestConcentration
    )
    {
        errorAt(dict_.subDict("water"), "concentration")
            << "Impossible concentration " << solution.concentration
            << " mol/m3 at time " << time << nl
            << "Valid: from " << lowestConcentration << " to "
            << highestConcentration << " mol/m3" << nl
            << exit(FatalIOError);
    }

    return solution;
}


bool Foam::colloid::clayProperties::concentrationVaries() const
{
    return concentration_->type() != "constant";
}


void Foam::colloid::clayProperties::writeDefaults(Ostream& os) const
{
    os  << "Clay and water: parameterSet " << parameterSet_;

    if (defaults_.size())
    {
        os  << ", not given and therefore" << nl;

        for (const string& line : defaults_)
        {
            os  << "    " << line.c_str() << nl;
        }
    }

    os  << endl;
}


Foam::autoPtr<Foam::colloid::doubleLayer>
Foam::colloid::clayProperties::newDoubleLayer
(
    const dictionary& dict,
    const water& solution
) const
{
    dictionary completed(dict);

    if
    (
        parameterSet_ == "Kratos"
     && dict.getOrDefault<word>("model", "", keyType::LITERAL) == "exponential"
    )
    {
        // Their kappa is low by sqrt(2), and their c is in mol/m3
        const scalar c = solution.concentration;

        const auto addDefault = [&](const word& keyword, const token& value)
        {
            if (!completed.found(keyword, keyType::LITERAL))
            {
                completed.add(new primitiveEntry(keyword, value));
            }
        };

        addDefault("P0", token(1.5e5*c));
        addDefault("kappa", token(7.34e7*std::sqrt(c)));
        addDefault("distance", token(word("centres")));
    }

    return doubleLayer::New(completed, clay_, solution);
}


Foam::autoPtr<Foam::colloid::doubleLayer>
Foam::colloid::clayProperties::newDoubleLayer
(
    const word& model,
    const water& solution
) const
{
    dictionary dict;
    dict.add("model", model);

    return newDoubleLayer(dict, solution);
}


Foam::word Foam::colloid::clayProperties::frictionModel() const
{
    return dict_.subDict("friction").get<word>("model", keyType::LITERAL);
}


Foam::scalar Foam::colloid::clayProperties::Kozeny() const
{
    return dict_.subDict("friction").get<scalar>("Kozeny", keyType::LITERAL);
}


Foam::autoPtr<Foam::colloid::plateletFriction>
Foam::colloid::clayProperties::newFriction
(
    const word& model,
    const water& solution
) const
{
    return plateletFriction::New
    (
        model,
        dict_.subDict("friction"),
        clay_,
        solution
    );
}


Foam::autoPtr<Foam::colloid::plateletFriction>
Foam::colloid::clayProperties::newFriction
(
    const water& solution
) const
{
    const word model(frictionModel());

    return newFriction(model == "auto" ? "KozenyCarman" : model, solution);
}


Foam::colloid::coVolumeViscosity Foam::colloid::clayProperties::viscosity
(
    const water& solution
) const
{
    return coVolumeViscosity
    (
        dict_.subDict("viscosity"),
        dict_.subDict("flocculation"),
        clay_,
        solution
    );
}


// ************************************************************************* //
