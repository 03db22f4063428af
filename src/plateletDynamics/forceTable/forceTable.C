/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "forceTable.H"

#include "userError.H"

#include <algorithm>

namespace plateletDynamics
{

void forceTable::tabulate(double begin, double step, int intervals)
{
    // F/r and its derivative with respect to r^2, per interval
    const auto knot = [&](int i)
    {
        const double r2 = begin + i*step;
        const double value = exact_.forceOverDistance(r2);

        return std::array<double, 2>
        {
            value,
            step*(exact_.slope(r2) - value)/(2*r2)
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
    const auto force = [&](double r2)
    {
        return std::sqrt(r2)*exact_.forceOverDistance(r2);
    };

    // Inwards from the cut-off, so that the scale is the largest force beyond.
    // Nothing is less than 1e-100 of it
    double scale = std::max
    (
        1e-100, std::abs(force(std::pow(taperedForce::taperBegin*cutOff, 2)))
    );
    double largest = 0;

    for (int i = int(intervals()) - 1; i >= 0; --i)
    {
        for (const double u : {0.9, 0.6, 0.35, 0.1})
        {
            const double r2 = begin_ + (i + u)/perInterval_;
            const double exact = force(r2);
            const double error =
                std::abs(std::sqrt(r2)*forceOverDistance(r2) - exact);

            scale = std::max(scale, std::abs(exact));
            largest = std::max(largest, error/scale);
        }
    }
    return largest;
}


forceTable::forceTable(const taperedForce& force, double tolerance)
:
    exact_(force)
{
    const double end = force.cutOff()*force.cutOff();
    const double taper =
        end - std::pow(taperedForce::taperBegin*force.cutOff(), 2);

    double error = 0;

    // The nearest begin that will do, but not into the contact, where the
    // force has a kink
    for (const double fraction : {0.1, 0.2, 0.4})
    {
        const double nearest =
            std::max(fraction*force.cutOff(), force.contactDistance());

        // Whole intervals in the taper: its begin has a kink too
        for (int inTaper = 32; inTaper <= 1024; inTaper *= 2)
        {
            const double step = taper/inTaper;
            const int intervals = int((end - nearest*nearest)/step);

            if (intervals > 0)
            {
                tabulate(end - intervals*step, step, intervals);
                error = largestError(force.cutOff());

                if (error <= tolerance)
                {
                    return;
                }
            }
        }
    }

    throw userError
    (
        text
        (
            "A table of the force reaches a relative error of ", error,
            ", not the tolerance of ", tolerance,
            ". Allow a larger tolerance or use the exact kernel"
        )
    );
}

} // End namespace plateletDynamics
