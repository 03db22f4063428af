/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "temporaryCase.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace Foam;

namespace fs = std::filesystem;

namespace
{

void waitForAll()
{
    label all = 0;
    reduce(all, sumOp<label>());
}


fs::path asPath(const std::string& name)
{
    return name;
}

} // End anonymous namespace


temporaryCase::temporaryCase()
{
    if (Pstream::master())
    {
        std::string pattern(fs::temp_directory_path()/"runControl.XXXXXX");
        global_ = mkdtemp(&pattern[0]);
        fs::create_directory(asPath(global_/"system"));
    }
    Pstream::scatter(global_);
    fs::create_directories(asPath(path()));
    control();
}


temporaryCase::~temporaryCase()
{
    waitForAll();
    if (Pstream::master())
    {
        std::error_code ignored;
        fs::remove_all(asPath(global_), ignored);
    }
}


fileName temporaryCase::caseName() const
{
    return
        Pstream::parRun()
      ? global_.name()/("processor" + Foam::name(Pstream::myProcNo()))
      : fileName(global_.name());
}


fileName temporaryCase::path() const
{
    return global_.path()/caseName();
}


void temporaryCase::control(const std::string& entries) const
{
    waitForAll();
    if (Pstream::master())
    {
        // Later entries overwrite earlier ones
        std::ofstream(global_/"system"/"controlDict")
            << "FoamFile { version 2.0; format ascii; class dictionary;"
            << " object controlDict; }\n"
            << "startFrom latestTime; startTime 0; stopAt endTime; endTime 2;"
            << " deltaT 0.1; adjustTimeStep yes;"
            << " writeControl adjustableRunTime; writeInterval 0.5;"
            << " writeFormat ascii; writePrecision 6; timePrecision 6;"
            << " runTimeModifiable no;\n"
            << entries << '\n';
    }
    waitForAll();
}


void temporaryCase::time(const std::string& name) const
{
    fs::create_directories(asPath(path()/name/"uniform"));
}


void temporaryCase::file(const std::string& name, const std::string& text) const
{
    const fs::path whole(asPath(path())/name);
    fs::create_directories(whole.parent_path());
    std::ofstream(whole) << text;
}


std::string temporaryCase::read(const std::string& name) const
{
    std::ostringstream text;
    text << std::ifstream(asPath(path())/name).rdbuf();
    return text.str();
}


bool temporaryCase::has(const std::string& name) const
{
    return fs::exists(asPath(path())/name);
}
