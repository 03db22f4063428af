/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ownFolders.H"

#include <algorithm>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;

bool isLinkToFolder(const fs::path& name)
{
    std::error_code error;
    return fs::is_symlink(name, error) && fs::is_directory(name, error);
}


bool unlinkFolder(const fs::path& link)
{
    std::error_code error;
    fs::path copy(link);
    copy.replace_filename("." + link.filename().string() + ".own");

    fs::remove_all(copy, error);

    // One that leads to where it lies would never end
    const fs::path target(fs::canonical(link, error));
    const fs::path folder(fs::canonical(link.parent_path(), error));
    const auto differs = std::mismatch
    (
        target.begin(), target.end(), folder.begin(), folder.end()
    );
    if (error || differs.first == target.end())
    {
        return false;
    }

    // Links within it become real with it
    fs::copy(target, copy, fs::copy_options::recursive, error);
    if (error)
    {
        fs::remove_all(copy, error);
        return false;
    }

    // The two change places at once, so that a kill leaves one or the other,
    // where the file system can
    if
    (
        ::renameat2
        (
            AT_FDCWD, copy.c_str(), AT_FDCWD, link.c_str(), RENAME_EXCHANGE
        ) == 0
    )
    {
        return fs::remove(copy, error);
    }
    return fs::remove(link, error) && (fs::rename(copy, link, error), !error);
}

bool makeOwn(const fs::path& top, const bool isTime)
{
    std::error_code error;

    if (isLinkToFolder(top) && !unlinkFolder(top))
    {
        return false;
    }
    if (!fs::is_directory(top, error))
    {
        return true;
    }

    // Not while they are looked through
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(top, error))
    {
        if (entry.is_directory(error))
        {
            // Nothing of the run goes into other folders of a time
            const fs::path name(entry.path().filename());
            if (!isTime || name == "uniform" || name == "lagrangian")
            {
                folders.push_back(entry.path());
            }
        }
        else if (entry.is_symlink(error) && !entry.exists(error))
        {
            // Where it leads is gone: no folder could take its place
            fs::remove(entry.path(), error);
        }
        error.clear();
    }
    for (const fs::path& folder : folders)
    {
        if (!makeOwn(folder, false))
        {
            return false;
        }
    }
    return true;
}

} // End anonymous namespace


bool Foam::ownFolders::make(const fileName& directory)
{
    return makeOwn(std::string(directory), true);
}
