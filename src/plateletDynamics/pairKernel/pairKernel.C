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

namespace
{

//- Of the tolerance: neighbours at equal distances add up their errors, while
//  their forces nearly cancel
constexpr double shareOfOnePair = 0.25;

} // End namespace


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
            shareOfOnePair*settings.tableTolerance
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
