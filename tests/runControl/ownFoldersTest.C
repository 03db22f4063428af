/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompleteMarker.H"
#include "ownFolders.H"
#include "temporaryCase.H"

#include <gtest/gtest.h>

#include <filesystem>

using namespace Foam;

namespace
{

//- A link in the case to another place in it
void link(const temporaryCase& here, const char* name, const char* to)
{
    std::filesystem::create_symlink(to, std::string(here.path()/name));
}


bool isLink(const temporaryCase& here, const char* name)
{
    return std::filesystem::is_symlink(std::string(here.path()/name));
}

} // End anonymous namespace


TEST(ownFolders, takeThePlaceOfLinksWithTheirContent)
{
    const temporaryCase here;
    here.file("0.5/uniform/lagrangian/clay/clayState", "of the serial case");
    here.file("processor9/0.5/U", "of the rank");
    link(here, "processor9/0.5/uniform", "../../0.5/uniform");

    EXPECT_TRUE(ownFolders::make(here.path()/"processor9"/"0.5"));

    EXPECT_FALSE(isLink(here, "processor9/0.5/uniform"));
    EXPECT_FALSE(here.has("processor9/0.5/.uniform.own"));
    here.file("processor9/0.5/uniform/lagrangian/clay/clayState", "another");
    EXPECT_EQ
    (
        here.read("0.5/uniform/lagrangian/clay/clayState"), "of the serial case"
    );
    EXPECT_EQ(here.read("processor9/0.5/U"), "of the rank");
}


TEST(ownFolders, areMadeAtAnyDepthAndOfTheDirectoryItself)
{
    const temporaryCase here;
    here.file("other/0/U", "U");
    here.file("more/clayState", "state");
    std::filesystem::create_directories(std::string(here.path()/"other/0/uniform"));
    link(here, "other/0/uniform/lagrangian", "../../../more");
    link(here, "0.5", "other/0");

    EXPECT_TRUE(ownFolders::make(here.path()/"0.5"));

    EXPECT_FALSE(isLink(here, "0.5"));
    EXPECT_FALSE(isLink(here, "0.5/uniform/lagrangian"));
    EXPECT_EQ(here.read("0.5/U"), "U");
    EXPECT_EQ(here.read("0.5/uniform/lagrangian/clayState"), "state");
    EXPECT_TRUE(isLink(here, "other/0/uniform/lagrangian"));
}


TEST(ownFolders, leaveRealOnesAndMissingOnes)
{
    const temporaryCase here;
    here.file("0.5/uniform/time", "time");

    EXPECT_TRUE(ownFolders::make(here.path()/"0.5"));
    EXPECT_TRUE(ownFolders::make(here.path()/"1"));

    EXPECT_EQ(here.read("0.5/uniform/time"), "time");
    EXPECT_FALSE(here.has("1"));
}


TEST(ownFolders, incompleteMarkerMarksNoTimeButItsOwn)
{
    const temporaryCase here;
    here.file("0.5/uniform/time", "time");
    here.file("processor9/0.5/U", "U");
    here.file("processor9/1/U", "U");
    here.file("processor9/2/U", "U");
    link(here, "processor9/0.5/uniform", "../../0.5/uniform");
    link(here, "processor9/1/uniform", "../../0.5/uniform");
    link(here, "processor9/2/uniform", "../../nowhere");

    EXPECT_TRUE(incompleteMarker::set(here.path()/"processor9"/"0.5"));
    EXPECT_TRUE(incompleteMarker::found(here.path()/"processor9"/"0.5"));
    EXPECT_FALSE(incompleteMarker::found(here.path()/"0.5"));

    // purgeWrite
    EXPECT_TRUE(incompleteMarker::removeTime(here.path()/"processor9"/"1"));
    EXPECT_FALSE(here.has("processor9/1"));
    EXPECT_EQ(here.read("0.5/uniform/time"), "time");

    // The serial case's time is gone
    EXPECT_TRUE(incompleteMarker::set(here.path()/"processor9"/"2"));
    EXPECT_TRUE(incompleteMarker::found(here.path()/"processor9"/"2"));
    EXPECT_FALSE(here.has("nowhere"));
}
