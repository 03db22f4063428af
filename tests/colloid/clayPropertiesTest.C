/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayProperties.H"
#include "referenceTable.H"

#include "IStringStream.H"
#include "IFstream.H"
#include "Time.H"
#include "OSspecific.H"
#include "error.H"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace Foam;
using namespace Foam::colloid;

namespace
{

dictionary parse(const std::string& text)
{
    // A stream from text counts its lines from 0, a file from 1
    IStringStream stream("\n" + text);
    return dictionary("constant/clayProperties", dictionary(), stream);
}

// The message of the error that these entries cause, with its file and line
std::string refusal(const std::string& text)
{
    try
    {
        clayProperties properties(parse(text));
    }
    catch (const IOerror& err)
    {
        return
            err.message() + " [" + err.ioFileName() + " line "
          + std::to_string(err.ioStartLineNumber()) + "]";
    }
    catch (const Foam::error& err)
    {
        return err.message();
    }

    return "no error";
}

void expectRefusal
(
    const std::string& text,
    const std::vector<std::string>& parts
)
{
    const std::string message = refusal(text);

    for (const std::string& part : parts)
    {
        EXPECT_NE(message.find(part), std::string::npos)
            << text << "\nlacks '" << part << "':\n" << message;
    }
}

std::string printedDefaults(const clayProperties& properties)
{
    OStringStream stream;
    properties.writeDefaults(stream);
    return stream.str();
}

const std::string water1 = "water { concentration 0.1; }";

} // End anonymous namespace


TEST(clayProperties, needsNothingButTheConcentration)
{
    const clayProperties properties(parse(water1));

    EXPECT_EQ(properties.waterAt(0).concentration, 0.1);
    EXPECT_FALSE(properties.concentrationVaries());
    EXPECT_EQ(properties.parameterSet(), "default");
    EXPECT_EQ(properties.frictionModel(), "auto");

    // 2.5 kT at 298.15 K to the last digit, since the reference has it so
    EXPECT_DOUBLE_EQ
    (
        properties.clay().Hamaker, 2.5*1.380649e-23*298.15
    );
    EXPECT_EQ(properties.clay().diameter, 200e-9);
    EXPECT_EQ(properties.clay().contactGap, 1e-10);
    EXPECT_EQ(properties.waterAt(0).temperature, 298.15);
}


TEST(clayProperties, defaultsAreThoseOfTheReference)
{
    const clayProperties properties(parse(water1));
    const water solution = properties.waterAt(0);
    const auto layer = properties.newDoubleLayer("compression", solution);
    const auto friction = properties.newFriction("KozenyCarman", solution);
    const auto viscosity = properties.viscosity(solution);

    for (const referenceRow& row : referenceTable("suspension.csv"))
    {
        if (row.at("c") != 0.1)
        {
            continue;
        }

        const scalar phi = row.at("phi");
        const scalar gap = properties.clay().stackGap(phi);

        EXPECT_LT(relativeError(layer->force(gap), row.at("F_DDL")), 1e-10);
        EXPECT_LT(relativeError(friction->value(phi), row.at("xi")), 1e-10);
        EXPECT_LT
        (
            relativeError(viscosity.uncappedViscosity(phi), row.at("eta_r")),
            1e-10
        );
    }
}


