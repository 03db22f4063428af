/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "completeTimes.H"

#include "DynamicList.H"
#include "ListOps.H"
#include "Pstream.H"
#include "incompleteMarker.H"
#include "ofAllRanks.H"

#include <algorithm>
#include <filesystem>
#include <map>

// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

Foam::label Foam::completeTimes::lastComplete(label timei) const
{
    while (timei >= 0 && incompleteOn_[timei] >= 0)
    {
        --timei;
    }
    return timei;
}


Foam::label Foam::completeTimes::find(const scalar value) const
{
    // Both are read from decimal digits: they differ by round-off or truly
    forAll(times_, timei)
    {
        const scalar other = times_[timei].value();

        if (mag(other - value) <= 1e-12*max(mag(other), mag(value)))
        {
            return timei;
        }
    }
    return -1;
}


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

Foam::completeTimes::completeTimes(const fileName& casePath)
{
    DynamicList<word> myNames;
    DynamicList<bool> myMarked;
    std::error_code error;

    for
    (
        const auto& entry
      : std::filesystem::directory_iterator
        (
            std::filesystem::path(std::string(casePath)),
            error
        )
    )
    {
        const std::string name = entry.path().filename().string();
        scalar value;

        if (entry.is_directory(error) && readScalar(name, value))
        {
            myNames.append(word(name, false));
            myMarked.append(incompleteMarker::found(casePath/name));
        }
    }
    const List<wordList> names(ofAllRanks<wordList>(myNames));
    const List<boolList> marked(ofAllRanks<boolList>(myMarked));

    // By name: on how many ranks, and on which one marked
    std::map<std::string, label> ranksWith;
    std::map<std::string, label> markedOn;

    forAll(names, proci)
    {
        forAll(names[proci], i)
        {
            const word& name = names[proci][i];

            ++ranksWith[name];
            if (marked[proci][i])
            {
                markedOn.emplace(name, proci);
            }
        }
    }

    DynamicList<instant> times;
    for (const auto& [name, count] : ranksWith)
    {
        scalar value;
        readScalar(name, value);
        times.append(instant(value, word(name, false)));
    }
    times_ = times;
    std::stable_sort
    (
        times_.begin(),
        times_.end(),
        [](const instant& a, const instant& b){return a.value() < b.value();}
    );

    incompleteOn_.setSize(times_.size(), -1);
    forAll(times_, timei)
    {
        const word& name = times_[timei].name();
        const auto mark = markedOn.find(name);

        if (mark != markedOn.end())
        {
            incompleteOn_[timei] = mark->second;
        }
        else if (ranksWith[name] < Pstream::nProcs())
        {
            forAll(names, proci)
            {
                if (!names[proci].found(name))
                {
                    incompleteOn_[timei] = proci;
                    break;
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

std::string Foam::completeTimes::names
(
    const label first,
    const label last
) const
{
    std::string names;
    for (label timei = first; timei < last; ++timei)
    {
        names += (timei > first ? " " : "") + times_[timei].name();
    }
    return names;
}


Foam::instant Foam::completeTimes::start(const dictionary& controlDict) const
{
    const word startFrom
    (
        controlDict.getOrDefault<word>("startFrom", "latestTime")
    );

    label wanted = -1;

    if (startFrom == "startTime")
    {
        const scalar value = controlDict.get<scalar>("startTime");
        wanted = find(value);

        if (wanted < 0 && (times_.size() || value != 0))
        {
            FatalIOErrorInFunction(controlDict)
                << "startTime " << value << " is not there. The case has "
                << (times_.empty() ? "no times" : "the times ")
                << names().c_str() << nl
                << exit(FatalIOError);
        }
    }
    else if (startFrom == "firstTime")
    {
        wanted = min(0, times_.size() - 1);
    }
    else if (startFrom == "latestTime")
    {
        wanted = times_.size() - 1;
    }
    else
    {
        FatalIOErrorInFunction(controlDict)
            << "startFrom is startTime, firstTime or latestTime, not "
            << startFrom << exit(FatalIOError);
    }

    if (wanted < 0)
    {
        return instant(0, word());
    }

    const label taken = lastComplete(wanted);

    if (taken < wanted)
    {
        const std::string skipped(names(taken + 1, wanted + 1));

        if (taken < 0)
        {
            FatalIOErrorInFunction(controlDict)
                << "No complete time to start from. Left incomplete by a run "
                << "that was interrupted while it wrote:" << nl
                << skipped.c_str() << nl
                << "(uniform/incomplete is there, or they are not on every "
                << "processor.) Remove them to start anew" << nl
                << exit(FatalIOError);
        }

        Info<< "Left incomplete by an interrupted run, skipped: time "
            << skipped.c_str() << nl
            << "Start from the last complete time, " << times_[taken].name()
            << nl << endl;
    }

    return times_[taken];
}
