/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "periodicBox.H"

#include <cmath>

namespace plateletDynamics
{

std::array<int, 3> periodicBox::wrap(vector& place) const
{
    std::array<int, 3> outside{0, 0, 0};

    for (int axis = 0; axis < 3; ++axis)
    {
        double& x = place[axis];

        if (!periodic[axis] || (x >= lower[axis] && x < upper[axis]))
        {
            continue;
        }

        double periods = std::floor((x - lower[axis])/period(axis));
        x -= periods*period(axis);

        // Just below the lower end rounding leads to the upper
        if (x >= upper[axis])
        {
            x = lower[axis];
            periods += 1;
        }
        outside[axis] = int(periods);
    }
    return outside;
}


std::vector<vector> periodicBox::shifts() const
{
    std::vector<vector> all{vector::Zero()};
    for (int axis = 0; axis < 3; ++axis)
    {
        if (periodic[axis])
        {
            const std::vector<vector> before(std::move(all));
            all.clear();
            for (const double times : {-1, 0, 1})
            {
                for (vector shift : before)
                {
                    shift[axis] = times*period(axis);
                    all.push_back(shift);
                }
            }
        }
    }
    return all;
}

} // End namespace plateletDynamics
