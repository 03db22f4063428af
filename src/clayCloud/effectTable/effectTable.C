/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectTable.H"
#include "error.H"

#include <iomanip>
#include <sstream>

bool Foam::effectTable::decide
(
    const word& name,
    const cloudProperties::choice choice,
    const string& measureIs,
    const scalar measure,
    const scalar threshold
)
{
    const bool automatic = (choice == cloudProperties::choice::automatic);

    const bool on =
        automatic
      ? measure >= threshold
      : choice == cloudProperties::choice::on;

    note(name, measureIs, measure, threshold, on, automatic ? "auto" : "user");
    return on;
}


void Foam::effectTable::note
(
    const word& name,
    const string& measureIs,
    const scalar measure,
    const scalar threshold,
    const bool on,
    const word& whoSaid
)
{
    rows_.append(row{name, measureIs, measure, threshold, on, whoSaid});
}


bool Foam::effectTable::printChanges
(
    Ostream& os,
    const effectTable& before
) const
{
    bool any = false;

    forAll(rows_, i)
    {
        const row& r = rows_[i];

        if (r.on != before.rows_[i].on)
        {
            any = true;
            os  << "    " << r.name << " is " << (r.on ? "on" : "off")
                << " from here on: " << r.measureIs.c_str() << " is "
                << r.measure << ", threshold " << r.threshold << nl;
        }
    }
    return any;
}


void Foam::effectTable::print(Ostream& os) const
{
    std::ostringstream text;
    text
        << std::left << std::setw(14) << "effect"
        << std::setw(33) << "measure"
        << std::right << std::setw(9) << "value"
        << std::setw(10) << "threshold" << "  on by" << '\n';

    for (const row& r : rows_)
    {
        text
            << std::left << std::setw(14) << r.name
            << std::setw(33) << r.measureIs
            << std::right << std::setprecision(2) << std::scientific
            << std::setw(9) << r.measure
            << std::setw(10) << r.threshold
            << (r.on ? "  on  " : "  off ") << r.whoSaid << '\n';
    }

    os  << text.str().c_str() << endl;
}
