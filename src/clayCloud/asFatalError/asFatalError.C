/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "asFatalError.H"
#include "errorAt.H"

#include <regex>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The message with numbers of the engine's units in SI units
std::string messageInSI(const std::string& message, const reducedUnits& units)
{
    static const std::regex counted
    (
        "([-+]?[0-9][-+.0-9e]*) (lengths|times|frictions|per time)"
    );

    std::string result;
    std::string rest(message);
    std::smatch found;

    while (std::regex_search(rest, found, counted))
    {
        const std::string unit(found[2]);
        const scalar value = std::stod(found[1]);

        result += found.prefix();
        result +=
            unit == "lengths"
          ? plateletDynamics::text(value*units.length(), " m")
          : unit == "times"
          ? plateletDynamics::text(value*units.time(), " s")
          : unit == "frictions"
          ? plateletDynamics::text(value*units.friction(), " N s/m")
          : plateletDynamics::text(value/units.time(), " 1/s");
        rest = found.suffix();
    }

    return result + rest;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::refuse
(
    const plateletDynamics::userError& error,
    const reducedUnits& units,
    const cloudProperties& properties
)
{
    const std::string message(messageInSI(error.what(), units));
    const dictionary* solution = properties.dict().findDict("solution");

    // The engine's words are the user's: cutOff, skin, tolerance
    if (solution)
    {
        for (const entry& e : *solution)
        {
            const std::regex named("\\b" + e.keyword() + "\\b");

            if (std::regex_search(message, named))
            {
                colloid::errorAt(*solution, e)
                    << message.c_str() << exit(FatalIOError);
            }
        }
    }

    colloid::errorAt(properties.dict(), "solution")
        << message.c_str() << exit(FatalIOError);
}


// ************************************************************************* //
