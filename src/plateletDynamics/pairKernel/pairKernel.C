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

    if (settings.pairKernel == engineSettings::kernel::fast)
    {
        auto vectors = std::make_unique<vectorKernel>
        (
            force,
            settings.spacing > 0
          ? std::min(settings.spacing, settings.cutOff) : settings.cutOff,
            settings.tableTolerance,
            settings.instructions
        );
        if (vectors->valid())
        {
            return vectors;
        }
    }

    return std::make_unique<scalarKernel<forceTable>>
    (
        force, forceTable(force, settings.tableTolerance)
    );
}

} // End namespace plateletDynamics
