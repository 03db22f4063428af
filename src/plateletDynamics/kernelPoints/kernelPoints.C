/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "kernelPoints.H"

#include <cstring>
#include <limits>

namespace plateletDynamics
{

namespace
{

//- Units beyond which a platelet is out of reach of all: absorbed
constexpr double outOfReach = 1e18;

//- Added to a number of less than 2^51, the lowest bits of the sum are the
//  nearest whole number
constexpr double shift = 6755399441055744.0;
constexpr double mostForShift = 2e15;

//- The number of units, modulo 2^32
std::int32_t units(double x, double perUnit)
{
    double n = x*perUnit;
    if (std::abs(n) > mostForShift)
    {
        n = std::fmod(n, 4294967296.0);
    }
    n += shift;

    std::int64_t bits;
    std::memcpy(&bits, &n, sizeof(bits));
    return std::int32_t(bits);
}

} // End namespace


void kernelPoints::setPlaces(std::size_t begin, std::size_t end)
{
    const double perUnit = 1/unit;

    for (std::size_t k = begin; k < end; ++k)
    {
        const vector& x = position[k];

        if (std::abs(x[0])*perUnit < outOfReach)
        {
            place[k] =
            {
                units(x[0], perUnit),
                units(x[1], perUnit),
                units(x[2], perUnit),
                0
            };
        }
        else if (!place[k].absorbed)
        {
            // Half a lattice away from its neighbours
            place[k].x ^= std::numeric_limits<std::int32_t>::min();
            place[k].absorbed = 1;
        }
    }
}

} // End namespace plateletDynamics
