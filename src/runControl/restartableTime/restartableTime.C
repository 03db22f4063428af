/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "restartableTime.H"

#include "IOdictionary.H"
#include "PstreamReduceOps.H"
#include "argList.H"
#include "checkControls.H"
#include "chosenStart.H"
#include "exactTimeState.H"
#include "fileOperation.H"
#include "functionObject.H"
#include "logDigits.H"
#include "OSspecific.H"
#include "incompleteMarker.H"
#include "ofAllRanks.H"
#include "wholeFiles.H"

#include <csignal>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

//- Sets a value for as long as it lives
template<class Type>
class temporarily
{
    Type& variable_;
    const Type saved_;

public:

    temporarily(Type& variable, const Type& value)
    :
        variable_(variable),
        saved_(variable)
    {
        variable_ = value;
    }

    ~temporarily()
    {
        variable_ = saved_;
    }
};


//- Function objects are on as the program's options say
bool functionObjectsWanted(const Foam::argList& args)
{
    using Foam::argList;

    return
        argList::validOptions.found("withFunctionObjects")
      ? args.found("withFunctionObjects")
      : argList::validOptions.found("noFunctionObjects")
     && !args.found("noFunctionObjects");
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

Foam::restartableTime::restartableTime
(
    const argList& args,
    const fileName& begunWith
)
:
    restartableTime
    (
        args.rootPath(),
        args.caseName(),
        functionObjectsWanted(args),
        !args.found("no-libs"),
        begunWith
    )
{}


Foam::restartableTime::restartableTime
(
    const fileName& rootPath,
    const fileName& caseName,
    const bool enableFunctionObjects,
    const bool enableLibs,
    const fileName& begunWith
)
:
    restartableTime
    (
        rootPath,
        caseName,
        enableFunctionObjects,
        enableLibs,
        chosenStart(rootPath, caseName, begunWith)
    )
{}


Foam::restartableTime::restartableTime
(
    const fileName& rootPath,
    const fileName& caseName,
    const bool enableFunctionObjects,
    const bool enableLibs,
    const chosenStart& chosen
)
:
    Time
    (
        chosen.controlDict,
        rootPath,
        caseName,
        "system",
        "constant",
        enableFunctionObjects,
        enableLibs
    ),
    timesKept_(purgeWrite_),
    timesWritten_(),
    lastComplete_(chosen.start.name()),
    scheduleStart_(startTime_)
{
    purgeWrite_ = 0;
    setLogDigits();

    // Time can't know which file its dictionary came from
    if (runTimeModifiable())
    {
        auto& control = const_cast<unwatchedIOdictionary&>
        (
            dynamic_cast<const unwatchedIOdictionary&>(controlDict())
        );
        fileHandler().addWatches(control, chosen.files);
    }

    // As written by hand: 1e-3 for 0.001
    if (!chosen.start.name().empty())
    {
        dimensionedScalar::name() = chosen.start.name();
    }

    readExactState();
    warnOfControls();

    // A file beyond `ulimit -f` then fails as on a full disk, with a message,
    // instead of killing the run
    std::signal(SIGXFSZ, SIG_IGN);
}


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

void Foam::restartableTime::warnOfControls() const
{
    const scalar end = endTime().value();

    if (value() > end - 0.5*deltaTValue())
    {
        WarningInFunction
            << "Nothing to do: the run starts at " << timeName()
            << " s, its endTime is " << end << " s, its deltaT "
            << deltaTValue() << " s (controlDict)" << nl << endl;
    }
    else if (!isAdjustTimeStep() && value() + 0.99*deltaTValue() > end)
    {
        WarningInFunction
            << "The first step of " << deltaTValue() << " s leads beyond the"
            << " endTime of " << end << " s (controlDict)" << nl << endl;
    }

    // The shortest that brings every double back
    if
    (
        writeFormat() == IOstream::ASCII
     && IOstream::defaultPrecision() < 17
    )
    {
        Info<< "writeFormat ascii with writePrecision "
            << IOstream::defaultPrecision() << ": a restart goes on from"
            << " rounded numbers." << nl
            << "    Bit for bit: writeFormat binary, or writePrecision 17"
            << nl << endl;
    }
}


void Foam::restartableTime::warnOfUnwritten() const
{
    if (lastComplete_ != timeName())
    {
        WarningInFunction
            << "The run ends at " << timeName() << " s; what it computed after "
            << lastComplete_ << " s is not written:" << nl
            << "    no write time (writeControl and writeInterval, controlDict)"
            << " came since" << nl << endl;
    }
}


void Foam::restartableTime::checkFunctionObjects() const
{
    const dictionary* functions = controlDict().findDict("functions");

    if (!functions || !functionObjects().status())
    {
        return;
    }

    for (const entry& function : *functions)
    {
        if (!function.isDict())
        {
            continue;
        }

        const dictionary& dict = function.dict();
        const word errors
        (
            dict.getOrDefault<word>
            (
                "errors",
                functions->getOrDefault<word>("errors", "default")
            )
        );

        if
        (
            functionObjects().findObjectID(function.keyword()) >= 0
         || !dict.getOrDefault("enabled", true)
         || errors == "warn"
         || errors == "ignore"
        )
        {
            continue;
        }

        const word type(dict.get<word>("type"));

        const auto* known = functionObject::dictionaryConstructorTablePtr_;

        if (known && !known->found(type))
        {
            FatalIOErrorInLookup(dict, "function object", type, *known)
                << nl << "If it is another one, its library was not found: see"
                << " libs, and the warnings above" << exit(FatalIOError);
        }

        FatalIOErrorInFunction(dict)
            << "The function object " << function.keyword()
            << " could not be made; the reason is in the warning above." << nl
            << "    To go on without it: enabled no; or errors warn;"
            << exit(FatalIOError);
    }
}


void Foam::restartableTime::readExactState()
{
    const IOdictionary dict
    (
        IOobject
        (
            "restartableTime",
            timeName(),
            "uniform",
            *this,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );

    if (dict.empty())
    {
        return;
    }

    const exactTimeState state(exactTimeState::read(dict));

    if (state.name != timeName())
    {
        Info<< "Time directory " << timeName() << " was " << state.name
            << " when it was written: its uniform/restartableTime is not used"
            << nl << endl;
        return;
    }

    value() = state.value;
    startTime_ = state.value;
    scheduleStart_ = state.value;
    deltaT0_ = state.deltaT0;

    // Time reads it from the directory that the default six digits name: where
    // there are 1 and 1.0000001, not from the second
    const IOdictionary written
    (
        IOobject
        (
            "time",
            timeName(),
            "uniform",
            *this,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    if (written.readIfPresent("index", startTimeIndex_))
    {
        timeIndex_ = startTimeIndex_;
    }

    // As in Time: without adjustTimeStep the dictionary's deltaT counts
    if (isAdjustTimeStep())
    {
        deltaT_ = state.deltaT;
        deltaTSave_ = state.deltaT;
    }

    if
    (
        state.writeControl == writeControlNames[writeControl_]
     && state.writeInterval == writeInterval_
    )
    {
        scheduleStart_ = state.scheduleStart;
        writeTimeIndex_ = state.writeTimeIndex;
    }
}


bool Foam::restartableTime::writeExactState() const
{
    exactTimeState state;
    state.name = timeName();
    state.value = value();
    state.deltaT = deltaT_;
    state.deltaT0 = deltaT0_;
    state.scheduleStart = scheduleStart_;
    state.writeTimeIndex = writeTimeIndex_;
    state.writeControl = writeControlNames[writeControl_];
    state.writeInterval = writeInterval_;

    const fileName directory(timePath());
    if
    (
        !wholeFiles::writtenSince
        (
            directory,
            incompleteMarker::path(directory),
            state.files
        )
    )
    {
        return false;
    }

    IOdictionary dict
    (
        IOobject
        (
            "restartableTime",
            timeName(),
            "uniform",
            *this,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    state.write(dict);

    return dict.regIOobject::write();
}


void Foam::restartableTime::aimAtWriteTime()
{
    if (writeControl_ != wcAdjustableRunTime)
    {
        return;
    }

    const scalar left = max
    (
        scalar(0),
        (writeTimeIndex_ + 1)*writeInterval_ - (value() - scheduleStart_)
    );
    const scalar steps = left/deltaT_;

    if (steps < labelMax)
    {
        // As Time does: so many equal steps, at least one, and none shorter than
        // a fifth of what is asked for
        deltaT_ = max(left/max(scalar(1), std::round(steps)), 0.2*deltaT_);
    }
}


void Foam::restartableTime::purge() const
{
    if (timesWritten_.empty() || timesWritten_.top() != timeName())
    {
        timesWritten_.push(timeName());
    }

    while (timesKept_ && timesWritten_.size() > timesKept_)
    {
        const fileName old(path()/timesWritten_.pop());

        if (!incompleteMarker::removeTime(old))
        {
            WarningInFunction
                << "Could not remove " << old << " (purgeWrite)" << endl;
        }
    }
}


Foam::fileName Foam::restartableTime::firstBroken() const
{
    return wholeFiles::firstBroken
    (
        timePath(),
        incompleteMarker::path(timePath())
    );
}


void Foam::restartableTime::refuse(const string& reason) const
{
    FatalErrorInFunction
        << "Time " << timeName() << " could not be written: "
        << reason.c_str() << nl
        << "Is the disk full, or a quota or file-size limit reached?" << nl;

    if (lastComplete_.empty())
    {
        FatalError
            << "No time was written before.";
    }
    else
    {
        FatalError
            << "The last complete time is " << lastComplete_
            << ", unharmed: a restart goes on from there.";
    }
    FatalError << exit(FatalError);
}


void Foam::restartableTime::refuseIfAny(const string& reason) const
{
    for (const string& first : ofAllRanks(reason))
    {
        if (!first.empty())
        {
            refuse(first);
        }
    }
}


bool Foam::restartableTime::writeObjects(const bool valid) const
{
    // OpenFOAM notices streams that fail while they are written to (not those
    // that fail when they are closed). It would say less
    const bool throwing = FatalIOError.throwExceptions();
    try
    {
        // Of all ranks first: with masterUncollated one writes for all
        const bool written =
            returnReduce(Time::write(valid), andOp<bool>())
         && writeExactState();
        FatalIOError.throwExceptions(throwing);
        return written;
    }
    catch (const IOerror& err)
    {
        FatalIOError.throwExceptions(throwing);

        // Not with the other ranks, which may be elsewhere; they are stopped
        const fileName broken(firstBroken());
        refuse
        (
            broken.empty()
          ? string(err.message())
          : string(broken + " is not whole")
        );
    }
    return false;
}


// * * * * * * * * * * * * * * * * Protected * * * * * * * * * * * * * * * * //

void Foam::restartableTime::readDict()
{
    checkControls(controlDict());
    Time::readDict();

    timesKept_ = max(0, controlDict().getOrDefault<label>("purgeWrite", 0));
    purgeWrite_ = 0;
    setLogDigits();
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

bool Foam::restartableTime::write(const bool valid) const
{
    if (!writeTime())
    {
        return false;
    }

    const fileName directory(timePath());
    const fileName marker(incompleteMarker::path(directory));

    // The time that is written anew is no longer the last complete one
    if (lastComplete_ == timeName())
    {
        lastComplete_.clear();
    }

    refuseIfAny
    (
        incompleteMarker::set(directory)
      ? string()
      : string("can't create " + marker)
    );

    // Likewise
    const bool written = returnReduce(writeObjects(valid), andOp<bool>());
    const fileName broken(firstBroken());

    refuseIfAny
    (
        !broken.empty() ? string(broken + " is not whole")
      : !written ? string("OpenFOAM reports a failure in " + directory)
      : string()
    );

    refuseIfAny
    (
        incompleteMarker::remove(directory)
      ? string()
      : string("can't remove " + marker)
    );

    lastComplete_ = timeName();

    // Only now, when no rank has the marker
    purge();

    return true;
}


bool Foam::restartableTime::run() const
{
    const bool goesOn = Time::run();

    if (goesOn && timeIndex() == startTimeIndex_)
    {
        checkFunctionObjects();
    }
    else if (!goesOn && timeIndex() != startTimeIndex_)
    {
        warnOfUnwritten();
    }
    return goesOn;
}


void Foam::restartableTime::setDeltaT(const scalar deltaT, const bool adjust)
{
    Time::setDeltaT(deltaT, false);

    if (adjust)
    {
        aimAtWriteTime();

        // They count from the start of this run, here and when they write
        const_cast<functionObjectList&>(functionObjects()).adjustTimeStep();
    }
}


Foam::Time& Foam::restartableTime::operator++()
{
    const temporarily<scalar> anchor(startTime_, scheduleStart_);
    return Time::operator++();
}
