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

    rows_.append
    (
        row{name, measureIs, measure, threshold, on, automatic ? "auto" : "user"}
    );
    return on;
}


void Foam::effectTable::unavailable
(
    const word& name,
    const cloudProperties& properties,
    const string& measureIs,
    const scalar measure,
    const scalar threshold
)
{
    if (properties.effect(name) == cloudProperties::choice::on)
    {
        FatalIOErrorInFunction(properties.dict().subDict("effects"))
            << "The effect '" << name << "' is not available in this version."
            << " Its measure here (" << measureIs.c_str() << ") is " << measure
            << "; set it to off or auto" << exit(FatalIOError);
    }
    rows_.append
    (
        row{name, measureIs, measure, threshold, false, "unavailable"}
    );
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

    for (const row& r : rows_)
    {
        if (r.whoSaid == "unavailable" && r.measure >= r.threshold)
        {
            WarningInFunction
                << r.name << " would be on by its measure, but this version"
                << " does not compute it" << nl << endl;
        }
    }
}
