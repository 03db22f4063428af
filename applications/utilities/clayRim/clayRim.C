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

    Writes into postProcessing/clayRim/0, where it replaces its files of another
    case; which case they are of, the file inputs says. All entries:
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
#include "StringStream.H"
#include "Time.H"

#include <fstream>
#include <memory>
#include <sstream>

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


//- The case in words, to the last digit; but for the sweep's
static std::string inputsOf
(
    const dictionary& properties,
    const dictionary& diffusivity,
    const dictionary& place
)
{
    dictionary rim(place);
    rim.remove("sweep");

    OStringStream os;
    os.precision(17);
    os  << "// The case of the files beside this one" << nl;
    properties.write(os, false);
    diffusivity.write(os, false);
    rim.write(os, false);
    return os.str();
}


//- Remove what another run has left: all if it was of another case, otherwise
//  what this run makes anew. Keeps this case's words beside the files
static void removeOld
(
    const fileName& directory,
    const std::string& inputs,
    const bool sweep
)
{
    const fileName file(directory/"inputs");
    std::ostringstream before;
    before << std::ifstream(file).rdbuf();
    const bool same = before.str() == inputs;

    wordList files
    ({
        "edgeLoss.dat", "rimPrinted.dat", "rimConservative.dat",
        "rimFlocculated.dat"
    });
    if (!same || !sweep)
    {
        files.append(wordList({"history.dat", "profiles.dat"}));
    }
    if (!same || sweep)
    {
        files.append
        (
            wordList({"tornado.dat", "samples.dat", "percentiles.dat"})
        );
    }
    for (const word& old : files)
    {
        if (exists(directory/old))
        {
            rm(directory/old);
        }
    }

    std::ofstream os(file);
    os << inputs << std::flush;
    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << file << nl << exit(FatalError);
    }
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

    // What a run that is refused would have made anew stays
    const bool swept = args.found("sweep");
    const auto bracket = matter.bracket(place.edgeFraction(matter));
    const rimProfiles profiles(place, matter);
    std::unique_ptr<rimSweep> sweep;
    std::unique_ptr<rimHistory> history;
    if (swept)
    {
        sweep.reset(new rimSweep(place, properties, diffusivity));
    }
    else if (place.dict().found("expansion"))
    {
        history.reset(new rimHistory(place, matter));
    }

    const fileName directory
    (
        runTime.path()/"postProcessing"/"clayRim"/"0"
    );
    mkDir(directory);
    removeOld
    (
        directory,
        inputsOf
        (
            readFile(runTime, "clayProperties", runTime.constant(), true),
            diffusivity,
            place.dict()
        ),
        swept
    );

    Info<< nl;
    bracket.write(Info, place.edge(), matter.clay().density);
    profiles.write(directory);

    if (sweep)
    {
        sweep->write(directory, Info);
    }
    if (history)
    {
        history->run(directory, Info);
    }

    Info<< "ExecutionTime = " << runTime.elapsedCpuTime() << " s" << nl
        << endl;

    return 0;
}


// ************************************************************************* //
