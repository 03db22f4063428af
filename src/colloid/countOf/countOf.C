/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "countOf.H"
#include "error.H"

#include <cmath>
#include <cstdio>

namespace
{

using namespace Foam;

//- Doubles beyond have no last digit
constexpr scalar allDigits = 1e15;


//- nan too, comparing which would trap
bool isCount(const scalar number, const scalar most)
{
    return
        std::isgreater(number, -1)
     && std::islessequal(number, std::fmin(most, labelMax));
}


void explain
(
    OSstream& message,
    const scalar number,
    const std::string& ofWhat,
    const scalar most
)
{
    message
        << "The number of " << ofWhat.c_str() << " comes to "
        << colloid::inDigits(number).c_str() << "; possible are 0 to "
        << colloid::inDigits(std::fmin(most, labelMax)).c_str() << "." << nl
        << "    Are all lengths, and the mesh (scale in blockMeshDict), in metres?"
        << nl;
}

} // End anonymous namespace


Foam::label Foam::colloid::countOf
(
    const scalar number,
    const std::string& ofWhat,
    const dictionary& dict,
    const scalar most
)
{
    if (!isCount(number, most))
    {
        explain(FatalIOErrorInFunction(dict), number, ofWhat, most);
        FatalIOError<< exit(FatalIOError);
    }
    return label(number);
}


Foam::label Foam::colloid::countOf
(
    const scalar number,
    const std::string& ofWhat,
    const scalar most
)
{
    if (!isCount(number, most))
    {
        explain(FatalErrorInFunction, number, ofWhat, most);
        FatalError<< exit(FatalError);
    }
    return label(number);
}


std::string Foam::colloid::inDigits(const scalar number)
{
    char text[64];
    const bool exact = std::isless(std::fabs(number), allDigits);
    std::snprintf(text, sizeof(text), exact ? "%.0f" : "%.3g", double(number));
    return text;
}
