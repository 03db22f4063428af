/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wholeFiles.H"
#include "IFstream.H"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace Foam
{
namespace wholeFiles
{

namespace
{

//- Longer than OpenFOAM's divider and the empty lines around it
constexpr std::size_t tailLength = 160;


//- std::filesystem knows std::string, not what OpenFOAM derives from it
std::filesystem::path asPath(const std::string& name)
{
    return name;
}


//- OpenFOAM's files begin with its banner or with the header itself; some
//  end within these
bool beginsAsOpenFOAM(const std::string& head)
{
    for (const std::string start : {"/*--------", "FoamFile"})
    {
        const std::size_t n = std::min(head.size(), start.size());

        if (head.compare(0, n, start, 0, n) == 0)
        {
            return true;
        }
    }
    return false;
}


bool endsAsOpenFOAM(const std::string& tail)
{
    // The other dividers have fewer stars, with spaces between
    const std::string end(std::string(40, '*') + " //");
    const auto length = tail.find_last_not_of(" \n\r\t") + 1;

    return
        length >= end.size()
     && tail.compare(length - end.size(), end.size(), end) == 0;
}


bool compressedIsWhole(const fileName& file)
{
    std::ifstream raw(file, std::ios::binary | std::ios::ate);
    const std::streamoff size = raw.tellg();

    // Header and trailer of gzip alone take 18 bytes
    if (!raw || size < 18)
    {
        return false;
    }

    unsigned char trailer[4];
    raw.seekg(size - 4);
    raw.read(reinterpret_cast<char*>(trailer), 4);
    const std::uint32_t stated =
        trailer[0] | trailer[1] << 8 | trailer[2] << 16
      | std::uint32_t(trailer[3]) << 24;

    // OpenFOAM opens x.gz where x is asked for
    IFstream zipped(fileName(file).lessExt());
    std::istream& is = zipped.stdStream();

    std::string head;
    std::string tail;
    std::vector<char> block(1 << 16);
    std::uint32_t length = 0;

    while (is)
    {
        is.read(block.data(), block.size());
        const std::size_t got = is.gcount();

        if (head.empty())
        {
            head.assign(block.data(), std::min<std::size_t>(got, 16));
        }
        tail.append(block.data(), got);
        tail.erase(0, tail.size() - std::min(tail.size(), tailLength));
        length += got;
    }

    return
        length == stated
     && (!beginsAsOpenFOAM(head) || endsAsOpenFOAM(tail));
}

} // End anonymous namespace


bool isWhole(const fileName& file)
{
    if (file.hasExt("gz"))
    {
        return compressedIsWhole(file);
    }

    std::ifstream is(file, std::ios::binary | std::ios::ate);
    const std::streamoff size = is.tellg();

    if (!is)
    {
        return false;
    }

    std::string head(std::min<std::streamoff>(size, 16), '\0');
    is.seekg(0);
    is.read(&head[0], head.size());

    std::string tail(std::min<std::streamoff>(size, tailLength), '\0');
    is.seekg(size - std::streamoff(tail.size()));
    is.read(&tail[0], tail.size());

    return is && (!beginsAsOpenFOAM(head) || endsAsOpenFOAM(tail));
}


bool writtenSince
(
    const fileName& directory,
    const fileName& since,
    fileNameList& files
)
{
    namespace fs = std::filesystem;

    std::error_code error;
    const auto begun = fs::last_write_time(asPath(since), error);
    if (error)
    {
        return false;
    }

    std::vector<std::string> found;
    fs::recursive_directory_iterator entries(asPath(directory), error);

    for (const auto& entry : entries)
    {
        if
        (
            entry.is_regular_file(error)
         && entry.path().string() != since
         && entry.last_write_time(error) >= begun
        )
        {
            found.push_back
            (
                entry.path().lexically_relative(asPath(directory)).string()
            );
        }
    }

    std::sort(found.begin(), found.end());

    files.resize(found.size());
    std::copy(found.begin(), found.end(), files.begin());

    return !error;
}


fileName firstBroken(const fileName& directory, const fileName& since)
{
    std::error_code error;
    fileNameList files;

    if (!std::filesystem::exists(asPath(since), error))
    {
        return since;
    }
    if (!writtenSince(directory, since, files))
    {
        return directory;
    }

    for (const fileName& file : files)
    {
        if (!isWhole(directory/file))
        {
            return directory/file;
        }
    }

    return fileName();
}

} // End namespace wholeFiles
} // End namespace Foam
