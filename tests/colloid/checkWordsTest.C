/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkWords.H"
#include "readInRange.H"

#include "IStringStream.H"
#include "dictionary.H"
#include "error.H"

#include <gtest/gtest.h>

#include <limits>

using namespace Foam;

namespace
{

dictionary parse(const char* text)
{
    IStringStream stream(text);
    return dictionary(stream);
}

// The message of the error that the call throws
template<class Call>
std::string messageOf(const Call& call)
{
    try
    {
        call();
    }
    catch (const Foam::error& err)
    {
        return err.message();
    }

    return "no error";
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

const wordList words({"diameter", "thickness", "density"});

} // End anonymous namespace


TEST(checkWords, acceptsWhatIsValid)
{
    const dictionary dict(parse("diameter 1; density 2;"));
    EXPECT_NO_THROW(colloid::checkWords(dict, words));
}


// Anything may be in it; beside it a variable is an unknown word
TEST(checkWords, acceptsVariablesOfTheUser)
{
    const dictionary dict(parse("diameter 1; variables { x 1; y { z 2; } }"));
    EXPECT_NO_THROW(colloid::checkWords(dict, words));

    EXPECT_TRUE
    (
        contains
        (
            messageOf([]{ colloid::checkWords(parse("x 1;"), words); }),
            "variables { x"
        )
    );
    EXPECT_TRUE
    (
        contains
        (
            messageOf([]{ colloid::checkWords(parse("variables 1;"), words); }),
            "in braces"
        )
    );
}


TEST(checkWords, namesTheMisspeltAndTheNearestWordAndAllValidOnes)
{
    const dictionary dict(parse("diameter 1;\nthicknes 2;\n"));
    const std::string message =
        messageOf([&] { colloid::checkWords(dict, words); });

    EXPECT_TRUE(contains(message, "'thicknes'")) << message;
    EXPECT_TRUE(contains(message, "did you mean 'thickness'?")) << message;
    EXPECT_TRUE(contains(message, "diameter thickness density")) << message;
}


TEST(checkWords, namesFileAndLineOfTheMisspeltEntry)
{
    // A stream from text counts its lines from 0, a file from 1
    IStringStream stream("\ndiameter 1;\n\nwater { thicknes 2;\n densiti 3; }");
    dictionary dict("constant/someFile", dictionary(), stream);

    try
    {
        colloid::checkWords(dict.subDict("water"), wordList({"thicknes"}));
        FAIL() << "no error";
    }
    catch (const IOerror& err)
    {
        EXPECT_EQ(err.ioStartLineNumber(), 4);
        EXPECT_TRUE(contains(err.ioFileName(), "constant/someFile"))
            << err.ioFileName();
    }
}


TEST(checkWords, findsSlipsWhereAnyWordIsAllowed)
{
    const dictionary control
    (
        parse
        (
            "deltaT 1; adjustTimeStep yes; maxFo 1; x 2; deltaT0 1; endTime1 2;"
            "deltaX 3; minDeltaT 4; functions_ {} functionsOff {}"
        )
    );
    const dictionary solution(parse("solvers {} erosion {} clayRim {}"));
    EXPECT_NO_THROW(colloid::checkSpelling(control, solution, {}));

    const auto says = [&](const dictionary& c, const dictionary& s)
    {
        return messageOf([&] { colloid::checkSpelling(c, s, {}); });
    };
    for (const char* wrong : {"adjustTimestep", "adjustTimStep", "AdjustTimeSteps", "adjustTiemStep"})
    {
        const std::string entry(std::string(wrong) + " yes;");
        const std::string message(says(parse(entry.c_str()), solution));

        EXPECT_TRUE(contains(message, wrong)) << message;
        EXPECT_TRUE(contains(message, "did you mean 'adjustTimeStep'")) << message;
    }
    EXPECT_TRUE
    (
        contains(says(parse("maxdeltat 1;"), solution), "'maxDeltaT'")
    );
    EXPECT_TRUE(contains(says(parse("maxC0 1;"), solution), "'maxCo'"));
    EXPECT_TRUE
    (
        contains(says(control, parse("erosoin {}")), "did you mean 'erosion'")
    );
}


TEST(checkWords, takesNoVariableForASlip)
{
    const dictionary control(parse("endTimes 1; endTime 1;"));
    const dictionary solution;

    EXPECT_NO_THROW
    (
        colloid::checkSpelling(control, solution, wordHashSet({"endTimes"}))
    );
    EXPECT_THROW
    (
        colloid::checkSpelling(control, solution, wordHashSet({"endTime"})),
        Foam::error
    );
}


TEST(checkWords, suggestsNothingThatIsAnotherWord)
{
    EXPECT_EQ(colloid::nearestWord("xyzzy", words), word());
}


// A letter left out, added, replaced, two swapped, and another case
TEST(checkWords, findsTheNearestWordOfEachTypingError)
{
    for (const char* wrong : {"densty", "deensity", "denzity", "denisty"})
    {
        EXPECT_EQ(colloid::nearestWord(wrong, words), word("density"));
    }

    // Two swapped letters are nearer than two replaced ones
    EXPECT_EQ(colloid::nearestWord("abdc", wordList({"abxy", "abcd"})), "abcd");

    EXPECT_EQ(colloid::nearestWord("kozeny", wordList({"Kozeny"})), "Kozeny");
}


TEST(checkWords, refusesAChoiceThatIsNotOffered)
{
    const dictionary dict(parse("model stokes;"));
    const std::string message = messageOf
    (
        [&]
        {
            colloid::checkChoice
            (
                dict, "model", "stokes", wordList({"Stokes", "constant"})
            );
        }
    );

    EXPECT_TRUE(contains(message, "did you mean 'Stokes'?")) << message;
}


TEST(readInRange, namesTheValidRangeAndTheLine)
{
    const dictionary dict(parse("\n\n\ndiameter -2e-07;"));

    try
    {
        colloid::readInRange(dict, "diameter", 1e-9, 1e-4, "m");
        FAIL() << "no error";
    }
    catch (const IOerror& err)
    {
        EXPECT_EQ(err.ioStartLineNumber(), 3);
        EXPECT_TRUE(contains(err.message(), "from 1e-09 to 0.0001 m"))
            << err.message();
    }
}


TEST(readInRange, acceptsTheLimitsThemselves)
{
    const dictionary dict(parse("a 1; b 2;"));
    EXPECT_EQ(colloid::readInRange(dict, "a", 1, 2, ""), 1);
    EXPECT_EQ(colloid::readInRange(dict, "b", 1, 2, ""), 2);
}


TEST(readInRange, refusesMissingAndNotANumber)
{
    dictionary dict(parse("a word;"));
    EXPECT_THROW(colloid::readInRange(dict, "a", 1, 2, ""), Foam::error);
    EXPECT_THROW(colloid::readInRange(dict, "b", 1, 2, ""), Foam::error);

    dict.add
    (
        new primitiveEntry
        (
            "c", token(std::numeric_limits<scalar>::quiet_NaN())
        )
    );
    EXPECT_THROW(colloid::readInRange(dict, "c", 1, 2, ""), Foam::error);
}


TEST(readInRange, usesTheDefaultOnlyForAMissingEntry)
{
    const dictionary dict(parse("a 1.5;"));
    EXPECT_EQ(colloid::readInRange(dict, "a", 7, 1, 2, ""), 1.5);
    EXPECT_EQ(colloid::readInRange(dict, "b", 7, 1, 2, ""), 7);
}


// ************************************************************************* //
