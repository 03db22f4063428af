/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "pairKernel.H"

#include "exactLaw.H"
#include "forceTable.H"
#include "scalarKernel.H"
#include "vectorKernel.H"

#include <algorithm>

namespace plateletDynamics
{

std::unique_ptr<pairKernel> pairKernel::New
(
    const taperedForce& force,
    const engineSettings& settings,
    const vectorLoops& loops
)
{
    if (settings.pairKernel == engineSettings::kernel::exact)
    {
        return std::make_unique<scalarKernel<exactLaw>>
        (
            force, exactLaw(force)
        );
    }

    forceTable table(force, settings.tableTolerance);

    if (settings.pairKernel == engineSettings::kernel::fast)
    {
        registerTable registers
        (
            force,
            settings.spacing > 0
          ? std::min(settings.spacing, settings.cutOff) : settings.cutOff,
            loops.intervals,
            settings.tableTolerance
        );
        if (registers.valid())
        {
            return std::make_unique<vectorKernel>
            (
                force, loops, std::move(registers), std::move(table)
            );
        }
    }

    return std::make_unique<scalarKernel<forceTable>>(force, std::move(table));
}

} // End namespace plateletDynamics