TEST(clayProperties, readsEveryEntry)
{
    const clayProperties properties
    (
        parse
        (
            "platelet { diameter 3e-7; thickness 2e-9; density 2500;"
            " surfaceCharge 0.1; Hamaker 2e-20; contactGap 2e-10; }"
            "water { concentration 3; valence 1; temperature 300;"
            " relativePermittivity 80; viscosity 2e-3; density 1010; }"
            "friction { model constant; value 1e-9; Kozeny 7; fraction 0.02; }"
            "viscosity { model LiuCoVolume; coreThickness 2; gelCoVolume 1.5;"
            " gelStop off; gelViscosity 1e5; }"
            "flocculation { active on; fraction 0.006; }"
        )
    );
    const platelet& clay = properties.clay();
    const water solution = properties.waterAt(0);

    EXPECT_EQ(clay.diameter, 3e-7);
    EXPECT_EQ(clay.thickness, 2e-9);
    EXPECT_EQ(clay.density, 2500);
    EXPECT_EQ(clay.surfaceCharge, 0.1);
    EXPECT_EQ(clay.Hamaker, 2e-20);
    EXPECT_EQ(clay.contactGap, 2e-10);
    EXPECT_EQ(solution.concentration, 3);
    EXPECT_EQ(solution.temperature, 300);
    EXPECT_EQ(solution.relativePermittivity, 80);
    EXPECT_EQ(solution.viscosity, 2e-3);
    EXPECT_EQ(solution.density, 1010);
    EXPECT_EQ(properties.frictionModel(), "constant");
    EXPECT_EQ(properties.Kozeny(), 7);
    EXPECT_EQ(properties.newFriction("constant", solution)->value(0.5), 1e-9);
    EXPECT_FALSE(properties.newFriction("KozenyCarman", solution)->varies());
    EXPECT_EQ(properties.viscosity(solution).gelFraction(), 0.006);
    EXPECT_EQ(properties.viscosity(solution).gelViscosity(), 1e5);

    // Nothing is left to be a default
    EXPECT_EQ
    (
        printedDefaults(properties).find("not given"), std::string::npos
    );
}


TEST(clayProperties, printsTheDefaultsInUseAndNoOther)
{
    const clayProperties properties
    (
        parse("platelet { diameter 3e-7; } water { concentration 1; }")
    );
    const std::string printed = printedDefaults(properties);

    EXPECT_NE(printed.find("thickness"), std::string::npos);
    EXPECT_NE(printed.find("1e-09"), std::string::npos);
    EXPECT_EQ(printed.find("diameter"), std::string::npos);

    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);)
    {
        EXPECT_LT(line.size(), 80u) << line;
    }
}


TEST(clayProperties, parameterSetsDifferInTheirNumbersOnly)
{
    const clayProperties usual(parse(water1));
    const clayProperties KTH(parse("parameterSet KTH;" + water1));
    const clayProperties Kratos(parse("parameterSet Kratos;" + water1));

    EXPECT_EQ(usual.Kozeny(), 5);
    EXPECT_EQ(KTH.Kozeny(), 14.12);
    EXPECT_EQ(Kratos.Kozeny(), 5);
    EXPECT_EQ(KTH.clay().Hamaker, usual.clay().Hamaker);
    EXPECT_EQ(Kratos.clay().Hamaker, 1e-18);
    EXPECT_EQ(Kratos.clay().diameter, usual.clay().diameter);
}


TEST(clayProperties, whatIsGivenWinsOverTheParameterSet)
{
    const clayProperties properties
    (
        parse("parameterSet Kratos; platelet { Hamaker 3e-20; }" + water1)
    );
    EXPECT_EQ(properties.clay().Hamaker, 3e-20);
}


// P0 = 1.5e5 c, kappa = 7.34e7 sqrt(c), distance of centres: the report's
// Fig. 3-4 has 1500 Pa and 7.34e6 1/m at c = 0.01
TEST(clayProperties, KratosSuppliesItsExponentialForce)
{
    const std::string set =
        "parameterSet Kratos; water { concentration 0.01; }";

    const clayProperties Kratos(parse(set));
    const water solution = Kratos.waterAt(0);
    const auto layer = Kratos.newDoubleLayer("exponential", solution);

    EXPECT_LT
    (
        relativeError
        (
            layer->force(9.9e-8),
            1500*Kratos.clay().faceArea()*std::exp(-0.734)
        ),
        1e-13
    );

    // Given entries win
    const auto other = Kratos.newDoubleLayer
    (
        parse("model exponential; P0 3000;"), solution
    );
    EXPECT_LT(relativeError(other->force(1e-7), 2*layer->force(1e-7)), 1e-13);

    // Other sets have no such numbers
    const clayProperties usual(parse(water1));
    EXPECT_THROW(usual.newDoubleLayer("exponential", solution), Foam::error);
}


