/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unreadField.H"

#include "OSspecific.H"
#include "Time.H"

void Foam::colloid::sayUnread
(
    const Time& runTime,
    const word& field,
    const std::string& instead
)
{
    if
    (
        isFile(runTime.timePath()/field)
     && !isFile(runTime.timePath()/"uniform"/"restartableTime")
    )
    {
        Info<< runTime.timeName()/field << " is not read: " << instead.c_str()
            << endl;
    }
}


// ************************************************************************* //
