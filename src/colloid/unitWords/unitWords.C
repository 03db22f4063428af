/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unitWords.H"
#include "error.H"
#include "messageStream.H"

#include <set>
#include <sstream>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

constexpr scalar minute = 60;
constexpr scalar hour = 3600;
constexpr scalar day = 86400;
constexpr scalar year = 365.25*day;

// Of NaCl [g/mol]
constexpr scalar molarMass = 58.443;

struct knownUnit
{
    const char* unit;
    const char* SI;
    scalar factor;
    const char* meaning = "";
};

const std::vector<knownUnit> knownUnits
{
    {"m", "m", 1},
    {"km", "m", 1e3},
    {"cm", "m", 1e-2},
    {"mm", "m", 1e-3},
    {"um", "m", 1e-6},
    {"nm", "m", 1e-9},

    {"m3", "m3", 1},
    {"l", "m3", 1e-3},

    {"s", "s", 1},
    {"min", "s", minute},
    {"h", "s", hour},
    {"d", "s", day},
    {"a", "s", year},

    {"m/s", "m/s", 1},
    {"mm/s", "m/s", 1e-3},
    {"m/h", "m/s", 1/hour},
    {"m/d", "m/s", 1/day},
    {"m/a", "m/s", 1/year},
    {"mm/a", "m/s", 1e-3/year},

    {"m2/s", "m2/s", 1},
    {"m2/d", "m2/s", 1/day},
    {"m2/a", "m2/s", 1/year},

    {"mol/m3", "mol/m3", 1},
    {"mM", "mol/m3", 1},
    {"mmol/l", "mol/m3", 1},
    {"M", "mol/m3", 1e3},
    {"mol/l", "mol/m3", 1e3},
    {"g/l", "mol/m3", 1e3/molarMass, "(NaCl)"},
    {"mg/l", "mol/m3", 1/molarMass, "(NaCl)"},

    {"kg/m3", "kg/m3", 1},
    {"g/cm3", "kg/m3", 1e3},
    {"t/m3", "kg/m3", 1e3},

    {"Pa", "Pa", 1},
    {"kPa", "Pa", 1e3},
    {"MPa", "Pa", 1e6},
    {"bar", "Pa", 1e5},

    {"Pa s", "Pa s", 1},
    {"mPa s", "Pa s", 1e-3},

    {"J", "J", 1},
    {"zJ", "J", 1e-21},

    {"C/m2", "C/m2", 1},
    {"uC/cm2", "C/m2", 1e-2}
};


// Without what explains a limit, as in "m (the diameter)"
std::string bare(const char* SIunit)
{
    const std::string unit(SIunit);
    return unit.substr(0, unit.find(" ("));
}


// The rest of an entry as the user wrote it: m/a comes as three tokens
std::string rest(ITstream& is)
{
    std::ostringstream text;
    bool afterWord = false;

    while (is.nRemainingTokens())
    {
        const token t(is);
        const bool isSign = t.isPunctuation();

        if (afterWord && !isSign)
        {
            text<< ' ';
        }
        if (isSign)
        {
            text<< char(t.pToken());
        }
        else if (t.isWord())
        {
            text<< t.wordToken();
        }
        else if (t.isNumber())
        {
            text<< t.number();
        }
        else
        {
            text<< t.name();
        }
        afterWord = !isSign;
    }

    return text.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string Foam::colloid::unitsOf(const char* SIunit)
{
    std::string words;

    for (const knownUnit& u : knownUnits)
    {
        if (bare(SIunit) == u.SI)
        {
            words += (words.empty() ? "" : ", ") + std::string(u.unit)
              + (*u.meaning ? std::string(" ") + u.meaning : "");
        }
    }

    return words;
}


Foam::colloid::unitWord Foam::colloid::readUnit
(
    const dictionary& dict,
    const word& keyword,
    ITstream& is,
    const char* SIunit
)
{
    const label line = is.lineNumber();
    const std::string given(rest(is));

    if (given.empty())
    {
        return unitWord();
    }

    for (const knownUnit& u : knownUnits)
    {
        if (given == u.unit && bare(SIunit) == u.SI)
        {
            return {given, u.factor, u.meaning};
        }
    }

    const std::string valid(unitsOf(SIunit));

    auto& message = FatalIOError
    (
        FUNCTION_NAME,
        __FILE__,
        __LINE__,
        dict.name(),
        line,
        line
    );

    message
        << "Too much in entry '" << keyword << "': " << given.c_str() << nl;

    if (valid.empty())
    {
        message << "It is one value without a unit" << nl;
    }
    else
    {
        message
            << "After the value nothing, which is " << bare(SIunit).c_str()
            << ", or one of the units" << nl << "    " << valid.c_str() << nl;
    }

    message << exit(FatalIOError);

    return unitWord();
}


void Foam::colloid::echoUnit
(
    const dictionary& dict,
    const word& keyword,
    const std::string& value,
    const unitWord& unit,
    const std::string& converted,
    const char* SIunit
)
{
    // Entries are read again and again
    static std::set<std::string> echoed;

    std::string line(keyword + ' ' + value + ' ' + unit.given);
    if (!unit.meaning.empty())
    {
        line += ' ' + unit.meaning;
    }

    if (!unit.given.empty() && echoed.insert(dict.name() + '\n' + line).second)
    {
        Info<< line.c_str() << " read as " << converted.c_str() << ' '
            << bare(SIunit).c_str() << endl;
    }
}


// ************************************************************************* //
