/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkControls.H"

#include "argList.H"
#include "chosenStart.H"
#include "wordList.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- FatalIOError at the entry, if it is there and its number isn't as said
template<class Condition>
void require
(
    const dictionary& dict,
    const word& keyword,
    const char* valid,
    Condition isValid
)
{
    const entry* given = dict.findEntry(keyword, keyType::LITERAL);
    if (!given)
    {
        return;
    }

    // OpenFOAM's error with file and line where it is no number
    const scalar value = dict.get<scalar>(keyword);

    if (!std::isfinite(value) || !isValid(value))
    {
        FatalIOError
        (
            FUNCTION_NAME,
            __FILE__,
            __LINE__,
            dict.name(),
            given->startLineNumber(),
            given->endLineNumber()
        )
            << "Impossible " << keyword << ' ' << value << nl
            << "Valid: " << valid << nl << exit(FatalIOError);
    }
}


bool isPositive(const scalar value)
{
    return value > 0;
}


//- An interval in steps or in seconds, as the control beside it says
void requireInterval
(
    const dictionary& dict,
    const word& control,
    const word& interval,
    const scalar fewestSteps
)
{
    // One that OpenFOAM doesn't know is refused by OpenFOAM
    const word counted(dict.getOrDefault<word>(control, "timeStep"));

    if (wordList({"timeStep", "writeTime", "outputTime"}).found(counted))
    {
        require
        (
            dict,
            interval,
            "a whole number of steps, at least 1",
            [&](const scalar n)
            {
                return n >= fewestSteps && n <= labelMax && n == std::floor(n);
            }
        );
    }
    else if (wordList({"none", "always", "onEnd"}).found(counted))
    {
        // Not read
    }
    else
    {
        require(dict, interval, "more than 0 s", isPositive);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::checkControls(const dictionary& controlDict)
{
    const auto anyTime = [](scalar){return true;};
    const auto digits = [](const scalar n)
    {
        return n >= 1 && n <= 24 && n == std::floor(n);
    };

    for (const char* length : {"deltaT", "maxDeltaT"})
    {
        require(controlDict, length, "more than 0 s", isPositive);
    }
    for (const char* limit : {"maxCo", "maxDisplacement"})
    {
        require(controlDict, limit, "more than 0", isPositive);
    }
    for (const char* time : {"startTime", "endTime"})
    {
        require(controlDict, time, "a time [s]", anyTime);
    }
    for (const char* precision : {"timePrecision", "writePrecision"})
    {
        require(controlDict, precision, "from 1 to 24 digits", digits);
    }
    require
    (
        controlDict,
        "purgeWrite",
        "a number of times that are kept, or 0 for all",
        [](const scalar n)
        {
            return n >= 0 && n <= labelMax && n == std::floor(n);
        }
    );

    // The second is its older name
    requireInterval(controlDict, "writeControl", "writeInterval", 1);
    requireInterval(controlDict, "writeControl", "writeFrequency", 1);

    const dictionary* functions = controlDict.findDict("functions");
    if (!functions)
    {
        return;
    }

    for (const entry& function : *functions)
    {
        if (!function.isDict())
        {
            continue;
        }
        const dictionary& dict = function.dict();

        // OpenFOAM's function objects take 0 steps for each step. The second
        // is the name of before v1606
        requireInterval(dict, "writeControl", "writeInterval", 0);
        requireInterval(dict, "outputControl", "outputInterval", 0);
        requireInterval(dict, "executeControl", "executeInterval", 0);

        for (const char* time : {"timeStart", "timeEnd"})
        {
            require(dict, time, "a time [s]", anyTime);
        }
    }
}


void Foam::checkControls(const argList& args)
{
    checkControls
    (
        chosenStart::readControlDict(args.rootPath(), args.caseName())
    );
}
