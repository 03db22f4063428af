/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "forceTable.H"

#include "userError.H"

#include <algorithm>

namespace plateletDynamics
{

void forceTable::tabulate(double begin, double end, int intervals)
{
    const double step = (end - begin)/intervals;

    // F/r and its derivative with respect to r^2, per interval
    const auto knot = [&](int i)
    {
        const double r2 = begin + i*step;
        const double r = std::sqrt(r2);
        const double value = exact_.forceOverDistance(r2);

        return std::array<double, 2>
        {
            value,
            step*(exact_.slope(r) - value)/(2*r2)
        };
    };

    begin_ = begin;
    perInterval_ = 1/step;
    cubic_.clear();

    std::array<double, 2> left(knot(0));
    for (int i = 0; i < intervals; ++i)
    {
        const std::array<double, 2> right(knot(i + 1));
        const double rise = right[0] - left[0];

        cubic_.push_back
        ({
            left[0],
            left[1],
            3*rise - 2*left[1] - right[1],
            left[1] + right[1] - 2*rise
        });
        left = right;
    }

    // Rounding may put a pair just inside the cut-off beyond the last
    cubic_.push_back({0, 0, 0, 0});
}


double forceTable::largestError(double cutOff) const
{
    double scale = 0;
    double largest = 0;

    // Inwards from the cut-off, so that the scale is the largest force beyond
    for (int i = int(intervals()) - 1; i >= 0; --i)
    {
        for (const double u : {0.9, 0.6, 0.35, 0.1})
        {
            const double r2 = begin_ + (i + u)/perInterval_;
            const double r = std::sqrt(r2);
            const double exact = exact_.forceOverDistance(r2);

            scale = std::max(scale, std::abs(exact*r));
            const double beforeTaper =
                r < taperedForce::taperBegin*cutOff
              ? scale
              : std::max
                (
                    scale,
                    std::abs
                    (
                        taperedForce::taperBegin*cutOff
                       *exact_.forceOverDistance
                        (
                            std::pow(taperedForce::taperBegin*cutOff, 2)
                        )
                    )
                );
            const double error = std::abs(forceOverDistance(r2) - exact)*r;

            if (error > 0)
            {
                largest = std::max(largest, error/beforeTaper);
            }
        }
    }
    return largest;
}


forceTable::forceTable(const taperedForce& force, double tolerance)
:
    exact_(force)
{
    const double cutOff = force.cutOff();
    double error = 0;

    // Not into the contact, where the force has a kink
    for (const double fraction : {0.1, 0.2, 0.4})
    {
        const double begin =
            std::max(fraction*cutOff, force.contactDistance());

        for (int intervals = 256; intervals <= 8192; intervals *= 2)
        {
            tabulate(begin*begin, cutOff*cutOff, intervals);
            error = largestError(cutOff);

            if (error <= tolerance)
            {
                return;
            }
        }
    }

    throw userError
    (
        text
        (
            "A table of the force reaches a relative error of ", error,
            ", not the tolerance of ", tolerance,
            ". Allow a larger tableTolerance or use the exact kernel"
        )
    );
}

} // End namespace plateletDynamics
