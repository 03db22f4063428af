/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runTable.H"
#include "functionObject.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "regIOobject.H"
#include "restartableTime.H"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

//- Stands in the run's registry for a table that the run has begun
struct begunTable
:
    public Foam::regIOobject
{
    using Foam::regIOobject::regIOobject;

    virtual bool writeData(Foam::Ostream&) const
    {
        return true;
    }
};


//- A number in so many digits
Foam::scalar rounded(const Foam::scalar value, const int digits)
{
    char text[64];
    std::snprintf(text, sizeof(text), "%.*e", digits - 1, double(value));
    return std::strtod(text, nullptr);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::functionObjects::runTable::startsAnew() const
{
    return functionObject::postProcess || runTime().startTimeIndex() == 0;
}


bool Foam::functionObjects::runTable::isAfterStart
(
    const std::string& written
) const
{
    const scalar start = runTime().startTime().value();
    const scalar time = std::strtod(written.c_str(), nullptr);

    if (time <= start)
    {
        return false;
    }

    // A time that was rounded when it was written may lie above the start which
    // it is
    const auto exponent = written.find_first_of("eE");
    const int digits = std::count_if
    (
        written.begin(),
        exponent == std::string::npos ? written.end() : written.begin() + exponent,
        [](const unsigned char c) { return std::isdigit(c); }
    );
    if (time <= rounded(start, std::min(17, std::max(6, digits))))
    {
        return false;
    }

    // OpenFOAM's own Time knows no more of its start than the folder's name
    return
        isA<restartableTime>(runTime())
     || Time::timeName(time) != Time::timeName(start);
}


Foam::fileName Foam::functionObjects::runTable::folder() const
{
    return
        baseFileDir()
       /word
        (
            functionObject::postProcess
          ? word(tableName_ + "-postProcess")
          : tableName_
        );
}


Foam::wordList Foam::functionObjects::runTable::times() const
{
    wordList found;

    for (const fileName& name : readDir(folder(), fileName::DIRECTORY))
    {
        char* end = nullptr;
        std::strtod(name.c_str(), &end);
        if (!name.empty() && *end == '\0')
        {
            found.append(word(name));
        }
    }
    std::sort
    (
        found.begin(),
        found.end(),
        [](const word& a, const word& b)
        {
            return
                std::strtod(a.c_str(), nullptr)
              < std::strtod(b.c_str(), nullptr);
        }
    );
    return found;
}


void Foam::functionObjects::runTable::removeOf
(
    const word& time,
    const wordList& files
) const
{
    const fileName directory(folder()/time);
    std::error_code error;

    for (const word& name : files)
    {
        // profile.dat, and profile_0.dat of former versions
        for
        (
            const std::string& file :
            {
                name + ".dat", name + "_" + time + ".dat",
                name + ".dat-unfinished"
            }
        )
        {
            // These alone, where OpenFOAM's rm takes profile.dat.gz too
            if (std::filesystem::remove(std::string(directory/file), error))
            {
                Info<< "Removes " << directory/file
                    << ", of another run or after its time" << endl;
            }
        }
    }

    // Only if nothing else is in it
    std::filesystem::remove(std::string(directory), error);
}


Foam::word Foam::functionObjects::runTable::removeOld
(
    const wordList& files,
    const bool keepAll
) const
{
    word last;

    for (const word& time : times())
    {
        if (!keepAll && (startsAnew() || isAfterStart(time)))
        {
            removeOf(time, files);
        }
        else
        {
            for (const word& name : files)
            {
                if (isFile(folder()/time/(name + ".dat")))
                {
                    last = time;
                }
            }
        }
    }
    return last;
}


bool Foam::functionObjects::runTable::isFirst() const
{
    // A function object may be taken out and put back while the run goes on
    const word name("begunTable:" + fileObr_.name() + ':' + tableName_);

    if (runTime().foundObject<regIOobject>(name))
    {
        return false;
    }
    regIOobject::store
    (
        new begunTable
        (
            IOobject
            (
                name,
                runTime().constant(),
                runTime(),
                IOobject::NO_READ,
                IOobject::NO_WRITE
            )
        )
    );
    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::runTable::runTable
(
    const objectRegistry& obr,
    const word& name
)
:
    writeFile(obr, name),
    tableName_(name),
    begun_(false),
    withoutStart_(false),
    lastIndex_(-1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::functionObjects::runTable::begin(const wordList& files)
{
    if (begun_)
    {
        return;
    }
    begun_ = true;

    const bool first = isFirst();

    if (Pstream::master())
    {
        removeOld(files, !first);
    }
}


Foam::fileName Foam::functionObjects::runTable::timeFolder() const
{
    return folder()/runTime().timeName();
}


bool Foam::functionObjects::runTable::hasNow() const
{
    return lastIndex_ == runTime().timeIndex();
}


void Foam::functionObjects::runTable::setNow()
{
    lastIndex_ = runTime().timeIndex();
}
