/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompleteMarker.H"
#include "ownFolders.H"

#include <filesystem>
#include <fstream>

namespace Foam
{
namespace incompleteMarker
{

namespace
{

//- std::filesystem knows std::string, not what OpenFOAM derives from it
std::filesystem::path asPath(const std::string& name)
{
    return name;
}


//- A folder besides the time directory that no program takes for a time
std::filesystem::path besides(const fileName& timeDirectory, const char* ending)
{
    std::filesystem::path name(asPath(timeDirectory));
    name.replace_filename("." + name.filename().string() + ending);
    return name;
}


//- Remove everything in the time directory but the marker
bool removeAllButMarker(const fileName& timeDirectory)
{
    std::error_code error;
    const std::filesystem::path marker(asPath(path(timeDirectory)));

    for
    (
        const auto& folder
      : {asPath(timeDirectory), marker.parent_path()}
    )
    {
        std::filesystem::directory_iterator entries(folder, error);

        for (const auto& entry : entries)
        {
            if (entry.path() != marker && entry.path() != marker.parent_path())
            {
                std::filesystem::remove_all(entry.path(), error);
                if (error)
                {
                    return false;
                }
            }
        }
    }

    return !error;
}

} // End anonymous namespace


fileName path(const fileName& timeDirectory)
{
    return timeDirectory/"uniform"/"incomplete";
}


bool found(const fileName& timeDirectory)
{
    std::error_code error;
    return std::filesystem::exists
    (
        asPath(path(timeDirectory)),
        error
    );
}


bool set(const fileName& timeDirectory)
{
    const bool interrupted = found(timeDirectory);

    std::error_code error;

    if (!std::filesystem::exists(asPath(timeDirectory), error))
    {
        // Made aside and moved into place with the marker in it, so that a
        // kill at no moment leaves a time directory without
        const std::filesystem::path aside(besides(timeDirectory, ".new"));

        std::filesystem::create_directories(aside/"uniform", error);

        if (!std::ofstream(aside/"uniform"/"incomplete").good())
        {
            return false;
        }
        std::filesystem::rename(aside, asPath(timeDirectory), error);
        return !error;
    }

    if (!ownFolders::make(timeDirectory))
    {
        return false;
    }
    std::filesystem::create_directories
    (
        asPath(timeDirectory)/"uniform",
        error
    );
    if (error || (interrupted && !removeAllButMarker(timeDirectory)))
    {
        return false;
    }

    // Empty, so that it also fits on a full disk
    return std::ofstream(path(timeDirectory)).good();
}


bool remove(const fileName& timeDirectory)
{
    std::error_code error;
    std::filesystem::remove
    (
        asPath(path(timeDirectory)),
        error
    );
    return !error;
}


bool removeTime(const fileName& timeDirectory)
{
    // What a link leads to stays
    if (!ownFolders::make(timeDirectory))
    {
        return false;
    }
    if (!std::ofstream(path(timeDirectory)).good())
    {
        // A time without uniform/: restart data it was not
        std::error_code error;
        std::filesystem::create_directories
        (
            asPath(timeDirectory)/"uniform",
            error
        );
        if (!std::ofstream(path(timeDirectory)).good())
        {
            return false;
        }
    }

    if (!removeAllButMarker(timeDirectory))
    {
        return false;
    }

    // Out of sight with the marker in it, then gone
    std::error_code error;
    const std::filesystem::path aside(besides(timeDirectory, ".old"));
    std::filesystem::remove_all(aside, error);
    std::filesystem::rename(asPath(timeDirectory), aside, error);

    return !error && std::filesystem::remove_all(aside, error) > 0 && !error;
}

} // End namespace incompleteMarker
} // End namespace Foam