TEST(clayProperties, concentrationMayBeAFunctionOfTime)
{
    const clayProperties properties
    (
        parse("water { concentration table ((0 10) (100 0.1)); }")
    );

    EXPECT_TRUE(properties.concentrationVaries());
    EXPECT_DOUBLE_EQ(properties.waterAt(0).concentration, 10);
    EXPECT_DOUBLE_EQ(properties.waterAt(50).concentration, 5.05);
    EXPECT_DOUBLE_EQ(properties.waterAt(100).concentration, 0.1);
}


TEST(clayProperties, refusesAConcentrationThatBecomesImpossible)
{
    const clayProperties properties
    (
        parse("water { concentration table ((0 1) (100 -1)); }")
    );

    EXPECT_NO_THROW(properties.waterAt(10));
    EXPECT_THROW(properties.waterAt(90), Foam::error);
}


TEST(clayProperties, namesFileLineAndRangeOfWhatIsImpossible)
{
    expectRefusal
    (
        "water { concentration 0.1; }\nplatelet\n{\n    diameter -2e-7;\n}\n",
        {"diameter", "-2e-07", "1e-09 to 0.0001 m", "clayProperties", "line 4"}
    );
    expectRefusal
    (
        "water { concentration 0.1; }\nplatelet\n{\n    thickness 3e-7;\n}\n",
        {"thickness", "half of the diameter", "line 4"}
    );
    expectRefusal
    (
        "water\n{\n    concentration -0.1;\n}\n",
        {"concentration", "-0.1", "mol/m3", "line 3"}
    );
    expectRefusal("water { concentration 0; }", {"concentration"});
    expectRefusal("water { concentration 1e5; }", {"6100"});
    expectRefusal
    (
        "flocculation { active on; fraction 1.5; }" + water1,
        {"fraction", "to 1 "}
    );
    expectRefusal
    (
        "friction { fraction 1.5; }" + water1, {"fraction", "0.999"}
    );
    expectRefusal
    (
        "water { concentration 0.1; temperature 25; }", {"temperature", "250"}
    );
    expectRefusal
    (
        "platelet { surfaceCharge -0.131; }" + water1, {"surfaceCharge"}
    );
    expectRefusal("platelet { density 0; }" + water1, {"density"});
    expectRefusal("platelet { contactGap 0; }" + water1, {"contactGap"});
    expectRefusal("viscosity { gelViscosity 1; }" + water1, {"gelViscosity"});
}


TEST(clayProperties, refusesToRunWithoutAConcentration)
{
    expectRefusal("", {"concentration", "missing", "mol/m3"});
    expectRefusal("water { valence 1; }", {"concentration", "missing"});
}


TEST(clayProperties, suggestsTheNearestWord)
{
    expectRefusal("plattelet { }" + water1, {"'platelet'?"});
    expectRefusal
    (
        "platelet { Hamacker 1e-20; }" + water1, {"'Hamaker'?"}
    );
    expectRefusal
    (
        "water\n{\n    concentration 0.1;\n    concentratoin 0.2;\n}",
        {"'concentration'?", "line 4"}
    );
    expectRefusal("parameterSet Kartos;" + water1, {"'Kratos'?"});
    expectRefusal
    (
        "friction { model KozenyCarmann; }" + water1, {"'KozenyCarman'?"}
    );
    expectRefusal
    (
        "viscosity { model LiuCovolume; }" + water1, {"'LiuCoVolume'?"}
    );
}


TEST(clayProperties, refusesAConstantFrictionWithoutValue)
{
    expectRefusal("friction { model constant; }" + water1, {"'value'"});
}


TEST(clayProperties, warnsOfAValenceThatIsNotOne)
{
    // Warnings go to one or the other, by OpenFOAM's version
    const auto saidOf = [](const char* text)
    {
        testing::internal::CaptureStderr();
        testing::internal::CaptureStdout();
        const clayProperties properties(parse(text));
        Info<< flush;
        return
            testing::internal::GetCapturedStderr()
          + testing::internal::GetCapturedStdout();
    };
    const std::string warned =
        saidOf("water { concentration 1; valence 2; }");
    const std::string silent =
        saidOf("water { concentration 1; valence 1; }");

    EXPECT_NE(warned.find("calcium"), std::string::npos) << warned;
    EXPECT_EQ(silent, "");
}


