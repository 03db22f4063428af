/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Pstream.H"
#include "caseLock.H"
#include "lockOwner.H"
#include "temporaryCase.H"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include <sys/wait.h>
#include <unistd.h>

using namespace Foam;

namespace
{

fileName lockOf(const temporaryCase& here)
{
    return here.global()/caseLock::fileOfCase;
}


//- On the master, which alone knows when it changes; elsewhere as expected
std::string contentOf(const fileName& file, const std::string& expected)
{
    if (!Pstream::master())
    {
        return expected;
    }
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}


//- The lock names this program
bool names(const temporaryCase& here, const std::string& program)
{
    return
        contentOf(lockOf(here), program).find(program) != std::string::npos;
}


//- The text with another value of this word
std::string with
(
    const std::string& text,
    const std::string& word,
    const std::string& value
)
{
    const auto begin = text.find('\n' + word + ' ') + word.size() + 2;
    return
        text.substr(0, begin) + value + text.substr(text.find('\n', begin));
}


//- Runs this in a process of its own until it says that it is ready
class otherProcess
{
    pid_t process_;

public:

    explicit otherProcess(const std::function<void()>& before)
    {
        int ends[2];
        EXPECT_EQ(pipe(ends), 0);
        process_ = fork();
        if (process_ == 0)
        {
            before();
            EXPECT_EQ(write(ends[1], "x", 1), 1);
            for (;;)
            {
                pause();
            }
        }
        char ready;
        EXPECT_EQ(read(ends[0], &ready, 1), 1);
        close(ends[0]);
        close(ends[1]);
    }

    ~otherProcess()
    {
        end(SIGKILL);
    }

    //- Ended, but not waited for
    void send(const int signal) const
    {
        kill(process_, signal);
        siginfo_t info;
        waitid(P_PID, process_, &info, WEXITED | WNOWAIT);
    }

    //- The signal that ended it
    int end(const int signal)
    {
        int status = 0;
        if (process_ > 0)
        {
            kill(process_, signal);
            waitpid(process_, &status, 0);
            process_ = 0;
        }
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }
};


//- A process that holds the lock, and where it ends by a signal releases it
otherProcess holder(const temporaryCase& here)
{
    return otherProcess([&]{new caseLock(here.global(), "clayFoam");});
}

} // End anonymous namespace


TEST(caseLock, isOfTheCaseAndGoneAtTheEnd)
{
    const temporaryCase here;
    {
        const caseLock lock(here.global(), "clayFoam");
        here.control();
        EXPECT_TRUE(std::filesystem::exists(lockOf(here).c_str()));
        EXPECT_FALSE(Pstream::parRun() && here.has(caseLock::fileOfCase));
        here.control();

        // Also on the ranks that have no file
        const std::string message
        (
            messageOf([&]{caseLock(here.global(), "erosionFoam");})
        );
        EXPECT_NE(message.find("clayFoam (process "), std::string::npos);
        EXPECT_NE(message.find("writes this case"), std::string::npos);
        here.control();
        EXPECT_TRUE(std::filesystem::exists(lockOf(here).c_str()));
        here.control();
    }
    here.control();
    EXPECT_FALSE(std::filesystem::exists(lockOf(here).c_str()));
}


TEST(caseLock, isReleasedBySignalsThatEndTheProgram)
{
    if (Pstream::parRun())
    {
        GTEST_SKIP();
    }
    // Those that a shell in the background and nohup leave
    for (const int signal : {SIGTERM, SIGUSR1, SIGXCPU, SIGABRT, SIGSEGV})
    {
        const temporaryCase here;
        otherProcess other(holder(here));
        EXPECT_NE(messageOf([&]{caseLock(here.global(), "second");}), "");
        EXPECT_NE(other.end(signal), 0) << signal;
        EXPECT_FALSE(std::filesystem::exists(lockOf(here).c_str())) << signal;
    }
}


TEST(caseLock, ofAProcessThatWasKilledIsTakenOver)
{
    if (Pstream::parRun())
    {
        GTEST_SKIP();
    }
    const temporaryCase here;
    const otherProcess other(holder(here));

    // The parent has not looked after it: still there by its number
    other.send(SIGKILL);
    EXPECT_TRUE(std::filesystem::exists(lockOf(here).c_str()));

    const caseLock lock(here.global(), "second");
    EXPECT_TRUE(names(here, "second"));
}


