/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "OFstream.H"
#include "OSspecific.H"
#include "IOobject.H"
#include "temporaryCase.H"
#include "wholeFiles.H"

#include <gtest/gtest.h>

#include <filesystem>

using namespace Foam;

namespace
{

const std::string divider("// " + std::string(73, '*') + " //");


//- A file as OpenFOAM writes it, with some lines between header and end
void writeOpenFOAM(const fileName& file, IOstream::compressionType compression)
{
    OFstream os
    (
        file,
        IOstream::ASCII,
        IOstream::currentVersion,
        compression
    );
    IOobject::writeBanner(os);
    os << "FoamFile { }" << nl;
    IOobject::writeDivider(os) << nl;
    for (label i = 0; i < 5000; ++i)
    {
        os << i*0.1 << nl;
    }
    IOobject::writeEndDivider(os);
}


void cut(const fileName& file, const std::uintmax_t length)
{
    std::filesystem::resize_file(std::string(file), length);
}


std::uintmax_t sizeOf(const fileName& file)
{
    return std::filesystem::file_size(std::string(file));
}

} // End anonymous namespace


TEST(wholeFiles, knowFilesOfOpenFOAM)
{
    const temporaryCase here;
    const fileName file(here.path()/"field");
    writeOpenFOAM(file, IOstream::UNCOMPRESSED);

    EXPECT_TRUE(wholeFiles::isWhole(file));
}


TEST(wholeFiles, seeEveryTruncation)
{
    const temporaryCase here;
    const fileName file(here.path()/"field");
    writeOpenFOAM(file, IOstream::UNCOMPRESSED);
    const auto size = sizeOf(file);

    // The divider closes with a slash and a line end, which alone may be lost
    for (const auto length : {size - 2, size - 3, size - 40, size/2, size*0})
    {
        cut(file, length);
        EXPECT_FALSE(wholeFiles::isWhole(file)) << length << " of " << size;
    }
}


TEST(wholeFiles, seeTruncationInsideTheHeader)
{
    // The banner has lines of stars and dashes, too
    const temporaryCase here;
    const fileName file(here.path()/"field");

    for (const label length : {3, 80, 160, 400, 700})
    {
        writeOpenFOAM(file, IOstream::UNCOMPRESSED);
        cut(file, length);
        EXPECT_FALSE(wholeFiles::isWhole(file)) << length;
    }
}


TEST(wholeFiles, seeTheDividerWithoutTheRest)
{
    const temporaryCase here;
    here.file("short", "FoamFile { }\n// * * * * * * * * * * * * * * //\n1 2");
    here.file("spaced", "FoamFile { }\n// * * * * * * * * * * * * * * //\n");

    EXPECT_FALSE(wholeFiles::isWhole(here.path()/"short"));
    EXPECT_FALSE(wholeFiles::isWhole(here.path()/"spaced"));
}


TEST(wholeFiles, acceptOtherFilesUnlessEmpty)
{
    const temporaryCase here;
    here.file("table", "# t x\n0 1\n");
    here.file("nothing", "");

    EXPECT_TRUE(wholeFiles::isWhole(here.path()/"table"));
    EXPECT_FALSE(wholeFiles::isWhole(here.path()/"nothing"));
    EXPECT_FALSE(wholeFiles::isWhole(here.path()/"missing"));
}


TEST(wholeFiles, seeTruncationOfCompressedFiles)
{
    const temporaryCase here;
    const fileName file(here.path()/"field");
    writeOpenFOAM(file, IOstream::COMPRESSED);
    const fileName zipped(file + ".gz");
    const auto size = sizeOf(zipped);

    EXPECT_TRUE(wholeFiles::isWhole(zipped));

    for (const auto length : {size - 1, size - 4, size - 20, size/2, size*0})
    {
        cut(zipped, length);
        EXPECT_FALSE(wholeFiles::isWhole(zipped)) << length << " of " << size;
    }
}


TEST(wholeFiles, nameTheFirstBrokenOneBelow)
{
    const temporaryCase here;
    here.time("1");
    here.file("1/uniform/incomplete", "");
    here.file("1/U", "FoamFile { }\n" + divider + "\n");
    here.file("1/lagrangian/clay/x", "FoamFile { }\n(1 2");
    here.file("1/zeta", "");

    EXPECT_EQ
    (
        wholeFiles::firstBroken
        (
            here.path()/"1",
            here.path()/"1/uniform/incomplete"
        ),
        here.path()/"1/lagrangian/clay/x"
    );
}


TEST(wholeFiles, leaveOlderFilesAlone)
{
    // Put there by others, before this write began
    const temporaryCase here;
    here.time("1");
    here.file("1/notes", "");
    std::filesystem::last_write_time
    (
        std::string(here.path()/"1/notes"),
        std::filesystem::file_time_type::clock::now() - std::chrono::hours(1)
    );
    here.file("1/uniform/incomplete", "");

    EXPECT_EQ
    (
        wholeFiles::firstBroken
        (
            here.path()/"1",
            here.path()/"1/uniform/incomplete"
        ),
        fileName()
    );
}
