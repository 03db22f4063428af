/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diskRoom.H"

#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

//- The same for a file that is open; returns 0 or an errno
int reserveBeyondEnd(const int file, const off_t bytes)
{
    struct stat status;
    struct rlimit limit;
    if (::fstat(file, &status) || ::getrlimit(RLIMIT_FSIZE, &limit))
    {
        return errno;
    }
    if
    (
        limit.rlim_cur != RLIM_INFINITY
     && limit.rlim_cur < rlim_t(status.st_size + bytes)
    )
    {
        return EFBIG;
    }

    int problem = 0;
    if (::fallocate(file, FALLOC_FL_KEEP_SIZE, status.st_size, bytes) != 0)
    {
        problem = errno;
    }
    if (problem == EOPNOTSUPP)
    {
        problem = ::posix_fallocate(file, status.st_size, bytes);
        if (problem && ::ftruncate(file, status.st_size) != 0)
        {
            problem = errno;
        }
    }
    return problem;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global functions  * * * * * * * * * * * * * //

void Foam::diskRoom::reserve(const std::string& path, const std::size_t bytes)
{
    const int file = ::open(path.c_str(), O_WRONLY);
    int problem = file < 0 ? errno : reserveBeyondEnd(file, off_t(bytes));
    if (file >= 0 && ::close(file) != 0 && !problem)
    {
        problem = errno;
    }

    if (problem)
    {
        throw std::runtime_error
        (
            "to reserve " + std::to_string(bytes) + " bytes: "
          + std::strerror(problem)
        );
    }
}
