/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "LiusClay.H"
#include "IStringStream.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

dictionary parse(const std::string& text)
{
    // A stream from text counts its lines from 0, a file from 1
    IStringStream stream("\n" + text);
    return dictionary("constant/someFile", dictionary(), stream);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

LiusClay::LiusClay(const std::string& entries)
:
    properties(parse(entries)),
    water(properties.waterAt(0)),
    viscosity(properties.viscosity(water)),
    D
    (
        properties.clay(),
        water,
        properties.newDoubleLayer("compression", water)(),
        properties.newFriction("KozenyCarman", water)()
    )
{}


// ************************************************************************* //
