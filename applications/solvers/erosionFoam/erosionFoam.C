/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    erosionFoam

Group
    grpIncompressibleSolvers

Description
    Clay as a continuum in a water-filled fracture: its solid fraction spreads
    by diffusion, makes the water viscous and is carried away by it.

    Reads constant/{clayProperties,erosionProperties,fractureFlowProperties}
    and 0/alpha.clay. Time steps follow the tolerance in fvSolution; with
    ddtSchemes steadyState they are iterations, until the residual is reached.
    In controlDict, with adjustTimeStep: maxCo, for flow models that need it,
    and maxDeltaT.

    With -postProcess (and -time, -latestTime, -func ...) function objects evaluate
    old times; those that need the run say why.
\*---------------------------------------------------------------------------*/

#include "checkWords.H"
#include "clayTransport.H"
#include "costReport.H"
#include "dictionaryText.H"
#include "fieldsOfTime.H"
#include "fractureFlow.H"
#include "fvCFD.H"
#include "progress.H"
#include "restartableTime.H"
#include "saltTransport.H"

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Clay as a continuum: spreading and erosion in a fracture"
    );

    // Old times, with OpenFOAM's own Time: nothing of the run is touched
    #define CREATE_FIELDS createOldFields.H
    #define NO_CONTROL
    #include "postProcess.H"

    #include "setRootCase.H"
    const fileName begunWith("alpha.clay");
    colloid::dictionaryText::checkCase();
    #include "createRestartableTime.H"
    #include "createMesh.H"
    #include "createFields.H"

    progress log(runTime, "");
    costReport cost;
    scalar residual = 0;

    while (runTime.run())
    {
        #include "setDeltaT.H"

        ++runTime;
        {
            const auto timing = cost.start("flow");
            flow->solve();
        }
        {
            const auto timing = cost.start("salt");
            salt.solve(flow->phi(), flow->apertureRatio());
        }
        {
            const auto timing = cost.start("clay");
            #include "advance.H"
        }
        {
            const auto timing = cost.start("write");
            runTime.writeIfDue();
        }
    }

    if (clay.steady() && !clay.converged(residual))
    {
        WarningInFunction
            << "Not steady: residual " << residual << " after the last"
            << " iteration" << nl
            << "    endTime in controlDict is the most iterations" << endl;
    }
    clay.report(Info);
    cost.report(Info, 0, clay.steady() ? 0 : runTime.value());

    return 0;
}
