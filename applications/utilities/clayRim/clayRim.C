/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    clayRim

Description
    Erosion of a gel's edge by theory, in seconds: the bracket of rates, its
    rims in full (rimProfiles.H), and where system/clayRimDict has an
    `expansion`, the gel that swells from a hole up to the rim where it is
    taken (the two-region model). Needs constant/ and system/, no mesh.

        clayRim -sweep      what uncertain inputs make of the rate

    Writes into postProcessing/clayRim/0. All entries:
    etc/caseDicts/clayRimDict.
\*---------------------------------------------------------------------------*/

#include "rimHistory.H"
#include "rimProfiles.H"
#include "rimSweep.H"

#include "argList.H"
#include "caseLock.H"
#include "checkControls.H"
#include "dictionaryText.H"
#include "IOdictionary.H"
#include "logDigits.H"
#include "OSspecific.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A dictionary of the case; empty if there is no such file and none is needed
static dictionary readFile
(
    const Time& runTime,
    const word& name,
    const fileName& folder,
    const bool needed
)
{
    IOobject io
    (
        name, folder, runTime, IOobject::MUST_READ, IOobject::NO_WRITE, false
    );

    if (io.typeHeaderOk<IOdictionary>(true))
    {
        return IOdictionary(io);
    }
    if (needed)
    {
        FatalErrorInFunction
            << "No readable file " << folder/name << " in the case "
            << runTime.globalPath() << nl
            << "An example with all entries: etc/caseDicts/" << name
            << " in bentoFoam" << nl << exit(FatalError);
    }

    return dictionary();
}


//- The model of D, Liu's without a file that names another
static dictionary diffusivityOf(const Time& runTime)
{
    const dictionary erosion
    (
        readFile(runTime, "erosionProperties", runTime.constant(), false)
    );

    if (erosion.found("diffusivity"))
    {
        return erosion.subDict("diffusivity");
    }

    dictionary Liu;
    Liu.add("model", "Liu");
    return Liu;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Erosion of a gel's edge by theory, in seconds. Needs no mesh.\n"
        "Reads system/clayRimDict (all entries: etc/caseDicts/clayRimDict) and\n"
        "constant/clayProperties; writes postProcessing/clayRim/0."
    );
    argList::noParallel();
    argList::addBoolOption
    (
        "sweep", "Vary the inputs of sweep in system/clayRimDict"
    );

    argList args(argc, argv);

    if (!args.checkRootCase())
    {
        FatalError.exit();
    }
    colloid::dictionaryText::checkCase();

    const caseLock lock(args);
    checkControls(args);
    Time runTime(Time::controlDictName, args);
    setLogDigits();

    const colloid::clayProperties properties(runTime);
    const dictionary diffusivity(diffusivityOf(runTime));
    const rimMatter matter(properties, diffusivity, 0);
    const rimCase place
    (
        readFile(runTime, "clayRimDict", runTime.system(), true),
        matter.water()
    );

    const fileName directory
    (
        runTime.path()/"postProcessing"/"clayRim"/"0"
    );
    mkDir(directory);

    Info<< nl;
    matter.bracket(place.edgeFraction(matter)).write
    (
        Info, place.edge(), matter.clay().density
    );

    rimProfiles(place, matter).write(directory);

    if (args.found("sweep"))
    {
        rimSweep(place, properties, diffusivity).write(directory, Info);
    }
    else if (place.dict().found("expansion"))
    {
        rimHistory(place, matter).run(directory, Info);
    }

    Info<< "ExecutionTime = " << runTime.elapsedCpuTime() << " s" << nl
        << endl;

    return 0;
}


// ************************************************************************* //
