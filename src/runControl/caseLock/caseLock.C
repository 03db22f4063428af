/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseLock.H"

#include "OSspecific.H"
#include "Pstream.H"
#include "argList.H"
#include "lockOwner.H"
#include "ofAllRanks.H"
#include "releaseAtExit.H"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

//- FatalError if mpirun started several copies that know nothing of each other
//  and would write the same files
void refuseCopies()
{
    using namespace Foam;

    // Open MPI; MPICH and its kin
    for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    {
        const string ranks(getEnv(variable));

        if (!Pstream::parRun() && ranks.size() && ranks != "1")
        {
            FatalErrorInFunction
                << "mpirun started " << ranks.c_str()
                << " copies of a serial run. Add the option -parallel" << nl
                << "    (serial runs of different cases under one mpirun: env -u "
                << variable << " before the program's name)"
                << exit(FatalError);
        }
    }
}


//- The case itself, also of the processor directories, by its full path: the
//  program may change its current folder
Foam::fileName caseOf(const Foam::argList& args)
{
    refuseCopies();
    return args.globalPath();
}


Foam::fileName fullPath(const Foam::fileName& folder)
{
    std::error_code error;
    const auto full = std::filesystem::canonical
    (
        std::filesystem::path(std::string(folder)),
        error
    );
    return error ? folder : Foam::fileName(full.string());
}


//- A file that is open, and no longer when this ends
class openFile
{
    const int file_;

public:

    explicit openFile(const std::string& path)
    :
        file_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666))
    {}

    ~openFile()
    {
        if (good())
        {
            close(file_);
        }
    }

    bool good() const
    {
        return file_ >= 0;
    }

    //- Wait until no other process has it. Where the file system has no such
    //  locks (some of clusters) there is nothing to wait for
    void hold() const
    {
        while (flock(file_, LOCK_EX) != 0 && errno == EINTR)
        {}
    }

    //- Still the one of this name
    bool isAt(const std::string& path) const
    {
        struct stat here, there;
        return
            fstat(file_, &here) == 0
         && stat(path.c_str(), &there) == 0
         && here.st_ino == there.st_ino
         && here.st_dev == there.st_dev;
    }

    std::string content() const
    {
        char text[4096];
        const ssize_t size = pread(file_, text, sizeof(text), 0);
        return std::string(text, size > 0 ? size : 0);
    }

    bool replace(const std::string& text) const
    {
        return
            ftruncate(file_, 0) == 0
         && pwrite(file_, text.data(), text.size(), 0) == ssize_t(text.size())
         && fsync(file_) == 0;
    }
};


void warnOfNone(const Foam::fileName& path)
{
    WarningInFunction
        << "No lock " << path << ": " << std::strerror(errno) << Foam::nl
        << "    See to it that no other program writes this case"
        << Foam::nl << Foam::endl;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

Foam::string Foam::caseLock::take(const std::string& program)
{
    using state = lockOwner::state;

    for (;;)
    {
        const openFile file(path_);
        if (!file.good())
        {
            warnOfNone(path_);
            path_.clear();
            return string();
        }
        file.hold();

        // Its holder may have removed it meanwhile
        if (!file.isAt(path_))
        {
            continue;
        }

        const std::string content(file.content());
        const lockOwner other(lockOwner::read(content));

        // Without content: of one that was killed when it had made the file
        if (!content.empty() && !other.known())
        {
            return
                path_ + " is there, and not of bentoFoam: rename it, since a"
                " file of this name tells which program writes the case";
        }

        const state now = content.empty() ? state::dead : other.now();

        if (now == state::alive)
        {
            return
                string(other.name()) + " writes this case: wait for its end,"
                " or stop it (it removes " + path_ + ")";
        }

        if (releaseAtExit::watching())
        {
            return "This process has the lock of another case";
        }

        const std::string mine(lockOwner(program).text());

        if (!file.replace(mine))
        {
            warnOfNone(path_);
            unlink(path_.c_str());
            path_.clear();
            return string();
        }
        if (!file.isAt(path_))
        {
            continue;
        }
        releaseAtExit::watch(path_, mine);

        if (now == state::elsewhere)
        {
            WarningInFunction
                << other.name() << " began to write this case, on another"
                << " host or in another container: whether it still runs can't"
                << " be told from here." << nl
                << "    If it does, stop one of the two. Its lock " << path_
                << " is taken over" << nl << endl;
        }
        else if (!content.empty())
        {
            Info<< "Lock " << fileOfCase << " of " << other.name()
                << ", which no longer runs, taken over" << nl << endl;
        }
        return string();
    }
}


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

Foam::caseLock::caseLock(const argList& args)
:
    caseLock(caseOf(args), args.executable())
{}


Foam::caseLock::caseLock(const fileName& folder, const std::string& program)
:
    path_(Pstream::master() ? fullPath(folder)/fileOfCase : fileName())
{
    const string refusal
    (
        ofAllRanks(Pstream::master() ? take(program) : string())
        [
            Pstream::masterNo()
        ]
    );

    if (!refusal.empty())
    {
        path_.clear();
        FatalErrorInFunction
            << refusal.c_str() << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::caseLock::~caseLock()
{
    if (!path_.empty())
    {
        releaseAtExit::release();
    }
}
