/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayProperties.H"
#include "readInRange.H"
#include "unitWords.H"

#include "IStringStream.H"
#include "dictionary.H"
#include "error.H"
#include "vector.H"

#include <gtest/gtest.h>

#include <tuple>

using namespace Foam;

namespace
{

dictionary parse(const std::string& text)
{
    // A stream from text counts its lines from 0, a file from 1
    IStringStream stream("\n" + text);
    return dictionary("constant/someFile", dictionary(), stream);
}

scalar read(const std::string& value, const char* SIunit)
{
    return colloid::readInRange
    (
        parse("it " + value + ";"), "it", -GREAT, GREAT, SIunit
    );
}

// Message, file and line of the refusal
std::string refusal(const std::string& value, const char* SIunit)
{
    try
    {
        read(value, SIunit);
    }
    catch (const IOerror& err)
    {
        return
            err.message() + " [" + err.ioFileName() + " line "
          + std::to_string(err.ioStartLineNumber()) + "]";
    }

    return "no error";
}

constexpr scalar year = 31557600;

} // End anonymous namespace


TEST(unitWords, areConverted)
{
    const std::vector<std::tuple<const char*, const char*, scalar>> cases
    {
        {"1 mM", "mol/m3", 1},
        {"0.2 mmol/l", "mol/m3", 0.2},
        {"2e-3 mol/l", "mol/m3", 2},
        // 58.443 g/mol of NaCl
        {"5.8e-3 g/l", "mol/m3", 5.8/58.443},
        {"5.8 mg/l", "mol/m3", 5.8/58.443},
        {"315.576 m/a", "m/s", 1e-5},
        {"86.4 mm/s", "m/s", 0.0864},
        {"8.64 m/d", "m/s", 1e-4},
        {"0.1 mm", "m", 1e-4},
        {"200 nm", "m", 2e-7},
        {"1.6 g/cm3", "kg/m3", 1600},
        {"1600 kg/m3", "kg/m3", 1600},
        {"1e5 a", "s", 1e5*year},
        {"3 h", "s", 10800},
        {"31557600 m2/a", "m2/s", 1},
        {"1.3 mPa s", "Pa s", 1.3e-3},
        {"10 zJ", "J", 1e-20},
        {"3 l", "m3", 3e-3},
        {"13.1 uC/cm2", "C/m2", 0.131},
        {"5", "mol/m3", 5},
        {"5", "(-)", 5}
    };

    for (const auto& [value, SIunit, converted] : cases)
    {
        EXPECT_NEAR(read(value, SIunit)/converted, 1, 1e-14) << value;
    }
}


// 1 nM must not become 1, nor a length a concentration
TEST(unitWords, ofAnotherQuantityAreRefused)
{
    for
    (
        const char* value :
        {"1 nm", "1 nM", "1 m/a", "1 kg/m3", "1 g / l l", "1 mM mM", "1 2",
         "1 (mM)", "1 g/", "1 /l"}
    )
    {
        const std::string message = refusal(value, "mol/m3");

        for
        (
            const char* part :
            {"'it'", "mmol/l", "g/l (NaCl)", "[constant/someFile line 1]"}
        )
        {
            EXPECT_NE(message.find(part), std::string::npos)
                << part << " in " << message;
        }
    }

    EXPECT_NE(refusal("1 nM", "mol/m3").find("'it': nM"), std::string::npos);
    EXPECT_NE
    (
        refusal("5 m", "(-)").find("one value without a unit"),
        std::string::npos
    );
    EXPECT_NE(refusal("mM", "mol/m3").find("not a number"), std::string::npos);
}


// The valid range is that of the SI value
TEST(unitWords, areConvertedBeforeTheRangeIsChecked)
{
    const dictionary dict(parse("aperture 1 mm;"));

    EXPECT_EQ
    (
        colloid::readInRange(dict, "aperture", 1e-6, 0.1, "m (half of it)"),
        1e-3
    );
    EXPECT_THROW
    (
        colloid::readInRange(dict, "aperture", 0.01, 10, "m"), Foam::error
    );
}


TEST(unitWords, followConstantsOfTime)
{
    const auto concentration = [](const std::string& value)
    {
        return colloid::clayProperties
        (
            parse("water { concentration " + value + "; }")
        ).waterAt(0).concentration;
    };

    EXPECT_NEAR(concentration("5.8e-3 g/l"), 0.099242, 1e-6);
    EXPECT_EQ(concentration("constant 0.1 mM"), 0.1);
    EXPECT_EQ(concentration("0.1"), 0.1);
    EXPECT_EQ(concentration("constant 0.1"), 0.1);
    EXPECT_THROW(concentration("1 nm"), Foam::error);
    EXPECT_THROW(concentration("constant 0.1 2"), Foam::error);

    // A table is in SI units
    EXPECT_NEAR(concentration("table ((-1 0.1) (1 0.3))"), 0.2, 1e-15);

    const vector U = colloid::readFunction1<vector>
    (
        parse("U (315.576 0 -31.5576) m/a;"), "U", "m/s"
    )->value(0);
    EXPECT_NEAR(U.x(), 1e-5, 1e-19);
    EXPECT_NEAR(U.z(), -1e-6, 1e-20);
}


TEST(unitWords, areEchoedOnce)
{
    const dictionary dict
    (
        "constant/echoed", dictionary(), IStringStream("c 5.8e-3 g/l;")()
    );

    testing::internal::CaptureStdout();
    colloid::readInRange(dict, "c", 0, 1, "mol/m3");
    Info().flush();
    EXPECT_EQ
    (
        testing::internal::GetCapturedStdout(),
        "c 0.0058 g/l (NaCl) read as 0.099242 mol/m3\n"
    );

    testing::internal::CaptureStdout();
    colloid::readInRange(dict, "c", 0, 1, "mol/m3");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}


// ************************************************************************* //
