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


const std::map
<
    std::string,
    std::unique_ptr<integrator> (*)(const engineSettings&)
> integrators
{
    {"auto", make<automatic>},
    {"Euler", make<forwardEuler>},
    {"AdamsBashforth2", make<adamsBashforth2>},
    {"RKC2", make<chebyshev2>},
    {"BogackiShampine", make<bogackiShampine>},
    {"LeimkuhlerMatthews", make<leimkuhlerMatthews>}
};

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


std::unique_ptr<integrator> integrator::New(const engineSettings& settings)
{
    const bool random = settings.thermalEnergy > 0;
    const std::string name
    (
        random && settings.integrator == "auto"
      ? "LeimkuhlerMatthews" : settings.integrator
    );
    const auto found = integrators.find(name);

    if (found == integrators.end())
    {
        std::string valid;
        for (const std::string& one : names())
        {
            valid += (valid.empty() ? "" : ", ") + one;
        }
        throw userError
        (
            "Unknown integrator " + name + ". Valid integrators: " + valid
        );
    }
    if (random && name != "LeimkuhlerMatthews")
    {
        throw userError
        (
            "The integrator " + name + " does no random motion. Take auto or"
            " LeimkuhlerMatthews, or switch Brownian off"
        );
    }
    return found->second(settings);
}

} // End namespace plateletDynamics