namespace
{

// A case of nothing but a controlDict in memory
autoPtr<Time> newTime(const fileName& root)
{
    dictionary control(parse
    (
        "deltaT 1; writeFrequency 1; startFrom startTime; startTime 0;"
        "stopAt endTime; endTime 1;"
    ));

    return autoPtr<Time>::New
    (
        control, root, fileName("case"), word("system"), word("constant"),
        false
    );
}

} // End anonymous namespace


TEST(clayProperties, readsTheCaseAndPrintsTheDefaults)
{
    std::string root
    (
        std::filesystem::temp_directory_path()/"clayPropertiesXXXXXX"
    );
    ASSERT_NE(mkdtemp(root.data()), nullptr);
    mkDir(fileName(root)/"case"/"constant");

    std::ofstream(fileName(root)/"case"/"constant"/"clayProperties")
        << "FoamFile { version 2.0; format ascii; class dictionary;"
        << " object clayProperties; }\n"
        << "water { concentration 0.2; }\n";

    const auto runTime = newTime(root);

    testing::internal::CaptureStdout();
    const clayProperties properties(runTime());
    Info<< flush;
    const std::string printed = testing::internal::GetCapturedStdout();

    EXPECT_EQ(properties.waterAt(0).concentration, 0.2);
    EXPECT_NE(printed.find("Hamaker"), std::string::npos) << printed;

    rmDir(fileName(root));
}


TEST(clayProperties, saysWhatToWriteWhenTheFileIsMissing)
{
    std::string root
    (
        std::filesystem::temp_directory_path()/"clayPropertiesXXXXXX"
    );
    ASSERT_NE(mkdtemp(root.data()), nullptr);
    mkDir(fileName(root)/"case"/"constant");

    const auto runTime = newTime(root);

    try
    {
        clayProperties properties(runTime());
        FAIL() << "no error";
    }
    catch (const Foam::error& err)
    {
        const std::string message(err.message());
        EXPECT_NE
        (
            message.find("constant/clayProperties"), std::string::npos
        ) << message;
        EXPECT_NE(message.find("concentration"), std::string::npos);
    }

    rmDir(fileName(root));
}


// The annotated dictionary is valid, complete and shows the true defaults
TEST(clayProperties, annotatedDictionaryIsTheDefault)
{
    const char* home = std::getenv("BENTOFOAM_DIR");
    ASSERT_NE(home, nullptr);

    IFstream file(fileName(home)/"etc"/"caseDicts"/"clayProperties");
    ASSERT_TRUE(file.good());

    const dictionary annotated(file);
    const clayProperties properties(annotated);
    const clayProperties usual(parse(water1));

    EXPECT_EQ
    (
        printedDefaults(properties).find("not given"), std::string::npos
    ) << printedDefaults(properties);

    for (const char* section : {"friction", "viscosity", "flocculation"})
    {
        for (const entry& e : usual.dict().subDict(section))
        {
            OStringStream ours, theirs;
            ours << e.stream();
            theirs << properties.dict().subDict(section)
                .lookup(e.keyword());

            EXPECT_EQ(ours.str(), theirs.str()) << e.keyword();
        }
    }

    EXPECT_NEAR(properties.clay().Hamaker/usual.clay().Hamaker, 1, 2e-6);
    EXPECT_EQ(properties.clay().diameter, usual.clay().diameter);
    EXPECT_EQ(properties.clay().thickness, usual.clay().thickness);
    EXPECT_EQ(properties.clay().density, usual.clay().density);
    EXPECT_EQ(properties.clay().surfaceCharge, usual.clay().surfaceCharge);
    EXPECT_EQ(properties.clay().contactGap, usual.clay().contactGap);
    EXPECT_EQ
    (
        properties.waterAt(0).temperature, usual.waterAt(0).temperature
    );
    EXPECT_EQ(properties.waterAt(0).valence, usual.waterAt(0).valence);
    EXPECT_EQ(properties.waterAt(0).viscosity, usual.waterAt(0).viscosity);
    EXPECT_EQ(properties.waterAt(0).density, usual.waterAt(0).density);
    EXPECT_EQ
    (
        properties.waterAt(0).relativePermittivity,
        usual.waterAt(0).relativePermittivity
    );
}


// ************************************************************************* //
