/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "integrator.H"

#include "adamsBashforth2.H"
#include "automatic.H"
#include "forwardEuler.H"
#include "userError.H"

#include <map>

namespace plateletDynamics
{

namespace
{

template<class Integrator>
std::unique_ptr<integrator> make()
{
    return std::make_unique<Integrator>();
}


const std::map<std::string, std::unique_ptr<integrator> (*)()> integrators
{
    {"auto", make<automatic>},
    {"Euler", make<forwardEuler>},
    {"AdamsBashforth2", make<adamsBashforth2>},
    {"RKC2", make<chebyshev2>},
    {"BogackiShampine", make<bogackiShampine>}
};

} // End namespace


std::unique_ptr<integrator> integrator::New(const std::string& name)
{
    const auto found = integrators.find(name);

    if (found == integrators.end())
    {
        std::string names;
        for (const auto& entry : integrators)
        {
            names += (names.empty() ? "" : ", ") + entry.first;
        }
        throw userError
        (
            "Unknown integrator " + name + ". Valid integrators: " + names
        );
    }
    return found->second();
}

} // End namespace plateletDynamics
