/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimSweep.H"
#include "checkWords.H"
#include "philox.H"
#include "physicalConstants.H"
#include "readInRange.H"
#include "unitWords.H"

#include "error.H"
#include "messageStream.H"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

using colloid::physicalConstants::year;

struct knownInput
{
    const char* name;
    const char* section;
    const char* unit;
};

const std::vector<knownInput> knownInputs
{
    {"Hamaker", "platelet", "J"},
    {"surfaceCharge", "platelet", "C/m2"},
    {"diameter", "platelet", "m"},
    {"Kozeny", "friction", "(-)"},
    {"coreThickness", "viscosity", "(-)"},
    {"concentration", "water", "mol/m3"},
    {"velocity", "", "m/s"}
};


// Models print what they are, which is enough once
class silence
{
    int level_;

public:

    silence()
    :
        level_(messageStream::level)
    {
        messageStream::level = 0;
    }

    ~silence()
    {
        messageStream::level = level_;
    }

    silence(const silence&) = delete;
    void operator=(const silence&) = delete;
};


//- Two ascending numbers and a unit
std::pair<scalar, scalar> readRange
(
    const dictionary& dict,
    const word& keyword,
    const char* SIunit
)
{
    ITstream& is = dict.lookup(keyword, keyType::LITERAL);
    const scalarList given(is);
    const colloid::unitWord unit
    (
        colloid::readUnit(dict, keyword, is, SIunit)
    );

    if (given.size() != 2 || !(given[0] < given[1]))
    {
        FatalIOErrorInFunction(dict)
            << "The range of " << keyword << " is not two ascending numbers"
            << " in brackets," << nl << "  " << keyword << " (lower upper);"
            << nl << exit(FatalIOError);
    }

    const scalar lower = given[0]*unit.factor;
    const scalar upper = given[1]*unit.factor;

    std::ostringstream shown, converted;
    shown << '(' << given[0] << ' ' << given[1] << ')';
    converted << '(' << lower << ' ' << upper << ')';
    colloid::echoUnit
    (
        dict, keyword, shown.str(), unit, converted.str(), SIunit
    );

    return {lower, upper};
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::rimSweep::input::at(const scalar part) const
{
    return
        logarithmic
      ? lower*std::pow(upper/lower, part)
      : lower + (upper - lower)*part;
}


Foam::scalar Foam::rimSweep::bar::span(const scalar base) const
{
    const scalar least = min(base, min(lower, upper));

    return least > 0 ? max(base, max(lower, upper))/least : GREAT;
}


void Foam::rimSweep::readInputs()
{
    const dictionary& ranges = dict_.subDict("ranges");
    const wordList logarithmic
    (
        dict_.getOrDefault<wordList>
        (
            "logarithmic", wordList(), keyType::LITERAL
        )
    );

    wordList names;
    for (const knownInput& k : knownInputs)
    {
        names.append(k.name);
    }
    colloid::checkWords(ranges, names);

    for (const word& name : logarithmic)
    {
        colloid::checkChoice(dict_, "logarithmic", name, ranges.toc());
    }

    const colloid::water water(properties_.waterAt(0));
    const colloid::platelet& clay = properties_.clay();

    for (const knownInput& k : knownInputs)
    {
        if (!ranges.found(k.name, keyType::LITERAL))
        {
            continue;
        }

        const word name(k.name);
        const auto range = readRange(ranges, name, k.unit);
        const bool isLogarithmic = logarithmic.found(name);

        if (isLogarithmic && range.first <= 0)
        {
            FatalIOErrorInFunction(ranges)
                << "The range of " << name << " is logarithmic and begins"
                << " at " << range.first << nl
                << "Valid: above 0" << nl << exit(FatalIOError);
        }

        inputs_.push_back
        ({
            name,
            k.section,
            k.unit,
            range.first,
            range.second,
            isLogarithmic,
            name == "concentration" ? water.concentration
          : name == "velocity" ? case_.edge().velocity
          : name == "Hamaker" ? clay.Hamaker
          : name == "surfaceCharge" ? clay.surfaceCharge
          : name == "diameter" ? clay.diameter
          : properties_.dict().subDict(k.section).get<scalar>(name)
        });
    }

    if (inputs_.empty())
    {
        FatalIOErrorInFunction(ranges)
            << "No input has a range. Valid: " << names << nl
            << exit(FatalIOError);
    }
}


std::vector<Foam::scalar> Foam::rimSweep::latinColumn(const word& name) const
{
    // The place of the input among all that there could be
    label id = 0;
    while (name != knownInputs[id].name)
    {
        ++id;
    }

    const plateletDynamics::philox random(static_cast<std::uint64_t>(seed_));
    std::vector<std::array<double, 4>> numbers(samples_);
    for (label i = 0; i < samples_; ++i)
    {
        numbers[i] = random.uniform(id, i);
    }

    // Each sample gets a slice of its own
    std::vector<label> order(samples_);
    std::iota(order.begin(), order.end(), 0);
    std::sort
    (
        order.begin(), order.end(), [&](const label a, const label b)
        {
            return numbers[a][0] < numbers[b][0];
        }
    );

    std::vector<scalar> parts(samples_);
    for (label slice = 0; slice < samples_; ++slice)
    {
        const label i = order[slice];
        parts[i] = (slice + numbers[i][1])/samples_;
    }
    return parts;
}


Foam::scalar Foam::rimSweep::rate(const std::vector<scalar>& values) const
{
    dictionary clay(properties_.dict());
    erosionBracket::edge edge(case_.edge());

    for (std::size_t i = 0; i < inputs_.size(); ++i)
    {
        if (inputs_[i].section.empty())
        {
            edge.velocity = values[i];
        }
        else
        {
            // As a token: a number passed as text would lose digits
            clay.subDict(inputs_[i].section).set
            (
                new primitiveEntry(inputs_[i].name, token(values[i]))
            );
        }
    }

    const colloid::clayProperties properties(clay);
    const rimMatter matter(properties, diffusivity_, 0);
    const scalar fraction = case_.edgeFraction(matter);

    return
        matter.spreads(fraction)
      ? rimCase::loss(matter.bracket(fraction), loss_).rate
        (
            edge, matter.clay().density
        )*year
      : -1;
}


Foam::scalar Foam::rimSweep::percentile(const scalar part) const
{
    const scalar place = part*(sorted_.size() - 1);
    const label below = min(label(place), label(sorted_.size()) - 1);
    const label above = min(below + 1, label(sorted_.size()) - 1);

    return
        sorted_[below] + (place - below)*(sorted_[above] - sorted_[below]);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rimSweep::rimSweep
(
    const rimCase& place,
    const colloid::clayProperties& properties,
    const dictionary& diffusivity
)
:
    dict_(place.dict().subDict("sweep")),
    case_(place),
    properties_(properties),
    diffusivity_(diffusivity),
    loss_(rimCase::lossName(dict_))
{
    colloid::checkWords
    (
        dict_,
        wordList({"loss", "samples", "seed", "ranges", "logarithmic"})
    );
    samples_ =
        label(colloid::readInRange(dict_, "samples", 1000, 10, 1e6, "(-)"));
    seed_ = colloid::readInRange(dict_, "seed", 1, 0, labelMax, "(-)");
    readInputs();

    const silence models;

    std::vector<scalar> values;
    for (const input& i : inputs_)
    {
        values.push_back(i.base);
    }
    base_ = rate(values);

    for (std::size_t i = 0; i < inputs_.size(); ++i)
    {
        std::vector<scalar> changed(values);
        bar b;
        b.input = i;
        changed[i] = inputs_[i].lower;
        b.lower = rate(changed);
        changed[i] = inputs_[i].upper;
        b.upper = rate(changed);
        bars_.push_back(b);
    }
    std::sort
    (
        bars_.begin(), bars_.end(), [this](const bar& a, const bar& b)
        {
            return a.span(base_) > b.span(base_);
        }
    );

    for (const input& i : inputs_)
    {
        parts_.push_back(latinColumn(i.name));
    }
    for (label sample = 0; sample < samples_; ++sample)
    {
        for (std::size_t i = 0; i < inputs_.size(); ++i)
        {
            values[i] = inputs_[i].at(parts_[i][sample]);
        }

        rates_.push_back(rate(values));
        if (rates_.back() >= 0)
        {
            sorted_.push_back(rates_.back());
        }
    }
    std::sort(sorted_.begin(), sorted_.end());
}


// ************************************************************************* //
