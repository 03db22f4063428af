/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseFile.H"
#include "dictionaryText.H"

#include "IStringStream.H"
#include "OSspecific.H"

#include <gtest/gtest.h>

#include <fstream>

using namespace Foam;

namespace
{

//- A case in a folder of its own, for as long as it lives
class emptyCase
{
    const fileName before_;

public:

    const fileName root;

    emptyCase()
    :
        before_(getEnv("FOAM_CASE")),
        root(cwd()/"caseOfTest")
    {
        mkDir(root/"system");
        setEnv("FOAM_CASE", root, true);
    }

    ~emptyCase()
    {
        setEnv("FOAM_CASE", before_, true);
        rmDir(root);
    }

    void write(const fileName& name, const char* text) const
    {
        std::ofstream(root/name) << text;
    }
};

} // End anonymous namespace


TEST(caseFile, isRelativeToTheCase)
{
    const emptyCase here;
    const auto path = [](const char* written)
    {
        return colloid::caseFile(fileName(written));
    };

    for
    (
        const char* written :
        {"a/D.dat", "./a/D.dat", "<case>/a/D.dat", "$FOAM_CASE/a/D.dat", "b/../a/D.dat"}
    )
    {
        EXPECT_EQ(path(written), here.root/"a/D.dat") << written;
    }
    EXPECT_EQ(path("../D.dat"), here.root.path()/"D.dat");
    EXPECT_EQ(path("<constant>/D.dat"), here.root/"constant/D.dat");
    EXPECT_EQ(path("/D.dat"), "/D.dat");
    EXPECT_EQ
    (
        colloid::caseFile("D.dat", "constant/triSurface"),
        here.root/"constant/triSurface/D.dat"
    );
}


TEST(caseFile, refusesWhatIsMissingAndNamesItInFull)
{
    const emptyCase here;
    IStringStream is("file \"D.dat\";");
    const dictionary dict(is);

    try
    {
        colloid::caseFile(dict, "file");
        FAIL() << "no error";
    }
    catch (const Foam::error& err)
    {
        EXPECT_NE(err.message().find(here.root/"D.dat"), std::string::npos);
    }
}


TEST(dictionaryText, findsVariablesAlsoOfIncludedFiles)
{
    const emptyCase here;
    here.write
    (
        "system/a",
        "#include \"b\"\n x $one; // $two\n y \"$three + 1\"; /* $four */"
        " z ${five}; u $:variables.six;"
    );
    here.write("system/b", "x $seven;");

    const wordHashSet found
    (
        colloid::dictionaryText(here.root/"system/a").variables()
    );
    EXPECT_EQ
    (
        found,
        wordHashSet({"one", "three", "five", "variables", "six", "seven"})
    );
}


TEST(dictionaryText, findsNumbersThatAreNone)
{
    const emptyCase here;
    const auto wrong = [&](const char* text)
    {
        here.write("system/a", text);
        return colloid::dictionaryText(here.root/"system/a").tooLarge();
    };

    EXPECT_EQ(wrong("a 1;\n\nb (1 -1e400);").line, 3);
    EXPECT_EQ(wrong("a 1;\n\nb (1 -1e400);").text, "-1e400");
    EXPECT_EQ(wrong("a 1.8e308;").text, "1.8e308");
    EXPECT_EQ(wrong("/* 1e400\n */ a +.1E999;").line, 2);

    for
    (
        const char* right :
        {
            "a 1e308; b 1e-400;", "a a1e400;", "a 1e400m;", "a \"1e400\";",
            "a 1; // 1e400", "a infinity; b nan;"
        }
    )
    {
        EXPECT_EQ(wrong(right).line, 0) << right;
    }
}


TEST(dictionaryText, findsLinesByWords)
{
    const emptyCase here;
    here.write
    (
        "system/a",
        "inletOf 1;\nboundaryField\n{\n walls {}\n inlet { type x; }\n}"
    );
    const colloid::dictionaryText text(here.root/"system/a");

    EXPECT_EQ(text.lineOf(wordList({"boundaryField", "inlet"})), 5);
    EXPECT_EQ(text.lineOf(wordList({"boundaryField", "outlet"})), 2);
    EXPECT_EQ(text.lineOf(wordList({"none"})), 1);
}


// ************************************************************************* //
