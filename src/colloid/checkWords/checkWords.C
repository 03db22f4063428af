/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkWords.H"
#include "caseFile.H"
#include "dictionaryText.H"
#include "errorAt.H"

#include <algorithm>
#include <cctype>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::word;

// As a hand or an eye takes it: maxC0 for maxCo
char plain(const char c)
{
    return
        c == '0' ? 'o'
      : c == '1' ? 'l'
      : char(std::tolower(static_cast<unsigned char>(c)));
}


// Damerau-Levenshtein distance of neighbouring swaps ("optimal string
// alignment"): the errors of a typing hand
std::size_t typingErrors(const word& a, const word& b)
{
    const auto same = [](const char x, const char y)
    {
        return plain(x) == plain(y);
    };

    std::vector<std::vector<std::size_t>> d
    (
        a.size() + 1,
        std::vector<std::size_t>(b.size() + 1)
    );

    for (std::size_t i = 0; i <= a.size(); ++i)
    {
        for (std::size_t j = 0; j <= b.size(); ++j)
        {
            if (i == 0 || j == 0)
            {
                d[i][j] = i + j;
                continue;
            }

            d[i][j] = std::min
            ({
                d[i-1][j] + 1,
                d[i][j-1] + 1,
                d[i-1][j-1] + (same(a[i-1], b[j-1]) ? 0 : 1)
            });

            if
            (
                i > 1 && j > 1
             && same(a[i-1], b[j-2]) && same(a[i-2], b[j-1])
            )
            {
                d[i][j] = std::min(d[i][j], d[i-2][j-2] + 1);
            }
        }
    }

    return d[a.size()][b.size()];
}


// Letters in the wrong case, two swapped, one left out or too many, a digit for the
// letter that looks like it. Another word with a digit, an underscore or another letter may be a variable ($deltaT0, $deltaX) or
// what has been put aside (functions_)
bool isSlip(const word& written, const word& known)
{
    if (written.size() == known.size())
    {
        const auto letters = [](std::string text)
        {
            std::transform(text.begin(), text.end(), text.begin(), plain);
            std::sort(text.begin(), text.end());
            return text;
        };
        return
            typingErrors(written, known) <= 1
         && letters(written) == letters(known);
    }
    return
        typingErrors(written, known) == 1
     && std::all_of
        (
            written.begin(),
            written.end(),
            [](const unsigned char c) { return std::isalpha(c); }
        );
}


void refuse
(
    const Foam::dictionary& dict,
    const Foam::entry* wrong,
    const Foam::string& what,
    const word& value,
    const Foam::UList<word>& validWords,
    const bool ofUser = false
)
{
    using namespace Foam;

    const word nearest(colloid::nearestWord(value, validWords));

    OSstream& message =
        wrong ? colloid::errorAt(dict, *wrong) : colloid::errorAt(dict, word());

    message << what << " '" << value << "'";

    if (!nearest.empty())
    {
        message << "; did you mean '" << nearest << "'?";
    }

    message << nl << "Valid words:";

    for (const word& valid : validWords)
    {
        message << ' ' << valid;
    }

    message << nl;

    if (ofUser)
    {
        message
            << "A variable of your own:  " << colloid::variablesWord << " { "
            << value << " ...; }" << nl;
    }

    message << exit(FatalIOError);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::word Foam::colloid::nearestWord
(
    const word& wrong,
    const UList<word>& validWords
)
{
    word nearest;

    // Beyond every second letter wrong it is another word
    std::size_t fewest = std::max<std::size_t>(2, wrong.size()/2) + 1;

    for (const word& valid : validWords)
    {
        const std::size_t errors = typingErrors(wrong, valid);

        if (errors < fewest)
        {
            fewest = errors;
            nearest = valid;
        }
    }

    return nearest;
}


void Foam::colloid::checkWords
(
    const dictionary& dict,
    const UList<word>& validWords
)
{
    for (const entry& e : dict)
    {
        const word keyword(e.keyword());

        if (keyword == variablesWord)
        {
            if (!e.isDict())
            {
                errorAt(dict, e)
                    << variablesWord << " is for words of your own, in braces:"
                    << "  " << variablesWord << " { length 1e-6; }" << nl
                    << exit(FatalIOError);
            }
        }
        else if (!validWords.found(keyword) && keyword != "FoamFile")
        {
            refuse
            (
                dict,
                &e,
                "Unknown entry in " + dict.dictName() + ":",
                keyword,
                validWords,
                !e.isDict()
            );
        }
    }
}


Foam::wordHashSet Foam::colloid::variablesOfControls()
{
    wordHashSet used;

    for (const char* path : {"system/controlDict", "system/fvSolution"})
    {
        used |= dictionaryText(caseFile(fileName(path))).variables();
    }
    return used;
}


void Foam::colloid::checkSpelling
(
    const dictionary& controlDict,
    const dictionary& fvSolution,
    const wordHashSet& variables
)
{
    const auto check = [&](const dictionary& dict, const UList<word>& words)
    {
        for (const entry& e : dict)
        {
            const word keyword(e.keyword());
            const auto isNear = [&](const word& known)
            {
                return isSlip(keyword, known);
            };

            if
            (
                !e.keyword().isPattern()
             && !words.found(keyword)
             && !variables.found(keyword)
             && std::any_of(words.begin(), words.end(), isNear)
            )
            {
                refuse
                (
                    dict,
                    &e,
                    "Nothing reads this entry of " + dict.dictName() + ":",
                    keyword,
                    words
                );
            }
        }
    };

    check
    (
        controlDict,
        wordList
        ({
            "application", "startFrom", "startTime", "stopAt", "endTime",
            "deltaT", "adjustTimeStep", "maxDeltaT", "maxCo", "maxDisplacement",
            "writeControl", "writeInterval", "purgeWrite", "writeFormat",
            "writePrecision", "writeCompression", "timeFormat", "timePrecision",
            "graphFormat", "runTimeModifiable", "functions", "libs", "profiling",
            "DebugSwitches", "InfoSwitches", "OptimisationSwitches"
        })
    );
    check
    (
        fvSolution,
        wordList
        ({
            "solvers", "relaxationFactors", "cache", "SIMPLE", "PIMPLE", "PISO",
            "erosion", "HeleShaw", "Stokes", "potentialFlow"
        })
    );
}


void Foam::colloid::checkChoice
(
    const dictionary& dict,
    const word& keyword,
    const word& value,
    const UList<word>& validWords
)
{
    if (!validWords.found(value))
    {
        refuse
        (
            dict,
            dict.findEntry(keyword, keyType::LITERAL),
            "Unknown " + keyword + " in " + dict.dictName() + ":",
            value,
            validWords
        );
    }
}


// ************************************************************************* //
