/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "placesFile.H"

#include "dictionary.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "StringStream.H"

#include <cstdlib>

namespace
{

using namespace Foam;

//- Points that are read at once, so that a wrong size asks for no memory
constexpr label atOnce = 100000;

//- Whether a header's arch, such as "LSB;label=32;scalar=64", has this number of
//  bits, or says nothing of it
bool hasBits(const string& arch, const std::string& kind, const size_t bytes)
{
    const auto at = arch.find(kind + '=');
    return
        at == std::string::npos
     || std::atoi(arch.c_str() + at + kind.size() + 1) == int(8*bytes);
}

} // End anonymous namespace


Foam::placesFile::placesFile(const fileName& path)
:
    // OpenFOAM's streams look for name.gz where there is no name
    path_(path.ext() == "gz" && isFile(path, false) ? path.lessExt() : path)
{
    if (path_ != path && isFile(path_, false))
    {
        FatalErrorInFunction
            << path << " and " << path_ << " are the same file to OpenFOAM,"
            << " compressed and not." << nl
            << "    Give one of them another name" << exit(FatalError);
    }

    IFstream is(path_);
    if (!is.good())
    {
        FatalErrorInFunction
            << "Cannot open the list of places " << path << ": whose is it?"
            << exit(FatalError);
    }

    readHeader(is);
    const label size = readSize(is);

    if (is.format() == IOstreamOption::BINARY)
    {
        readBinary(is, size);
    }
    else
    {
        readText(is, size);
    }

    const token after(is);
    if (after.good() && !is.eof())
    {
        refuse(is, inWords(after) + " after the end of the list");
    }
    if (places_.empty())
    {
        refuse(is, "a list of no places");
    }
}


void Foam::placesFile::refuse
(
    const Istream& is,
    const std::string& found
) const
{
    FatalIOErrorInFunction(is)
        << "Not a list of places: " << found.c_str() << "." << nl
        << "    Wanted is   N ((x y z) (x y z) ...)   with N places in metres (N"
        << " may be left out)," << nl
        << "    or a field of points that OpenFOAM wrote (ascii, binary, or"
        << " compressed)" << exit(FatalIOError);
}


std::string Foam::placesFile::inWords(const token& next) const
{
    if (!next.good())
    {
        return "the end of the file";
    }
    OStringStream os;
    os.precision(6);
    os << next;
    return "'" + os.str() + "'";
}


void Foam::placesFile::expect(Istream& is, const char character) const
{
    const token next(is);
    if
    (
        !next.isPunctuation()
     || next.pToken() != token::punctuationToken(character)
    )
    {
        OStringStream place;
        place
            << inWords(next).c_str() << " instead of '" << character << "' at place "
            << places_.size() << " (counted from 0)";
        refuse(is, place.str());
    }
}


void Foam::placesFile::readHeader(IFstream& is) const
{
    token first(is);
    if (!first.good())
    {
        refuse(is, "the file is empty");
    }
    if (!first.isWord() || first.wordToken() != "FoamFile")
    {
        is.putBack(first);
        return;
    }

    const dictionary header(is);
    is.format(header.get<word>("format"));

    string arch;
    if (is.format() == IOstreamOption::BINARY && header.readIfPresent("arch", arch))
    {
        if
        (
            !hasBits(arch, "label", sizeof(label))
         || !hasBits(arch, "scalar", sizeof(scalar))
        )
        {
            refuse(is, "binary numbers of another size, '" + arch + "'");
        }
    }
}


Foam::label Foam::placesFile::readSize(Istream& is) const
{
    token first(is);

    if (first.isLabel())
    {
        if (first.labelToken() < 0)
        {
            refuse(is, "a size of " + std::to_string(first.labelToken()));
        }
        return first.labelToken();
    }
    if (first.isPunctuation() && first.pToken() == token::BEGIN_LIST)
    {
        is.putBack(first);
        return -1;
    }
    refuse(is, "it begins with " + inWords(first));
    return -1;
}


void Foam::placesFile::readText(Istream& is, const label size)
{
    expect(is, '(');

    for (token next(is); ; next = token(is))
    {
        if (next.isPunctuation() && next.pToken() == token::END_LIST)
        {
            break;
        }
        is.putBack(next);
        expect(is, '(');

        point x;
        for (direction axis = 0; axis < 3; ++axis)
        {
            const token number(is);
            if (!number.isNumber())
            {
                refuse
                (
                    is,
                    inWords(number) + " instead of a coordinate of place "
                  + std::to_string(places_.size()) + " (counted from 0)"
                );
            }
            x[axis] = number.number();
        }
        expect(is, ')');
        places_.append(x);
    }

    if (size >= 0 && size != places_.size())
    {
        refuse
        (
            is,
            "it says that there are " + std::to_string(size) + " and holds "
          + std::to_string(places_.size())
        );
    }
}


void Foam::placesFile::readBinary(IFstream& is, const label size)
{
    if (size < 0)
    {
        refuse(is, "a binary list without its size");
    }
    if (size == 0)
    {
        return;
    }

    expect(is, '(');
    List<point> some;
    for (label left = size; left > 0; left -= some.size())
    {
        some.setSize(min(left, atOnce));
        const std::streamsize bytes = some.size()*sizeof(point);
        is.stdStream().read(reinterpret_cast<char*>(some.data()), bytes);

        if (is.stdStream().gcount() != bytes)
        {
            refuse
            (
                is,
                "it says that there are " + std::to_string(size)
              + " and ends after "
              + std::to_string
                (
                    places_.size() + is.stdStream().gcount()/sizeof(point)
                )
            );
        }
        places_.append(some);
    }
    expect(is, ')');
}
