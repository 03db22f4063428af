/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "progress.H"

#include <cstdio>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

struct timeUnit
{
    double seconds;
    const char* name;
};

//- Julian year, as geology reckons
constexpr timeUnit timeUnits[] =
{
    {31557600, "a"}, {86400, "d"}, {3600, "h"}, {1, "s"},
    {1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}, {1e-12, "ps"}
};


//- The largest unit of which the duration has at least one
timeUnit unitFor(const double seconds)
{
    for (const timeUnit& unit : timeUnits)
    {
        if (std::abs(seconds) >= unit.seconds)
        {
            return unit;
        }
    }
    return {1, "s"};
}


template<class... Arguments>
std::string formatted(const char* format, Arguments... arguments)
{
    char text[128];
    std::snprintf(text, sizeof(text), format, arguments...);
    return text;
}

} // End anonymous namespace


std::string Foam::withTimeUnit(const scalar seconds)
{
    const timeUnit unit = unitFor(seconds);
    return formatted("%.5g %s", double(seconds)/unit.seconds, unit.name);
}


std::string Foam::asClock(const scalar seconds)
{
    // Beyond this the days have no room, nor meaning
    if (!(seconds >= 0) || seconds > 1e5*86400)
    {
        return "-";
    }

    const long all = long(seconds + 0.5);
    const long days = all/86400;

    return
        (days ? formatted("%ldd ", days) : std::string())
      + formatted("%ld:%02ld:%02ld", all/3600%24, all/60%60, all%60);
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

Foam::progress::progress(const Time& runTime, const std::string& counted)
:
    time_(runTime),
    start_(runTime.value()),
    begun_(std::chrono::steady_clock::now()),
    counted_(counted)
{}


Foam::scalar Foam::progress::elapsedSeconds() const
{
    return
        std::chrono::duration<double>
        (
            std::chrono::steady_clock::now() - begun_
        ).count();
}


std::string Foam::progress::line
(
    const label number,
    const scalar elapsedSeconds
) const
{
    const scalar now = time_.value();
    const scalar end = time_.endTime().value();

    // stopAt other than endTime sets the end to GREAT
    const bool endIsKnown = end > start_ && end < 0.1*GREAT;

    // One unit for all lines of a run
    const timeUnit unit = unitFor(endIsKnown ? end : now);

    // Each step shows: 1.0000001 ms after 1 ms
    const scalar steps = std::abs(now)/max(time_.deltaTValue(), VSMALL);
    const int digits =
        max(5, min(15, 2 + int(std::log10(max(steps, scalar(1))))));

    std::string text =
        formatted("t = %-.*g %s", digits, now/unit.seconds, unit.name);
    text.resize(std::max<std::size_t>(text.size(), 18), ' ');

    if (endIsKnown)
    {
        text += formatted(" %5.1f %%", 100*std::min(now/end, 1.));
    }
    if (number >= 0)
    {
        text += formatted("  %9ld ", long(number)) + counted_;
    }
    if (endIsKnown && now > start_)
    {
        text +=
            "  left "
          + asClock(elapsedSeconds*max(end - now, 0.)/(now - start_));
    }
    return text;
}


void Foam::progress::report(const label number) const
{
    Info<< line(number, elapsedSeconds()).c_str() << endl;
}
