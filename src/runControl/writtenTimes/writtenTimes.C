/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writtenTimes.H"

#include "DynamicList.H"
#include "completeTimes.H"
#include "incompleteMarker.H"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

//- Names of the directories in this one, by number where they are numbers
std::vector<std::string> directoriesIn(const std::string& path)
{
    std::error_code error;
    std::vector<std::string> names;

    for
    (
        const auto& entry
      : std::filesystem::directory_iterator(std::filesystem::path(path), error)
    )
    {
        if (entry.is_directory(error))
        {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort
    (
        names.begin(),
        names.end(),
        [](const std::string& a, const std::string& b)
        {
            double x, y;
            return
                Foam::readScalar(a, x) && Foam::readScalar(b, y) && x != y
              ? x < y
              : a < b;
        }
    );
    return names;
}


bool isTime(const std::string& name)
{
    Foam::scalar value;
    return Foam::readScalar(name, value);
}


bool isProcessor(const std::string& name)
{
    return
        name.size() > 9
     && name.compare(0, 9, "processor") == 0
     && std::all_of(name.begin() + 9, name.end(), ::isdigit);
}


bool isWritten(const Foam::fileName& directory)
{
    return
        Foam::completeTimes::holds(directory, "uniform/restartableTime")
     || Foam::incompleteMarker::found(directory);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

std::string Foam::writtenTimes::names() const
{
    std::string all;
    for (const fileName& folder : folders_)
    {
        all += (all.empty() ? "" : " ") + folder;
    }
    return all;
}


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

Foam::writtenTimes::writtenTimes(const fileName& casePath)
:
    casePath_(casePath),
    anyBefore_(false)
{
    scalar firstWritten = GREAT;
    scalar firstOther = GREAT;
    DynamicList<fileName> ofProcessors;
    DynamicList<fileName> ofCase;

    for (const std::string& name : directoriesIn(casePath))
    {
        if (isProcessor(name))
        {
            for (const std::string& time : directoriesIn(casePath/name))
            {
                if (isTime(time) && isWritten(casePath/name/time))
                {
                    ofProcessors.append(fileName(name)/time);
                }
            }
        }
        else if (isTime(name))
        {
            const bool written = isWritten(casePath/name);
            if (written)
            {
                ofCase.append(name);
            }
            scalar& first = written ? firstWritten : firstOther;
            first = min(first, scalar(std::strtod(name.c_str(), nullptr)));
        }
    }

    // Not one that a function object has made later
    anyBefore_ = firstOther < firstWritten;

    ofProcessors.append(ofCase);
    folders_ = ofProcessors;
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

void Foam::writtenTimes::refuse() const
{
    if (folders_.empty())
    {
        return;
    }

    FatalErrorInFunction
        << "The case has times that were written by a run, which would go on"
        << " from them, not from what is placed now:" << nl
        << "    " << names().c_str() << nl
        << "    To remove them: setClay -overwrite (which then places anew), or"
        << nl
        << "    cd " << casePath_.c_str() << " && rm -r " << names().c_str()
        << exit(FatalError);
}


void Foam::writtenTimes::checkRemovable() const
{
    if (folders_.size() && !anyBefore_)
    {
        FatalErrorInFunction
            << "No time of the case is from before the run that wrote "
            << names().c_str()
            << nl << "    Without these nothing would be left to start from."
            << " First copy the one with the boundary conditions to start from"
            << nl << "    (or 0.orig to 0), and remove its uniform/"
            << exit(FatalError);
    }
}


Foam::wordHashSet Foam::writtenTimes::ofCase() const
{
    wordHashSet names;
    for (const fileName& folder : folders_)
    {
        if (folder.find('/') == std::string::npos)
        {
            names.insert(word(folder, false));
        }
    }
    return names;
}


void Foam::writtenTimes::remove() const
{
    if (folders_.empty())
    {
        return;
    }

    for (const fileName& folder : folders_)
    {
        if (!incompleteMarker::removeTime(casePath_/folder))
        {
            FatalErrorInFunction
                << "Cannot remove " << casePath_/folder << exit(FatalError);
        }
    }
    Info<< "Removed the times of an earlier run: " << names().c_str() << nl
        << endl;
}
