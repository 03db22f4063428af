/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "pairKernel.H"

#include "exactLaw.H"
#include "forceTable.H"
#include "scalarKernel.H"

namespace plateletDynamics
{

std::unique_ptr<pairKernel> pairKernel::New
(
    const taperedForce& force,
    const engineSettings& settings
)
{
    if (settings.pairKernel == engineSettings::kernel::exact)
    {
        return std::make_unique<scalarKernel<exactLaw>>
        (
            force, exactLaw(force)
        );
    }

    return std::make_unique<scalarKernel<forceTable>>
    (
        force, forceTable(force, settings.tableTolerance)
    );
}

} // End namespace plateletDynamics
