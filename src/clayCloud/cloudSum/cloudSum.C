/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudSum.H"
#include "meshIdentity.H"
#include "PstreamReduceOps.H"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace
{

using Foam::scalar;

//- Each bit of the result depends on all of the number (splitmix64's)
std::uint64_t mixed(std::uint64_t number)
{
    number += 0x9e3779b97f4a7c15u;
    number = (number ^ (number >> 30))*0xbf58476d1ce4e5b9u;
    number = (number ^ (number >> 27))*0x94d049bb133111ebu;
    return number ^ (number >> 31);
}


std::uint64_t bitsOf(const double number)
{
    // Without the sign of a zero, which text loses
    const double positiveZero = number + 0.0;
    std::uint64_t bits;
    std::memcpy(&bits, &positiveZero, sizeof(bits));
    return bits;
}


//- What is read back from a file of so many digits; 0: of all bits
scalar asStored(const scalar number, const int digits)
{
    if (!digits)
    {
        return number;
    }
    char text[64];
    std::snprintf(text, sizeof(text), "%.*g", digits, double(number));
    return std::strtod(text, nullptr);
}


//- Sum over the ranks, modulo 2^64, by halves that a scalar holds exactly
std::uint64_t sumOfRanks(const std::uint64_t own)
{
    scalar low = scalar(own & 0xffffffffu);
    scalar high = scalar(own >> 32);
    Foam::reduce(low, Foam::sumOp<scalar>());
    Foam::reduce(high, Foam::sumOp<scalar>());
    return std::uint64_t(low) + (std::uint64_t(high) << 32);
}

} // End anonymous namespace


Foam::cloudSum::cloudSum
(
    const Cloud<clayPlatelet>& cloud,
    const int digits
)
:
    number_(cloud.size())
{
    std::uint64_t sum = 0;

    for (const clayPlatelet& platelet : cloud)
    {
        const clayPlatelet::properties& state = platelet.state();

        std::uint64_t hash = mixed(std::uint64_t(state.id));
        hash = mixed(hash ^ std::uint64_t(state.fixed));
        hash = mixed(hash ^ std::uint64_t(state.inlet + 1));

        const scalar weight = 2*(scalar(hash >> 11)/scalar(1ull << 53)) - 1;

        for (direction axis = 0; axis < 3; ++axis)
        {
            const scalar x = asStored(state.x[axis], digits);

            places_[axis] += weight*x;
            squares_[axis] += sqr(x);
            hash = mixed(hash ^ bitsOf(x));
        }
        sum += hash;
    }
    reduce(number_, sumOp<label>());
    reduce(places_, sumOp<vector>());
    reduce(squares_, sumOp<vector>());

    std::ostringstream text;
    text<< std::hex << std::setfill('0') << std::setw(16) << sumOfRanks(sum);
    checksum_ = text.str();
}


Foam::cloudSum::cloudSum(const dictionary& dict)
:
    number_(dict.get<label>("number")),
    checksum_(dict.get<string>("checksum")),
    places_(dict.get<vector>("places")),
    squares_(dict.get<vector>("squares"))
{}


Foam::cloudSum::match Foam::cloudSum::compare(const cloudSum& other) const
{
    if (number_ != other.number_)
    {
        return match::none;
    }
    if (checksum_ == other.checksum_)
    {
        return match::exact;
    }
    for (direction axis = 0; axis < 3; ++axis)
    {
        // What rounding takes or adds is at most this part of each place, at
        // random, and so are the weights: with a standard deviation of a third
        // of it in the root of the squares. Six of them
        if
        (
            mag(places_[axis] - other.places_[axis])
          > 2*meshIdentity::roundOff()*Foam::sqrt(squares_[axis])
        )
        {
            return match::none;
        }
    }
    return match::fewerDigits;
}


void Foam::cloudSum::write(Ostream& os) const
{
    os.writeEntry("number", number_);
    os.writeEntry("checksum", checksum_);
    os.writeEntry("places", places_);
    os.writeEntry("squares", squares_);
}
