/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompleteMarker.H"

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

    std::error_code error;
    return
        removeAllButMarker(timeDirectory)
     && std::filesystem::remove_all
        (
            asPath(timeDirectory),
            error
        ) > 0
     && !error;
}

} // End namespace incompleteMarker
} // End namespace Foam
