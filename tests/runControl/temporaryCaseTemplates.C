/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "error.H"

template<class Action>
std::string messageOf(Action action)
{
    try
    {
        action();
    }
    catch (const Foam::error& err)
    {
        return err.message();
    }
    return "";
}
