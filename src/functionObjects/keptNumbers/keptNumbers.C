/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "keptNumbers.H"
#include "OFstream.H"
#include "functionObject.H"
#include "OSspecific.H"
#include "ownFolders.H"
#include "PstreamReduceOps.H"
#include "StringStream.H"
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

//- Numbers in files and in dictionaries that users write differ by their digits
bool same(const Foam::UList<Foam::token>& a, const Foam::UList<Foam::token>& b)
{
    using namespace Foam;

    if (a.size() != b.size())
    {
        return false;
    }
    forAll(a, i)
    {
        const bool numbers = a[i].isNumber() && b[i].isNumber();

        if
        (
            numbers
          ? mag(a[i].number() - b[i].number()) > 1e-6*mag(a[i].number())
          : a[i] != b[i]
        )
        {
            return false;
        }
    }
    return true;
}


//- The first entry that differs, or is missing; empty if none does
Foam::word firstOther
(
    const Foam::dictionary& before,
    const Foam::dictionary& now
)
{
    using namespace Foam;

    for (const entry& made : now)
    {
        const entry* was = before.findEntry(made.keyword(), keyType::LITERAL);

        if (!was || !same(was->stream(), made.stream()))
        {
            return made.keyword();
        }
    }
    return word();
}


//- The tokens of an entry, for messages
Foam::string valueOf(const Foam::dictionary& dict, const Foam::word& keyword)
{
    using namespace Foam;

    const entry* found = dict.findEntry(keyword, keyType::LITERAL);
    OStringStream text;
    text.precision(8);
    if (found)
    {
        const UList<token>& tokens = found->stream();
        forAll(tokens, i)
        {
            text<< (i ? " " : "") << tokens[i];
        }
    }
    return found ? text.str() : string("something else");
}

} // End anonymous namespace


Foam::keptNumbers::keptNumbers
(
    const Time& time,
    const word& name,
    const dictionary& with
)
:
    IOdictionary(fileOf(time, name, IOobject::READ_IF_PRESENT)),
    madeWith(with)
{
    if (returnReduce(headerOk(), andOp<bool>()))
    {
        // Older versions did not keep it
        const dictionary before(subOrEmptyDict("madeWith"));
        const word other
        (
            found("madeWith") ? firstOther(before, madeWith) : word()
        );

        if (!other.empty())
        {
            WarningInFunction
                << "The sums and means of " << name << " in " << objectPath()
                << nl << "    are of " << other << ' '
                << valueOf(before, other).c_str() << ", not of "
                << valueOf(madeWith, other).c_str() << " as now: they begin anew"
                << nl << endl;
            return;
        }
        for (const entry& list : *this)
        {
            if (!list.isDict())
            {
                lists.set(list.keyword(), scalarList(list.stream()));
            }
        }
    }
    else if (time.timeIndex() > 0 && !functionObject::postProcess)
    {
        Info<< name << ": there is no " << objectPath()
            << ", sums and means begin anew" << nl << endl;
    }
}


Foam::keptNumbers::keptNumbers
(
    const Time& time,
    const word& name,
    const HashTable<scalarList>& numbers,
    const dictionary& with
)
:
    IOdictionary(fileOf(time, name, IOobject::NO_READ)),
    lists(numbers),
    madeWith(with)
{}


bool Foam::keptNumbers::writeData(Ostream& os) const
{
    // 17 digits bring a double back bit for bit; as text in files of any format
    const int precision = os.precision(17);

    if (madeWith.size())
    {
        os.beginBlock("madeWith");
        for (const entry& with : madeWith)
        {
            os << with;
        }
        os.endBlock();
    }
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

    // mkDir, and what OpenFOAM writes, would follow a link
    const bool own = ownFolders::make(time().timePath());
    mkDir(file.path());
    {
        OFstream os(unfinished);
        writeHeader(os);
        writeData(os);
        writeEndDivider(os);
    }
    const bool saved =
        own && wholeFiles::isWhole(unfinished) && mv(unfinished, file);

    if (!returnReduce(saved, andOp<bool>()))
    {
        FatalErrorInFunction
            << "Cannot write " << file << ": is the disk full?" << nl
            << "    A restart from this time would begin sums and means anew"
            << exit(FatalError);
    }
}
