/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "chosenStart.H"

#include "Pstream.H"
#include "Time.H"
#include "checkControls.H"
#include "completeTimes.H"
#include "fileOperation.H"
#include "OSspecific.H"

namespace
{

void refuseCollated(const Foam::dictionary& controlDict)
{
    Foam::word handler(Foam::fileHandler().type());

    const Foam::dictionary* switches =
        controlDict.findDict("OptimisationSwitches");
    if (switches)
    {
        switches->readIfPresent("fileHandler", handler);
    }

    if
    (
        Foam::Pstream::parRun()
     && handler != "uncollated"
     && handler != "masterUncollated"
    )
    {
        FatalIOErrorInFunction(controlDict)
            << "The file handler " << handler << " is not supported: one file"
            << " holds the data of all ranks, and it could not be told whose"
            << " are complete." << Foam::nl
            << "Use -fileHandler uncollated (or masterUncollated)"
            << Foam::exit(Foam::FatalIOError);
    }
}

} // End anonymous namespace


Foam::dictionary Foam::chosenStart::readControlDict
(
    const fileName& rootPath,
    const fileName& caseName,
    fileNameList* files
)
{
    // A Time that reads nothing
    const Time caseOnly
    (
        rootPath,
        caseName,
        "system",
        "constant",
        false,
        false
    );

    unwatchedIOdictionary read
    (
        IOobject
        (
            Time::controlDictName,
            caseOnly.system(),
            caseOnly,
            IOobject::MUST_READ_IF_MODIFIED,
            IOobject::NO_WRITE,
            false
        )
    );

    if (files)
    {
        *files = read.files();
    }
    return read;
}


Foam::chosenStart::chosenStart
(
    const fileName& rootPath,
    const fileName& caseName,
    const fileName& begunWith
)
:
    controlDict(readControlDict(rootPath, caseName, &files))
{
    refuseCollated(controlDict);
    checkControls(controlDict);

    const fileName path(rootPath/caseName);
    start = completeTimes(path, begunWith).start(controlDict);

    // Forgotten reconstructPar, or -parallel
    if (!Pstream::parRun() && isDir(path/"processor0"))
    {
        const instant last(completeTimes(path/"processor0").lastWrittenTime());

        if (last.value() > start.value())
        {
            WarningInFunction
                << "The processor directories have times up to " << last.name()
                << ", this run starts at " << start.value() << ": tables and"
                << " trajectories of theirs are cut there." << nl
                << "    To go on from the former: reconstructPar -latestTime, or"
                << " start in parallel" << nl << endl;
        }
    }

    controlDict.set("startFrom", word("startTime"));
    controlDict.set("startTime", start.value());
}