TEST(caseLock, ofAProcessWhoseNumberIsUsedAgainIsTakenOver)
{
    const temporaryCase here;
    if (Pstream::master())
    {
        const std::string text(lockOwner("first").text());
        std::ofstream(lockOf(here)) << with(text, "started", "1");
    }
    const caseLock lock(here.global(), "second");
    here.control();
    EXPECT_TRUE(names(here, "second"));
}


TEST(caseLock, knowsWhereItCantTell)
{
    using state = lockOwner::state;
    const std::string mine(lockOwner("first").text());
    const auto now = [](const std::string& text)
    {
        return lockOwner::read(text).now();
    };

    EXPECT_EQ(now(mine), state::alive);
    EXPECT_EQ(now(with(mine, "since", "long ago")), state::alive);

    // Another host; this one after it was started again; another container
    const std::string otherBoot(with(mine, "boot", "other"));
    EXPECT_EQ(now(with(otherBoot, "host", "other")), state::elsewhere);
    EXPECT_EQ(now(with(otherBoot, "machine", "other")), state::elsewhere);
    EXPECT_EQ(now(otherBoot), state::dead);
    EXPECT_EQ(now(with(mine, "container", "other")), state::elsewhere);

    // The host's name may change while it runs
    EXPECT_EQ(now(with(mine, "host", "renamed")), state::alive);
    EXPECT_FALSE(lockOwner::read("nothing of ours").known());
}


TEST(caseLock, ofAnotherHostIsTakenOverAndNotRemovedByIt)
{
    const temporaryCase here;
    const std::string other
    (
        with(with(lockOwner("first").text(), "boot", "b"), "host", "far")
    );
    {
        std::unique_ptr<caseLock> lock;
        if (Pstream::master())
        {
            std::ofstream(lockOf(here)) << other;
        }
        lock = std::make_unique<caseLock>(here.global(), "second");
        here.control();
        EXPECT_TRUE(names(here, "second"));

        // And this one leaves it alone where another has taken it over
        if (Pstream::master())
        {
            std::ofstream(lockOf(here)) << other;
        }
    }
    here.control();
    EXPECT_EQ(contentOf(lockOf(here), other), other);
}


TEST(caseLock, leavesAFileOfTheUserAlone)
{
    const temporaryCase here;
    if (Pstream::master())
    {
        std::ofstream(lockOf(here)) << "mine";
    }
    const std::string message
    (
        messageOf([&]{caseLock(here.global(), "clayFoam");})
    );
    EXPECT_NE(message.find("rename it"), std::string::npos) << message;
    here.control();
    EXPECT_EQ(contentOf(lockOf(here), "mine"), "mine");
}


TEST(caseLock, isOneOfManyThatStartInTheSameInstant)
{
    if (Pstream::parRun())
    {
        GTEST_SKIP();
    }
    // Without a lock before, and with one of a dead process
    for (const bool dead : {false, true})
    {
        for (int repeat = 0; repeat < 10; ++repeat)
        {
            const temporaryCase here;
            if (dead)
            {
                const std::string text(lockOwner("first").text());
                std::ofstream(lockOf(here)) << with(text, "started", "1");
            }

            // All that are refused end at once, the other one when it is told
            int go[2];
            ASSERT_EQ(pipe(go), 0);
            std::vector<pid_t> all;
            for (int i = 0; i < 6; ++i)
            {
                all.push_back(fork());
                if (all.back() == 0)
                {
                    char c;
                    close(go[1]);
                    EXPECT_EQ(read(go[0], &c, 1), 0);
                    Info.level = 0;
                    const std::string message
                    (
                        messageOf
                        ([&]{new caseLock(here.global(), "start");})
                    );
                    if (message.empty())
                    {
                        pause();
                    }
                    _exit(1);
                }
            }
            close(go[0]);
            close(go[1]);

            for (std::size_t i = 1; i < all.size(); ++i)
            {
                int status;
                EXPECT_GT(waitpid(-1, &status, 0), 0);
                EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1);
            }
            for (const pid_t process : all)
            {
                if (kill(process, SIGKILL) == 0)
                {
                    waitpid(process, nullptr, 0);
                }
            }
        }
    }
}
