/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costReport.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "progress.H"

#include <cstdio>

// * * * * * * * * * * * * * * * * * timing  * * * * * * * * * * * * * * * * //

Foam::costReport::timing::timing(costReport& cost, const std::size_t part)
:
    cost_(&cost),
    part_(part),
    begun_(clock::now())
{}


Foam::costReport::timing::timing(timing&& other)
:
    cost_(other.cost_),
    part_(other.part_),
    begun_(other.begun_)
{
    other.cost_ = nullptr;
}


Foam::costReport::timing::~timing()
{
    stop();
}


void Foam::costReport::timing::stop()
{
    if (cost_)
    {
        cost_->parts_[part_].seconds +=
            std::chrono::duration<double>(clock::now() - begun_).count();
        cost_ = nullptr;
    }
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

Foam::costReport::costReport()
:
    parts_(),
    begun_(clock::now())
{}


std::size_t Foam::costReport::find
(
    const std::string& name,
    const std::string& whole
)
{
    std::size_t parti = 0;
    while (parti < parts_.size() && parts_[parti].name != name)
    {
        ++parti;
    }
    if (parti == parts_.size())
    {
        parts_.push_back({name, 0, whole});
    }
    return parti;
}


Foam::costReport::timing Foam::costReport::start(const std::string& name)
{
    return timing(*this, find(name, ""));
}


void Foam::costReport::add
(
    const std::string& name,
    const double seconds,
    const std::string& whole
)
{
    parts_[find(name, whole)].seconds += seconds;
}


double Foam::costReport::seconds(const std::string& name) const
{
    for (const part& p : parts_)
    {
        if (p.name == name)
        {
            return p.seconds;
        }
    }
    return 0;
}


double Foam::costReport::totalSeconds() const
{
    return std::chrono::duration<double>(clock::now() - begun_).count();
}


void Foam::costReport::report
(
    Ostream& os,
    const double particleSteps,
    const double simulatedTime
) const
{
    const label ranks = Pstream::nProcs();
    const scalar total = returnReduce(scalar(totalSeconds()), maxOp<scalar>());
    char line[128];

    os  << nl << "Cost of the run on " << ranks
        << (ranks == 1 ? " rank" : " ranks") << nl;
    std::snprintf
    (
        line, sizeof(line), "    %-28s %12s %12s %8s",
        "part", "slowest [s]", "mean [s]", "share"
    );
    os  << line << nl;

    const auto row =
    [&](const std::string& name, scalar slowest, scalar mean)
    {
        std::snprintf
        (
            line, sizeof(line), "    %-28.28s %12.3f %12.3f %6.1f %%",
            name.c_str(), slowest, mean, 100*mean/max(total, VSMALL)
        );
        os  << line << nl;
    };

    const auto partRow = [&](const std::string& name, scalar seconds)
    {
        const scalar mean = returnReduce(seconds, sumOp<scalar>())/ranks;

        row(name, returnReduce(seconds, maxOp<scalar>()), mean);
        return mean;
    };

    scalar rest = total;
    for (const part& p : parts_)
    {
        if (p.whole.empty())
        {
            rest -= partRow(p.name, p.seconds);

            scalar restWithin = p.seconds;
            bool hasParts = false;
            for (const part& within : parts_)
            {
                if (within.whole == p.name)
                {
                    partRow("  of it " + within.name, within.seconds);
                    restWithin -= within.seconds;
                    hasParts = true;
                }
            }
            if (hasParts)
            {
                partRow("  the rest of it", max(restWithin, scalar(0)));
            }
        }
    }
    row("other", rest, rest);
    row("total", total, total);

    const scalar steps = returnReduce(particleSteps, sumOp<scalar>());
    if (steps > 0)
    {
        std::snprintf
        (
            line, sizeof(line),
            "    particle-steps %.4g, seconds of a core per particle-step %.3g",
            steps, total*ranks/steps
        );
        os  << line << nl;
    }
    if (simulatedTime > 0)
    {
        os  << "    simulated " << withTimeUnit(simulatedTime).c_str() << " in "
            << asClock(total).c_str() << " (h:mm:ss), that is "
            << withTimeUnit(simulatedTime/max(total, VSMALL)).c_str()
            << " per second" << nl;
    }
    os  << endl;
}
