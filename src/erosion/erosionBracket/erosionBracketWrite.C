/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "erosionBracket.H"
#include "physicalConstants.H"
#include "error.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

using colloid::physicalConstants::year;


// Four digits, right-aligned in a column
std::string column(const scalar value, const int width)
{
    std::ostringstream text;
    text<< std::setw(width) << std::setprecision(4) << value;
    return text.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::erosionBracket::write
(
    Ostream& os,
    const edge& where,
    const scalar density
) const
{
    os  << "Erosion of a gel's edge of fraction " << fraction_ << ", "
        << where.sides << " x " << where.length << " m" << nl
        << "Water " << where.velocity << " m/s, aperture " << where.aperture
        << " m" << nl << nl
        << "                          kg/s      mg/h      kg/a   kg/m2/a"
        << "  kg/1e5 a     rim/b" << nl;

    for
    (
        const theory* t :
        {&penetration_, &printed_, &conservative_, &flocculated_}
    )
    {
        const scalar rate = t->rate(where, density);

        std::ostringstream line;
        line<< std::left << std::setw(20) << t->name
            << column(rate, 10)
            << column(rate*1e6*3600, 10)
            << column(rate*year, 10)
            << column(rate*year/where.area(), 10)
            << column(rate*year*1e5, 10);

        if (t->thickness > 0)
        {
            line<< column(t->rimThickness(where)/where.aperture, 10);
        }

        os  << line.str().c_str() << nl;
    }

    os  << nl
        << "Formula 2-2: D of the edge all through the rim, water at full speed."
        << " Rim (A):" << nl
        << "the report's equations, which lose clay on the way; (C): the same,"
        << " keeping it." << nl
        << "A bracket: measured erosion exceeds the theory without"
        << " flocculation by ten" << nl
        << "times or more (TR-17-13, 3.1.3)." << nl
        << "kg/m2/a is per area of the edge, rim/b the rim's thickness"
        << " delta_rim over the" << nl << "aperture." << nl << endl;

    const scalar thickness = conservative_.rimThickness(where)/where.aperture;

    if (thickness < 1)
    {
        WarningInFunction
            << "The rim is thinner than the aperture: delta_rim/b = "
            << thickness << nl
            << "    These theories average across the aperture and hold for"
            << " thicker rims only" << endl;
    }
}


// ************************************************************************* //
