/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffusivityTable.H"
#include "OFstream.H"
#include "OSspecific.H"


Foam::scalar Foam::diffusivityTable::at(const scalar fraction) const
{
    label above = 0;
    while (above < rows_.size() && rows_[above].fraction < fraction)
    {
        ++above;
    }
    if (above == 0)
    {
        return rows_.first().diffusivity;
    }
    if (above == rows_.size())
    {
        return rows_.last().diffusivity;
    }

    const row& a = rows_[above - 1];
    const row& b = rows_[above];
    const scalar way = (fraction - a.fraction)/(b.fraction - a.fraction);

    return (1 - way)*a.diffusivity + way*b.diffusivity;
}


void Foam::diffusivityTable::write
(
    const fileName& file,
    const string& title,
    const scalar concentration,
    const bool onlyDiffusivity
) const
{
    mkDir(file.path());
    OFstream os(file);
    os.precision(8);

    os  << "# " << title.c_str() << nl
        << "# concentration[mol/m3] " << concentration << nl
        << "# solidFraction[-]" << tab << "D[m2/s]" << tab
        << "standardError[m2/s]";
    if (!onlyDiffusivity)
    {
        for (const word& column : more_)
        {
            os  << tab << column.c_str();
        }
    }
    os  << nl;

    for (const row& line : rows_)
    {
        os  << line.fraction << tab << line.diffusivity << tab
            << line.standardError;
        if (!onlyDiffusivity)
        {
            for (const scalar value : line.more)
            {
                os  << tab << value;
            }
        }
        os  << nl;
    }

    if (!os.good())
    {
        FatalErrorInFunction
            << "Could not write " << file << exit(FatalError);
    }
}
