/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "keptNumbers.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "wholeFiles.H"

namespace
{

Foam::IOobject fileOf
(
    const Foam::Time& time,
    const Foam::word& name,
    const Foam::IOobject::readOption read
)
{
    return Foam::IOobject
    (
        name + ".kept",
        time.timeName(),
        "uniform/functionObjects",
        time,
        read,
        Foam::IOobject::NO_WRITE,
        false
    );
}

} // End anonymous namespace


Foam::keptNumbers::keptNumbers(const Time& time, const word& name)
:
    IOdictionary(fileOf(time, name, IOobject::READ_IF_PRESENT))
{
    if (returnReduce(headerOk(), andOp<bool>()))
    {
        for (const entry& list : *this)
        {
            lists.set(list.keyword(), scalarList(list.stream()));
        }
    }
    else if (time.timeIndex() > 0)
    {
        Info<< name << ": there is no " << objectPath()
            << ", sums and means begin anew" << nl << endl;
    }
}


Foam::keptNumbers::keptNumbers
(
    const Time& time,
    const word& name,
    const HashTable<scalarList>& numbers
)
:
    IOdictionary(fileOf(time, name, IOobject::NO_READ)),
    lists(numbers)
{}


bool Foam::keptNumbers::writeData(Ostream& os) const
{
    // 17 digits bring a double back bit for bit; as text in files of any format
    const int precision = os.precision(17);

    for (const word& name : lists.sortedToc())
    {
        os.writeKeyword(name) << token::BEGIN_LIST;
        for (const scalar number : lists[name])
        {
            os << token::SPACE << number;
        }
        os << token::SPACE << token::END_LIST;
        os.endEntry();
    }
    os.precision(precision);
    return os.good();
}


void Foam::keptNumbers::save() const
{
    const fileName file(objectPath());
    const fileName unfinished(file + "-unfinished");

    mkDir(file.path());
    {
        OFstream os(unfinished);
        writeHeader(os);
        writeData(os);
        writeEndDivider(os);
    }
    const bool saved =
        wholeFiles::isWhole(unfinished) && mv(unfinished, file);

    if (!returnReduce(saved, andOp<bool>()))
    {
        FatalErrorInFunction
            << "Cannot write " << file << ": is the disk full?" << nl
            << "    A restart from this time would begin sums and means anew"
            << exit(FatalError);
    }
}
