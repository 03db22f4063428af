/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Before OpenFOAM's headers
#include <mpi.h>

#include "releaseAtExit.H"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

// A handler of signals may use no more than plain memory and system calls
char path[PATH_MAX];
char content[2048];
ssize_t length = 0;
volatile pid_t owner = 0;


constexpr int requests[] =
{
    SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGALRM, SIGUSR1, SIGUSR2,
    SIGXCPU
};
constexpr int crashes[] = {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};

struct sigaction before[NSIG];


//- What the process was started to ignore (nohup; Ctrl-C for what a script has
//  put in the background), as it was before OpenFOAM's handlers
struct ignoredSignals
{
    bool ignored[NSIG] = {};

    ignoredSignals()
    {
        for (const int signal : requests)
        {
            struct sigaction action;
            ignored[signal] =
                sigaction(signal, nullptr, &action) == 0
             && action.sa_handler == SIG_IGN;
        }
    }
};

const ignoredSignals atStart;


void atSignal(const int signal)
{
    const int saved = errno;
    Foam::releaseAtExit::release();
    sigaction(signal, &before[signal], nullptr);
    errno = saved;

    // Comes when this returns
    raise(signal);
}


void handle(const int signal)
{
    struct sigaction action = {};
    action.sa_handler = atSignal;
    sigemptyset(&action.sa_mask);

    if
    (
        !atStart.ignored[signal]
     && sigaction(signal, &action, &before[signal]) == 0
     && before[signal].sa_handler == SIG_IGN
    )
    {
        // Ignored by the program: it goes on
        sigaction(signal, &before[signal], nullptr);
    }
}


void release()
{
    Foam::releaseAtExit::release();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

//- OpenFOAM's errors end parallel runs with it, and it doesn't come back
extern "C" int MPI_Abort(MPI_Comm communicator, int code)
{
    Foam::releaseAtExit::release();
    return PMPI_Abort(communicator, code);
}


bool Foam::releaseAtExit::watching()
{
    return owner == getpid();
}


void Foam::releaseAtExit::watch
(
    const std::string& file,
    const std::string& text
)
{
    if (file.size() >= sizeof(path) || text.size() >= sizeof(content))
    {
        return;
    }
    std::copy_n(file.c_str(), file.size() + 1, path);
    std::copy_n(text.c_str(), text.size(), content);
    length = text.size();
    owner = getpid();

    static bool done = false;
    if (!done)
    {
        done = true;
        std::atexit(::release);
        for (const int signal : requests)
        {
            handle(signal);
        }
        for (const int signal : crashes)
        {
            handle(signal);
        }
    }
}


void Foam::releaseAtExit::release()
{
    if (owner != getpid())
    {
        return;
    }
    owner = 0;

    const int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0)
    {
        return;
    }
    char found[sizeof(content)];
    const ssize_t size = read(file, found, sizeof(found));
    close(file);

    if (size == length && std::memcmp(found, content, length) == 0)
    {
        unlink(path);
    }
}
