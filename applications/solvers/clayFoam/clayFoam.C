/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    clayFoam

Group
    grpLagrangianSolvers

Description
    Coupled CFD-DEM of clay platelets in a water-filled fracture: the water
    carries the platelets, their solid fraction decides its viscosity.

    Reads constant/{clayProperties,clayCloudProperties,fractureFlowProperties}
    and the cloud that setClay placed. In controlDict, with adjustTimeStep:
    maxCo (Courant number of the water) and maxDisplacement (of a platelet,
    in filter lengths per step).

    With -postProcess (and -time, -latestTime, -func ...) function objects evaluate
    old times; those that need the run say why.
\*---------------------------------------------------------------------------*/

#include "checkWords.H"
#include "clayCloud.H"
#include "clayProperties.H"
#include "clayState.H"
#include "costReport.H"
#include "dictionaryText.H"
#include "fieldsOfTime.H"
#include "fractureFlow.H"
#include "fvCFD.H"
#include "progress.H"
#include "restartableTime.H"

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Clay platelets in a water-filled fracture: coupled CFD-DEM"
    );

    // Old times, with OpenFOAM's own Time: nothing of the run is touched
    #define CREATE_FIELDS createOldFields.H
    #define NO_CONTROL
    #include "postProcess.H"

    #include "setRootCase.H"
    const fileName begunWith(clayState::file());
    colloid::dictionaryText::checkCase();
    #include "createRestartableTime.H"
    #include "createMesh.H"

    colloid::checkSpelling
    (
        runTime.controlDict(),
        mesh.solutionDict(),
        colloid::variablesOfControls()
    );

    const colloid::clayProperties matter(runTime);
    clayCloud clay(mesh, matter);
    autoPtr<fractureFlow> flow(fractureFlow::New(mesh, clay.alpha()));
    const fractureFlow& water = *flow;

    progress log(runTime, clay.counted());
    costReport cost;
    bool tooFast = false;

    const auto goesOn = [&]
    {
        const auto timing = cost.start("function objects");
        return runTime.run();
    };

    while (goesOn())
    {
        #include "setDeltaT.H"

        ++runTime;
        {
            const auto timing = cost.start("flow");
            flow->solve();
        }
        {
            const auto timing = cost.start("platelets");
            clay.move(water.U(), runTime.deltaTValue());
        }
        {
            const auto timing = cost.start("filter");
            clay.filter(runTime.deltaTValue());
        }
        {
            const auto timing = cost.start("write");
            runTime.writeIfDue();
        }

        log.report(clay.inWater());

        if (!tooFast && clay.maxDeltaT(1) < runTime.deltaTValue())
        {
            tooFast = true;
            WarningInFunction
                << "Platelets move by more than a filter length in a step of "
                << runTime.deltaTValue() << " s: the flow and alpha.clay lag"
                << " behind." << nl << "    At most " << clay.maxDeltaT(0.5)
                << " s, or adjustTimeStep yes (controlDict)" << nl << endl;
        }
    }

    clay.report(Info, cost);

    return 0;
}
