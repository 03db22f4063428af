/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "integrator.H"

#include "adamsBashforth2.H"
#include "automatic.H"
#include "forwardEuler.H"
#include "leimkuhlerMatthews.H"
#include "userError.H"

#include <map>

namespace plateletDynamics
{

namespace
{

template<class Integrator>
std::unique_ptr<integrator> make(const engineSettings&)
{
    return std::make_unique<Integrator>();
}


template<>
std::unique_ptr<integrator> make<leimkuhlerMatthews>
(
    const engineSettings& settings
)
{
    return std::make_unique<leimkuhlerMatthews>
    (
        settings.thermalEnergy, settings.seed
    );
}


struct choice
{
    std::unique_ptr<integrator> (*make)(const engineSettings&);

    //- The one that takes its place where platelets move at random; empty: none
    std::string atRandom;
};


const std::map<std::string, choice> integrators
{
    {"auto", {make<automatic>, "LeimkuhlerMatthews"}},
    {"Euler", {make<forwardEuler>, ""}},
    {"AdamsBashforth2", {make<adamsBashforth2>, ""}},
    {"RKC2", {make<chebyshev2>, ""}},
    {"BogackiShampine", {make<bogackiShampine>, ""}},
    {"LeimkuhlerMatthews", {make<leimkuhlerMatthews>, "LeimkuhlerMatthews"}}
};


const choice& find(const std::string& name)
{
    const auto found = integrators.find(name);

    if (found == integrators.end())
    {
        std::string valid;
        for (const std::string& one : integrator::names())
        {
            valid += (valid.empty() ? "" : ", ") + one;
        }
        throw userError
        (
            "Unknown integrator " + name + ". Valid integrators: " + valid
        );
    }
    return found->second;
}

} // End namespace


std::vector<std::string> integrator::names()
{
    std::vector<std::string> found;
    for (const auto& entry : integrators)
    {
        found.push_back(entry.first);
    }
    return found;
}


bool integrator::canMoveAtRandom(const std::string& name)
{
    return !find(name).atRandom.empty();
}


std::string integrator::nameFor(const engineSettings& settings)
{
    const choice& named = find(settings.integrator);

    if (settings.thermalEnergy <= 0)
    {
        return settings.integrator;
    }
    if (named.atRandom.empty())
    {
        throw userError
        (
            "The integrator " + settings.integrator + " does no random motion."
            " Take auto or LeimkuhlerMatthews, or switch Brownian off"
        );
    }
    return named.atRandom;
}


std::unique_ptr<integrator> integrator::New(const engineSettings& settings)
{
    return find(nameFor(settings)).make(settings);
}

} // End namespace plateletDynamics
