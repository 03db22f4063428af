/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "logDigits.H"

#include "error.H"
#include "IOstreams.H"
#include "prefixOSstream.H"

void Foam::setLogDigits()
{
    constexpr int digits = 6;

    Sout.precision(digits);
    Serr.precision(digits);
    Pout.precision(digits);
    Perr.precision(digits);

    error& fatalIO = FatalIOError;
    for (error* fatal : {&FatalError, &fatalIO})
    {
        static_cast<OSstream&>(*fatal).precision(digits);
    }
}
