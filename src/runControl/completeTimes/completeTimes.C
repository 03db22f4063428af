/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "completeTimes.H"

#include "DynamicList.H"
#include "IFstream.H"
#include "ListOps.H"
#include "Pstream.H"
#include "exactTimeState.H"
#include "incompleteMarker.H"
#include "ofAllRanks.H"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The file of the last writing
const fileName lastWritten("uniform/restartableTime");


//- Names of what was written with the time, as this rank's last file says it
fileNameList filesOf(const fileName& timeDirectory)
{
    if (!completeTimes::holds(timeDirectory, lastWritten))
    {
        return fileNameList();
    }
    // OpenFOAM opens x.gz where x is asked for
    IFstream is(timeDirectory/lastWritten);
    return exactTimeState::filesOf(dictionary(is));
}


//- The folder of the cloud that a file belongs to; empty for other files
fileName cloudOf(const fileName& file)
{
    const auto end = file.rfind('/');
    return
        file.compare(0, 11, "lagrangian/") == 0
      ? fileName(file.substr(0, end))
      : fileName();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

bool Foam::completeTimes::counts(const label timei) const
{
    return
        begunWith_.empty() || times_[timei].written || timei == first_;
}


bool Foam::completeTimes::canStart(const label timei) const
{
    return counts(timei) && times_[timei].incompleteOn < 0;
}


Foam::label Foam::completeTimes::lastOf
(
    label timei,
    const std::function<bool(label)>& is
) const
{
    while (timei >= 0 && !is(timei))
    {
        --timei;
    }
    return timei;
}


Foam::label Foam::completeTimes::find(const scalar value) const
{
    // Both are read from decimal digits: they differ by round-off or truly
    for (std::size_t timei = 0; timei < times_.size(); ++timei)
    {
        const scalar other = times_[timei].time.value();

        if (mag(other - value) <= 1e-12*max(mag(other), mag(value)))
        {
            return timei;
        }
    }
    return -1;
}


std::string Foam::completeTimes::names
(
    const std::function<bool(label)>& are
) const
{
    std::string names;
    for (std::size_t timei = 0; timei < times_.size(); ++timei)
    {
        if (are(timei))
        {
            names += (names.empty() ? "" : " ") + times_[timei].time.name();
        }
    }
    return names;
}


Foam::string Foam::completeTimes::missing(const word& time) const
{
    const fileName directory(casePath_/time);
    const fileNameList own(filesOf(directory));

    // A rank without platelets has no file of the cloud, whatever the others
    // or the undecomposed case had; one with platelets has all but `positions`,
    // which are for ParaView and decomposePar leaves out
    std::set<std::string> ofClouds;
    std::set<std::string> cloudsHere;
    std::set<std::string> clouds;

    for (const fileNameList& files : ofAllRanks(own))
    {
        for (const fileName& file : files)
        {
            if (!cloudOf(file).empty() && file.name() != "positions")
            {
                ofClouds.insert(file);
                if (holds(directory, file))
                {
                    cloudsHere.insert(cloudOf(file));
                }
            }
        }
    }
    for
    (
        const wordList& some
      : ofAllRanks(wordList(cloudsHere.begin(), cloudsHere.end()))
    )
    {
        clouds.insert(some.begin(), some.end());
    }

    string lacking;
    const auto look = [&](const fileName& file)
    {
        if (lacking.empty() && !holds(directory, file))
        {
            lacking = directory/file;
        }
    };

    for (const fileName& file : own)
    {
        // decomposePar alone reads clayWeights
        if (cloudOf(file).empty() && file != "clayWeights")
        {
            look(file);
        }
    }
    for (const fileName file : ofClouds)
    {
        if (cloudsHere.count(cloudOf(file)) || !clouds.count(cloudOf(file)))
        {
            look(file);
        }
    }

    for (const string& first : ofAllRanks(lacking))
    {
        if (!first.empty())
        {
            return first;
        }
    }
    return string();
}


void Foam::completeTimes::refuse
(
    const dictionary& controlDict,
    const label timei,
    const string& file
) const
{
    const word& name = times_[timei].time.name();
    const label earlier =
        lastOf(timei - 1, [&](const label i){return canStart(i);});

    FatalIOErrorInFunction(controlDict)
        << "Time " << name << " is not whole: it was written with "
        << file.c_str() << ", which is missing." << nl;

    if (earlier >= 0)
    {
        FatalIOError
            << "    Start from an earlier one (startFrom startTime; startTime "
            << times_[earlier].time.name() << ";) or, if it" << nl
            << "    is whole in the processor directories, reconstruct it";
    }
    else
    {
        FatalIOError
            << "    If it is whole in the processor directories, reconstruct it";
    }
    FatalIOError
        << ": reconstructPar -time " << name << nl << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

Foam::completeTimes::completeTimes
(
    const fileName& casePath,
    const fileName& begunWith,
    const wordHashSet& without
)
:
    casePath_(casePath),
    begunWith_(begunWith),
    first_(-1)
{
    DynamicList<word> myNames;
    DynamicList<bool> myMarked;
    DynamicList<bool> myWritten;
    DynamicList<bool> myBegun;
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

        if
        (
            entry.is_directory(error)
         && readScalar(name, value)
         && !without.found(word(name, false))
        )
        {
            const fileName directory(casePath/name);

            myNames.append(word(name, false));
            myMarked.append(incompleteMarker::found(directory));
            myWritten.append(holds(directory, lastWritten));
            myBegun.append(!begunWith.empty() && holds(directory, begunWith));
        }
    }
    const List<wordList> names(ofAllRanks<wordList>(myNames));
    const List<boolList> marked(ofAllRanks<boolList>(myMarked));
    const List<boolList> written(ofAllRanks<boolList>(myWritten));
    const List<boolList> begun(ofAllRanks<boolList>(myBegun));

    // By name: on how many ranks, and on which one marked
    struct found
    {
        label ranks = 0;
        label markedOn = -1;
        label written = 0;
        label begun = 0;
    };
    std::map<std::string, found> all;

    forAll(names, proci)
    {
        forAll(names[proci], i)
        {
            found& time = all[names[proci][i]];

            ++time.ranks;
            time.written += written[proci][i];
            time.begun += begun[proci][i];
            if (marked[proci][i] && time.markedOn < 0)
            {
                time.markedOn = proci;
            }
        }
    }

    const label ranks = Pstream::nProcs();

    for (const auto& [name, time] : all)
    {
        scalar value;
        readScalar(name, value);

        label incompleteOn = time.markedOn;
        for (label proci = 0; incompleteOn < 0 && proci < ranks; ++proci)
        {
            if (time.ranks < ranks && !names[proci].found(word(name, false)))
            {
                incompleteOn = proci;
            }
        }
        times_.push_back
        ({
            instant(value, word(name, false)),
            incompleteOn,
            time.written == ranks,
            time.begun == ranks
        });
    }
    std::stable_sort
    (
        times_.begin(),
        times_.end(),
        [](const folder& a, const folder& b)
        {
            return a.time.value() < b.time.value();
        }
    );

    const auto first = std::find_if
    (
        times_.begin(), times_.end(), [](const folder& a){return a.begun;}
    );
    if (first != times_.end())
    {
        first_ = first - times_.begin();
    }
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

bool Foam::completeTimes::holds
(
    const fileName& directory,
    const fileName& file
)
{
    std::error_code error;
    const std::filesystem::path path(std::string(directory/file));

    if (std::filesystem::exists(path, error))
    {
        return true;
    }
    std::filesystem::path other(path);
    if (path.extension() == ".gz")
    {
        other.replace_extension();
    }
    else
    {
        other += ".gz";
    }
    return std::filesystem::exists(other, error);
}


std::string Foam::completeTimes::names() const
{
    return names([](label){return true;});
}


Foam::instant Foam::completeTimes::lastWrittenTime() const
{
    const label last =
        lastOf
        (
            label(times_.size()) - 1,
            [&](const label i){return times_[i].written;}
        );
    return last < 0 ? instant(0, word()) : times_[last].time;
}


Foam::instant Foam::completeTimes::start(const dictionary& controlDict) const
{
    const word startFrom
    (
        controlDict.getOrDefault<word>("startFrom", "latestTime")
    );

    const label nTimes = times_.size();
    const auto complete = [&](const label i)
    {
        return times_[i].incompleteOn < 0;
    };
    const auto mayStart = [&](const label i){return canStart(i);};

    // Where none is the run's the program says what it misses
    const bool any = lastOf(nTimes - 1, mayStart) >= 0;

    label wanted = -1;
    label taken = -1;

    if (startFrom == "startTime")
    {
        const scalar value = controlDict.get<scalar>("startTime");
        wanted = find(value);

        if (wanted < 0 && (nTimes || value != 0))
        {
            FatalIOErrorInFunction(controlDict)
                << "startTime " << value << " is not there. The case has "
                << (nTimes ? "the times " : "no times")
                << names().c_str() << nl
                << exit(FatalIOError);
        }
        if
        (
            wanted >= 0 && any && complete(wanted)
         && !counts(wanted) && !times_[wanted].begun
        )
        {
            FatalIOErrorInFunction(controlDict)
                << "startTime " << times_[wanted].time.name() << " is not a"
                << " time of the run: it has neither " << lastWritten
                << " nor " << begunWith_ << nl
                << "    A run can start from " << names(mayStart).c_str() << nl
                << exit(FatalIOError);
        }
    }
    else if (startFrom == "firstTime")
    {
        wanted = min(0, nTimes - 1);
        while (any && complete(wanted) && !counts(wanted))
        {
            ++wanted;
        }
    }
    else if (startFrom == "latestTime")
    {
        wanted = nTimes - 1;
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

    if (startFrom == "startTime" && complete(wanted))
    {
        // Whatever it is, the user has named it
        taken = wanted;
    }
    else if (any)
    {
        taken = lastOf(wanted, mayStart);
    }
    else
    {
        taken = lastOf(wanted, complete);
    }

    const std::string interrupted
    (
        names
        ([&](const label i){return i > taken && i <= wanted && !complete(i);})
    );
    const std::string foreign
    (
        names
        ([&](const label i){return i > taken && i <= wanted && complete(i);})
    );

    if (taken < 0)
    {
        FatalIOErrorInFunction(controlDict)
            << "No complete time to start from. Left incomplete by a run "
            << "that was interrupted while it wrote:" << nl
            << interrupted.c_str() << nl
            << "(uniform/incomplete is there, or they are not on every "
            << "processor.) Remove them to start anew" << nl
            << exit(FatalIOError);
    }

    const word& name = times_[taken].time.name();

    if (!foreign.empty())
    {
        Info<< "Not of the run (without " << lastWritten << "), skipped: time "
            << foreign.c_str() << nl;
    }
    if (!interrupted.empty())
    {
        Info<< "Left incomplete by an interrupted run, skipped: time "
            << interrupted.c_str() << nl
            << "Start from the last complete time, " << name << nl;
    }
    if (taken < wanted)
    {
        Info<< endl;
    }

    const std::string later
    (
        names([&](const label i){return i > wanted && times_[i].written;})
    );
    if (!later.empty())
    {
        Info<< "Later times of an earlier run stay: " << later.c_str() << nl
            << "A start from latestTime would go on from them, not from this run."
            << " To remove them:" << nl << "    rm -r " << later.c_str() << nl
            << endl;
    }

    const string lacking(missing(name));
    if (!lacking.empty())
    {
        refuse(controlDict, taken, lacking);
    }

    return times_[taken].time;
}
