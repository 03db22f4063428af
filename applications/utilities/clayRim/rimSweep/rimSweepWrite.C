/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimSweep.H"

#include "OFstream.H"
#include "error.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const std::vector<scalar> percentiles{5, 25, 50, 75, 95};


std::string column(const scalar value)
{
    std::ostringstream text;
    text<< std::setw(12) << std::setprecision(4);
    if (value < 0)
    {
        text<< '-';
    }
    else
    {
        text<< value;
    }
    return text.str();
}


autoPtr<OFstream> newFile(const fileName& path)
{
    autoPtr<OFstream> file(new OFstream(path));

    if (!file->good())
    {
        FatalErrorInFunction
            << "Cannot write " << path << nl << exit(FatalError);
    }

    file->precision(8);
    return file;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rimSweep::write(const fileName& directory, Ostream& os) const
{
    os  << "Sweep of " << samples_ << " samples, loss " << loss_
        << "; as in the case " << column(base_).c_str() << " kg/a" << nl
        << nl
        << "input                lower       upper"
        << "  kg/a lower  kg/a upper" << nl;

    auto tornado = newFile(directory/"tornado.dat");
    tornado()
        << "# Rates with an input at the ends of its range, -1 where clay"
        << " does not spread; in the case " << base_ << " kg/a" << nl
        << "# input unit lower upper rateAtLower[kg/a] rateAtUpper[kg/a]"
        << " rateOfCase[kg/a]" << nl;

    for (const bar& b : bars_)
    {
        const input& i = inputs_[b.input];
        std::ostringstream line;
        line<< std::left << std::setw(14) << i.name << std::right
            << column(i.lower) << column(i.upper) << column(b.lower)
            << column(b.upper) << ' ' << i.unit;
        if (b.lower > 0 && b.upper > 0 && base_ > max(b.lower, b.upper))
        {
            line<< ", most in between";
        }
        os  << line.str().c_str() << nl;

        tornado()
            << i.name << ' ' << i.unit << ' ' << i.lower << ' ' << i.upper
            << ' ' << b.lower << ' ' << b.upper << ' ' << base_ << nl;
    }

    auto all = newFile(directory/"samples.dat");
    all() << "#";
    for (const input& i : inputs_)
    {
        all() << ' ' << i.name << '[' << i.unit << ']';
    }
    all() << " rate[kg/a], -1 where clay does not spread" << nl;
    for (label sample = 0; sample < samples_; ++sample)
    {
        for (std::size_t i = 0; i < inputs_.size(); ++i)
        {
            all() << inputs_[i].at(parts_[i][sample]) << ' ';
        }
        all() << rates_[sample] << nl;
    }

    const label coagulated = samples_ - label(sorted_.size());
    os  << nl;
    if (coagulated > 0)
    {
        os  << coagulated << " samples left out: D < 0, their clay coagulates"
            << " and does not spread" << nl;
    }
    if (sorted_.empty())
    {
        os  << "None spreads" << nl << endl;
        return;
    }

    auto band = newFile(directory/"percentiles.dat");
    band() << "# percentile rate[kg/a]" << nl;
    for (label p = 0; p <= 100; ++p)
    {
        band() << p << ' ' << percentile(0.01*p) << nl;
    }

    os  << "percentile [%]";
    for (const scalar p : percentiles)
    {
        os  << column(p).c_str();
    }
    os  << nl << "rate [kg/a]   ";
    for (const scalar p : percentiles)
    {
        os  << column(percentile(0.01*p)).c_str();
    }
    os  << nl << endl;
}


// ************************************************************************* //
