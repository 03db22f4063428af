/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runTable.H"
#include "functionObject.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "StringStream.H"
#include "Time.H"

#include <cstdlib>
#include <fstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::functionObjects::runTable::rowsBefore
(
    const fileName& file,
    const bool keepAll
)
{
    std::ifstream is(file);
    std::string kept, line;
    label cut = 0;

    // But for the round-off of its last digit
    const scalar start = (1 - 1e-11)*runTime().startTime().value();
    bool inHeading = false;
    bool keeps = true;

    // A last line without its end is one that a kill has left
    while (std::getline(is, line) && !is.eof())
    {
        if (line.compare(0, 1, "#") == 0)
        {
            heading_ = (inHeading ? heading_ : std::string()) + line + '\n';
            inHeading = true;
            kept += line + '\n';
            continue;
        }
        inHeading = false;

        // Empty lines go with the rows before them
        if (line.find_first_not_of(" \t\r") != std::string::npos)
        {
            const std::string time(line.substr(0, line.find_first_of(" \t")));
            keeps =
                keepAll
             || !(
                    isAfterStart(time)
                 || (withoutStart_ && std::strtod(time.c_str(), nullptr) >= start)
                );
            cut += !keeps;
        }
        if (keeps)
        {
            kept += line + '\n';
        }
    }
    if (cut)
    {
        Info<< file << " goes on from " << runTime().startTime().value()
            << " s: " << cut << " rows after that are removed" << endl;
    }
    return kept;
}


void Foam::functionObjects::runTable::head()
{
    OStringStream os;
    initStream(os);
    writeHeading(os);

    if (os.str() != heading_)
    {
        heading_ = os.str();
        table_() << heading_.c_str();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::functionObjects::runTable::begin()
{
    if (begun_)
    {
        return;
    }
    begun_ = true;

    const bool first = isFirst();

    if (!Pstream::master())
    {
        return;
    }

    const word last(removeOld(wordList({tableName_}), !first));

    if (!writeToFile_)
    {
        return;
    }

    const scalar start =
        functionObject::postProcess
      ? runTime().value()
      : runTime().startTime().value();
    const fileName directory
    (
        folder()/(last.empty() ? Time::timeName(start) : last)
    );
    file_ = directory/(tableName_ + ".dat");
    const fileName unfinished(file_ + "-unfinished");

    mkDir(directory);
    const std::string kept(rowsBefore(file_, !first));

    table_.reset(new OFstream(unfinished));
    table_() << kept.c_str();
    table_->flush();

    // The stream goes on in the file under its new name
    if (!table_->good() || !mv(unfinished, file_))
    {
        FatalErrorInFunction
            << "Cannot write " << file_ << ": is the disk full?"
            << exit(FatalError);
    }
    initStream(table_());
    // That of one number, which may be the first of a row
    table_->width(0);
    head();
    table_->flush();
}


Foam::Ostream& Foam::functionObjects::runTable::rows()
{
    begin();

    if (!table_.valid())
    {
        return Snull;
    }

    head();
    return table_();
}


void Foam::functionObjects::runTable::writeTime(Ostream& os) const
{
    const int precision = os.precision(max(label(12), label(writePrecision_)));
    os  << runTime().value();
    os.precision(precision);
}


void Foam::functionObjects::runTable::endRows()
{
    setNow();

    if (table_.valid())
    {
        table_->flush();
        if (!table_->good())
        {
            FatalErrorInFunction
                << "Cannot write " << file_ << ": is the disk full?"
                << exit(FatalError);
        }
    }
}
