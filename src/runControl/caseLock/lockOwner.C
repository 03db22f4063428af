/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lockOwner.H"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

const std::string heading("# The program that writes this case (bentoFoam)");


std::string firstLine(const std::string& file)
{
    std::string line;
    std::ifstream is(file);
    std::getline(is, line);
    return line;
}


//- State (R, S, Z ...) and start [clock ticks since boot] of a process; empty
//  if it isn't there
struct processStat
{
    std::string state;
    std::string start;

    explicit processStat(const std::string& process)
    {
        const std::string line(firstLine("/proc/" + process + "/stat"));

        // The program's name is in brackets and may hold anything
        const auto name = line.rfind(')');
        if (name == std::string::npos)
        {
            return;
        }
        std::istringstream fields(line.substr(name + 1));
        fields >> state;

        // The 22nd field
        for (int i = 4; i <= 22; ++i)
        {
            fields >> start;
        }
    }
};


std::string hostName()
{
    char name[256] = "";
    gethostname(name, sizeof(name) - 1);
    return name;
}


//- Of the container
std::string processNames()
{
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/ns/pid", none).string();
}


std::string now()
{
    const std::time_t clock = std::time(nullptr);
    char text[64];
    std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M:%S", localtime(&clock));
    return text;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * * //

Foam::lockOwner::lockOwner(const std::string& program)
{
    if (program.empty())
    {
        return;
    }
    const std::string process(std::to_string(getpid()));

    entries_ =
    {
        {"program", program},
        {"process", process},
        {"started", processStat(process).start},
        {"since", ::now()},
        {"host", hostName()},
        {"machine", firstLine("/etc/machine-id")},
        {"boot", firstLine("/proc/sys/kernel/random/boot_id")},
        {"container", processNames()}
    };
}


Foam::lockOwner Foam::lockOwner::read(const std::string& text)
{
    lockOwner owner("");
    std::istringstream lines(text);
    std::string line;

    std::getline(lines, line);
    if (line != heading)
    {
        return owner;
    }
    while (std::getline(lines, line))
    {
        const auto end = line.find(' ');
        if (end != std::string::npos)
        {
            owner.entries_[line.substr(0, end)] = line.substr(end + 1);
        }
    }
    return owner;
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

std::string Foam::lockOwner::entry(const std::string& word) const
{
    const auto found = entries_.find(word);
    return found == entries_.end() ? "" : found->second;
}


std::string Foam::lockOwner::text() const
{
    std::string lines(heading + '\n');
    for (const auto& [word, value] : entries_)
    {
        lines += word + ' ' + value + '\n';
    }
    return lines;
}


bool Foam::lockOwner::known() const
{
    return !entry("process").empty();
}


Foam::lockOwner::state Foam::lockOwner::now() const
{
    const lockOwner here("here");

    const auto same = [&](const char* word)
    {
        return entry(word) == here.entry(word);
    };

    if (!same("boot") || here.entry("boot").empty())
    {
        // Host names alone may be alike
        if (!same("host") || !same("machine"))
        {
            return state::elsewhere;
        }
        if (!same("boot"))
        {
            return state::dead;
        }
    }
    if (!same("container"))
    {
        return state::elsewhere;
    }

    const std::string process(entry("process"));
    const long number = std::strtol(process.c_str(), nullptr, 10);

    if (number <= 0 || (kill(pid_t(number), 0) != 0 && errno == ESRCH))
    {
        return state::dead;
    }

    // Killed but not yet waited for, or another process of that number
    const processStat found(process);
    const bool over = found.state == "Z" || found.state == "X";

    return
        over || found.start != entry("started") ? state::dead : state::alive;
}


std::string Foam::lockOwner::name() const
{
    return
        entry("program") + " (process " + entry("process") + " on "
      + entry("host") + ", since " + entry("since") + ")";
}
