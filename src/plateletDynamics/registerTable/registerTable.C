/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "registerTable.H"

#include "exactLaw.H"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace plateletDynamics
{

namespace
{

constexpr int mantissaBits = 23;
constexpr int exponentOfOne = 127;

std::uint32_t bitsOf(float number)
{
    std::uint32_t bits;
    std::memcpy(&bits, &number, sizeof(bits));
    return bits;
}


float fromBits(std::uint32_t bits)
{
    float number;
    std::memcpy(&number, &bits, sizeof(number));
    return number;
}


//- Coefficients of the polynomial through the values at the places
std::vector<double> polynomial
(
    const std::vector<double>& places,
    std::vector<double> values
)
{
    const int n = int(places.size());

    // Newton's divided differences, then to powers
    for (int k = 1; k < n; ++k)
    {
        for (int i = n - 1; i >= k; --i)
        {
            values[i] = (values[i] - values[i-1])/(places[i] - places[i-k]);
        }
    }

    std::vector<double> powers(n, 0);
    for (int k = n - 1; k >= 0; --k)
    {
        for (int i = n - 1; i > 0; --i)
        {
            powers[i] = powers[i-1] - places[k]*powers[i];
        }
        powers[0] = values[k] - places[k]*powers[0];
    }
    return powers;
}

} // End namespace


double registerTable::lower(int interval) const
{
    // The last one begins at s = 1
    const int parts = 1 << partBits();
    const int below = intervals_ - 1 - interval;
    const int octave = (below + parts - 1)/parts;
    const int part = octave*parts - below;

    return std::ldexp(1 + double(part)/parts, -octave);
}


double registerTable::upper(int interval, double end) const
{
    return interval + 1 < intervals_ ? lower(interval + 1) : end;
}


void registerTable::fit(const taperedForce& force, int degree)
{
    const exactLaw law(force);
    const double end = force.cutOff()*force.cutOff()/taperSquared_;
    const int parts = 1 << partBits();

    degree_ = degree;
    coefficients_.assign(degree + 1, {});

    for (int interval = 0; interval < intervals_; ++interval)
    {
        const double s0 = lower(interval);
        const double s1 = upper(interval, end);
        const double width = std::ldexp(1, std::ilogb(s0))/parts;

        std::vector<double> places;
        std::vector<double> values;
        for (int k = 0; k <= degree; ++k)
        {
            const double c = std::cos(M_PI*(k + 0.5)/(degree + 1));
            const double s = 0.5*(s0 + s1) + 0.5*(s1 - s0)*c;

            places.push_back((s - s0)/width - 0.5);
            values.push_back(law.forceOverDistance(s*taperSquared_));
        }

        const std::vector<double> powers(polynomial(places, values));
        const int entry =
            (bitsOf(float(s0)) >> (mantissaBits - partBits()))
          & (intervals_ - 1);

        for (int k = 0; k <= degree; ++k)
        {
            coefficients_[k][entry] = float(powers[k]);
        }
    }
}


float registerTable::forceOverDistance(float r2) const
{
    const float s = r2*float(1/taperSquared_);
    const std::uint32_t bits = bitsOf(s);
    const int entry =
        (bits >> (mantissaBits - partBits())) & (intervals_ - 1);

    const std::uint32_t mantissa = (1u << mantissaBits) - 1;
    const float t =
        fromBits
        (
            ((bits << partBits()) & mantissa)
          | (std::uint32_t(exponentOfOne) << mantissaBits)
        )
      - 1.5f;

    float value = coefficients_[degree_][entry];
    for (int k = degree_ - 1; k >= 0; --k)
    {
        value = std::fma(value, t, coefficients_[k][entry]);
    }
    return value;
}


double registerTable::largestError
(
    const taperedForce& force,
    double spacing
) const
{
    const exactLaw law(force);
    const double end = force.cutOff()*force.cutOff()/taperSquared_;

    const auto forceAt = [&](double r2)
    {
        return std::abs(std::sqrt(r2)*law.forceOverDistance(r2));
    };

    // Inwards from the cut-off, so that the scale is the largest force beyond;
    // nothing is less than 1e-100 of it
    double scale = std::max
    (
        {1e-100, forceAt(taperSquared_), forceAt(spacing*spacing)}
    );
    double largest = 0;

    constexpr int probes = 64;
    for (int interval = intervals_ - 1; interval >= 0; --interval)
    {
        const double s0 = lower(interval);
        const double s1 = upper(interval, end);

        for (int i = probes - 1; i >= 0; --i)
        {
            const double s = s0 + (i + 0.5)/probes*(s1 - s0);
            const float r2 = float(s*taperSquared_);
            const double r = std::sqrt(double(r2));
            const double exact = r*law.forceOverDistance(r2);

            scale = std::max(scale, std::abs(exact));
            largest = std::max
            (
                largest, std::abs(r*forceOverDistance(r2) - exact)/scale
            );
        }
    }
    return largest;
}


registerTable::registerTable
(
    const taperedForce& force,
    double spacing,
    int intervals,
    double tolerance
)
:
    intervals_(intervals),
    taperSquared_(std::pow(taperedForce::taperBegin*force.cutOff(), 2))
{
    // The contact has a kink of its own
    if (intervals && force.contactDistance()*force.contactDistance() < beginSquared())
    {
        for (int degree = lowestDegree; degree <= highestDegree; ++degree)
        {
            fit(force, degree);
            if (largestError(force, spacing) <= tolerance)
            {
                return;
            }
        }
    }
    degree_ = 0;
}

} // End namespace plateletDynamics
