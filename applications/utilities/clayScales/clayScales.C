/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    clayScales

Description
    Prints what a case is about before it is run: the laws at its
    concentration, its scales, and what it would cost. Needs constant/ and
    system/controlDict, no mesh.

    Optionally writes the laws as comma-separated values:

        clayScales -csv laws.csv -gap '(1e-9 1e-8)' -fraction '(0.01 0.1)'
\*---------------------------------------------------------------------------*/

#include "lawTable.H"
#include "scaleTable.H"

#include "argList.H"
#include "checkControls.H"
#include "dictionaryText.H"
#include "IOdictionary.H"
#include "logDigits.H"
#include "sigFpe.H"
#include "stringOps.H"
#include "Time.H"

#include <cmath>
#include <fstream>
#include <sstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- What an option's numbers may be: above lower, below upper, one or a list
struct numericOption
{
    word name;
    word unit;
    scalar lower;
    scalar upper;
    bool list;
};


//- FatalError: what is wrong with an option's value, and what would be right
static void refuse
(
    const numericOption& option,
    const string& value,
    const string& problem
)
{
    FatalErrorInFunction
        << "Option -" << option.name << " '" << value.c_str() << "': "
        << problem.c_str() << nl
        << "Valid: numbers above " << option.lower << " and below "
        << option.upper << " [" << option.unit << "]"
        << (option.list ? ", more than one in brackets" : ", one") << nl
        << exit(FatalError);
}


//- The numbers of an option, 'number' or '(number ...)', the defaults without
//  it. FatalError if there are none, or if something else is among them
static scalarList numbersOf
(
    const argList& args,
    const numericOption& option,
    const scalarList& defaults
)
{
    if (!args.found(option.name))
    {
        return defaults;
    }

    const string value(args[option.name]);
    const bool opens = value.find('(') != string::npos;
    const bool closes = value.find(')') != string::npos;
    string inside(stringOps::trim(value));

    if (opens || closes)
    {
        if
        (
            inside.front() != '(' || inside.back() != ')'
         || inside.find('(', 1) != string::npos
         || inside.find(')') != inside.size() - 1
        )
        {
            refuse(option, value, "not a list in one pair of brackets");
        }

        inside = inside.substr(1, inside.size() - 2);
    }

    // What is too large for a double must not end in a stack trace
    const sigFpe::ignore noTraps;

    DynamicList<scalar> numbers;
    std::istringstream words(inside);

    for (std::string word; words >> word;)
    {
        scalar number;

        if (!readScalar(word, number) || !std::isfinite(number))
        {
            refuse(option, value, word + " is not a number");
        }
        if (number <= option.lower)
        {
            refuse(option, value, word + " is too small");
        }
        if (number >= option.upper)
        {
            refuse(option, value, word + " is too large");
        }

        numbers.append(number);
    }

    if (numbers.empty())
    {
        refuse(option, value, "no numbers");
    }
    if (numbers.size() > 1 && !option.list)
    {
        refuse(option, value, "takes one number");
    }
    if (numbers.size() > 1 && !opens)
    {
        refuse(option, value, "several numbers without brackets");
    }

    return scalarList(numbers);
}


//- constant/clayCloudProperties, empty if there is no such file
static dictionary cloudProperties(const Time& runTime)
{
    IOobject io
    (
        "clayCloudProperties",
        runTime.constant(),
        runTime,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    return
        io.typeHeaderOk<IOdictionary>(true)
      ? dictionary(IOdictionary(io))
      : dictionary();
}


//- FatalError if the file cannot be written
static void writeLaws
(
    const fileName& path,
    const lawTable& laws,
    const UList<scalar>& gaps,
    const UList<scalar>& fractions
)
{
    std::ofstream file(path);
    laws.write(file, gaps, fractions);
    file.close();

    if (!file)
    {
        FatalErrorInFunction
            << "Cannot write " << path << nl << exit(FatalError);
    }

    Info<< "Wrote " << gaps.size() + fractions.size() << " rows to " << path
        << nl << endl;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Print laws, scales and expected cost of a case. Needs no mesh"
    );
    argList::noParallel();
    argList::addOption
    (
        "csv", "file", "Write the laws, a row per -gap and per -fraction"
    );
    argList::addOption("gap", "list", "Gaps of -csv [m], e.g. '(1e-9 1e-8)'");
    argList::addOption
    (
        "fraction", "list", "Solid fractions, default '(0.001 0.005 0.01)'"
    );
    argList::addOption("length", "Lx", "Of the rim [m], default 0.01");
    argList::addOption("velocity", "u0", "Of the water [m/s], default 1e-5");
    argList::addOption
    (
        "secondsPerParticleStep", "s", "What a step costs [s], default 1e-6 (TR-17-13)"
    );

    argList args(argc, argv);

    if (!args.checkRootCase())
    {
        FatalError.exit();
    }
    colloid::dictionaryText::checkCase();

    if (args.found("gap") && !args.found("csv"))
    {
        FatalErrorInFunction
            << "Option -gap needs -csv FILE, the file it writes a row per gap"
            << " to" << nl << exit(FatalError);
    }
    if (args.found("csv") && !args.found("gap") && !args.found("fraction"))
    {
        FatalErrorInFunction
            << "Option -csv needs -gap LIST or -fraction LIST, or both: a row"
            << " is written for each" << nl << exit(FatalError);
    }

    // From 1e-25 m on, the gap's solid fraction is 1 to all digits
    const scalarList gaps
    (
        numbersOf(args, {"gap", "m", 1e-15, 1, true}, {})
    );
    const scalarList fractions
    (
        numbersOf
        (
            args,
            {"fraction", "-", 0, 1, true},
            args.found("csv") ? scalarList() : scalarList{0.001, 0.005, 0.01}
        )
    );

    const auto positive =
    [&](const word& option, const word& unit, const scalar defaultValue)
    {
        return numbersOf
        (
            args, {option, unit, 0, GREAT, false}, {defaultValue}
        )[0];
    };
    scaleTable::run run
    {
        positive("length", "m", 0.01),
        positive("velocity", "m/s", 1e-5),
        0,
        positive("secondsPerParticleStep", "s", 1e-6)
    };

    checkControls(args);
    Time runTime(Time::controlDictName, args);
    setLogDigits();

    const colloid::clayProperties properties(runTime);
    const colloid::water water(properties.waterAt(runTime.value()));

    const dictionary cloud(cloudProperties(runTime));
    const dictionary model(cloud.subOrEmptyDict("doubleLayer"));
    run.tolerance =
        cloud.subOrEmptyDict("solution").getOrDefault("tolerance", 1e-2);

    if (properties.concentrationVaries())
    {
        Info<< "The concentration varies: all is for time "
            << runTime.value() << " s" << nl;
    }

    if (args.found("csv"))
    {
        writeLaws
        (
            args.get<fileName>("csv"),
            lawTable(properties, water, model),
            gaps,
            fractions
        );
    }
    else
    {
        scaleTable(properties, water, model, run).write(Info, fractions);
    }

    return 0;
}


// ************************************************************************* //
