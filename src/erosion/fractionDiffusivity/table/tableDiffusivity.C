/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableDiffusivity.H"
#include "addToRunTimeSelectionTable.H"
#include "caseFile.H"
#include "IFstream.H"
#include "readInRange.H"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Foam
{
namespace fractionDiffusivities
{
    defineTypeNameAndDebug(tableDiffusivity, 0);
    addToRunTimeSelectionTable
    (
        fractionDiffusivity, tableDiffusivity, dictionary
    );
}
}

namespace
{

using rows = Foam::fractionDiffusivities::tableDiffusivity::rows;

//- Relative difference of the concentration from which on D is another
constexpr Foam::scalar otherWater = 0.01;

class betweenRows
:
    public Foam::fractionDiffusivity::inWater
{
    const std::shared_ptr<const rows> rows_;

public:

    explicit betweenRows(const std::shared_ptr<const rows>& table)
    :
        rows_(table)
    {}

    virtual Foam::scalar value(const Foam::scalar alpha) const
    {
        const rows& table = *rows_;
        const auto above = std::upper_bound
        (
            table.begin(),
            table.end(),
            alpha,
            [](const Foam::scalar a, const rows::value_type& row)
            {
                return a < row.first();
            }
        );

        if (above == table.end())
        {
            return table.last().second();
        }
        if (above == table.begin())
        {
            return table.first().second();
        }

        const auto below = above - 1;
        return
            below->second()
          + (above->second() - below->second())
           *(alpha - below->first())/(above->first() - below->first());
    }
};

} // End anonymous namespace


Foam::fractionDiffusivities::tableDiffusivity::rows
Foam::fractionDiffusivities::tableDiffusivity::read
(
    const dictionary& dict
)
{
    IFstream file(file_);

    if (!file.good())
    {
        FatalIOErrorInFunction(dict)
            << "Cannot read the file " << file_ << nl
            << "It is the diffusivity.dat of a function object clayDiffusivity,"
            << " or lines of solid fraction and D [m2/s]"
            << exit(FatalIOError);
    }

    rows table;
    string line;

    while (file.getLine(line), file.good() || line.size())
    {
        const auto comment = line.find('#');
        std::istringstream words(line.substr(0, comment));
        scalar fraction, D;

        if (comment != std::string::npos)
        {
            std::istringstream said(line.substr(comment + 1));
            std::string name;
            scalar concentration;

            if
            (
                said >> name && name == "concentration[mol/m3]"
             && said >> concentration
            )
            {
                concentration_ = concentration;
            }
        }

        if (words >> fraction)
        {
            if
            (
                !(words >> D) || !std::isfinite(D)
             || fraction <= 0 || fraction >= 1
             || (table.size() && fraction <= table.last().first())
            )
            {
                FatalIOErrorInFunction(dict)
                    << file_ << ", line " << file.lineNumber() << ": '"
                    << line.c_str() << "' is not a row of the table" << nl
                    << "Valid: a solid fraction above 0 and below 1, larger"
                    << " than in the row before, and D [m2/s]"
                    << exit(FatalIOError);
            }
            table.append(rows::value_type(fraction, D));
        }
        else if (words.clear(), words.str().find_first_not_of(" \t\r") != std::string::npos)
        {
            FatalIOErrorInFunction(dict)
                << file_ << ", line " << file.lineNumber() << ": '"
                << line.c_str() << "' does not begin with a solid fraction"
                << exit(FatalIOError);
        }
        if (!file.good())
        {
            break;
        }
        line.clear();
    }

    if (table.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No rows in " << file_ << exit(FatalIOError);
    }
    return table;
}


Foam::fractionDiffusivities::tableDiffusivity::tableDiffusivity
(
    const dictionary& dict,
    const colloid::clayProperties& matter
)
:
    fractionDiffusivity(dict, {"file"}),
    file_(colloid::caseFile(dict, "file")),
    concentration_(0),
    warned_(false)
{
    rows table(1);
    const colloid::water water(matter.waterAt(0));
    table[0] = rows::value_type
    (
        0,
        water.thermalEnergy()
       /matter.newFriction(water)->value(0)
    );
    table.append(read(dict));

    rows_.reset(new rows(table));
    warnOfOther(water);
}


void Foam::fractionDiffusivities::tableDiffusivity::warnOfOther
(
    const colloid::water& solution
) const
{
    if
    (
        !warned_ && concentration_ > 0
     && mag(solution.concentration - concentration_)
      > otherWater*concentration_
    )
    {
        warned_ = true;
        WarningInFunction
            << file_ << " is of clay in water of " << concentration_
            << " mol/m3; here it has " << solution.concentration << " mol/m3"
            << nl << "    D of the table is used all the same" << nl << endl;
    }
}


void Foam::fractionDiffusivities::tableDiffusivity::warnBeyond
(
    const scalar largest
) const
{
    const auto& last = rows_->last();

    if (largest > last.first())
    {
        WarningInFunction
            << file_ << " ends at a solid fraction of " << last.first()
            << "; up to " << largest << " are possible (packing in"
            << " erosionProperties)" << nl
            << "    Beyond its last row D is held at " << last.second()
            << " m2/s" << nl << endl;
    }
}


Foam::autoPtr<Foam::fractionDiffusivity::inWater>
Foam::fractionDiffusivities::tableDiffusivity::at
(
    const colloid::water& solution
) const
{
    warnOfOther(solution);
    return autoPtr<inWater>(new betweenRows(rows_));
}


void Foam::fractionDiffusivities::tableDiffusivity::describe
(
    Ostream& os
) const
{
    os  << file_ << ", " << rows_->size() - 1 << " rows of solid fraction "
        << (*rows_)[1].first() << " to " << rows_->last().first();
}
