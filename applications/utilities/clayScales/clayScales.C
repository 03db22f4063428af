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
#include "IOdictionary.H"
#include "Time.H"

#include <fstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The numbers of an option, each above lower and below upper. FatalError
//  otherwise
static scalarList numbersOf
(
    const argList& args,
    const word& option,
    const scalar lower,
    const scalar upper,
    const scalarList& defaults
)
{
    if (!args.found(option))
    {
        return defaults;
    }

    const scalarList numbers(args.getList<scalar>(option));

    if (numbers.empty())
    {
        FatalErrorInFunction
            << "Option -" << option << " has no numbers" << nl
            << exit(FatalError);
    }

    for (const scalar number : numbers)
    {
        if (!(number > lower && number < upper))
        {
            FatalErrorInFunction
                << "Option -" << option << ": " << number << nl
                << "Valid: above " << lower << " and below " << upper << nl
                << exit(FatalError);
        }
    }

    return numbers;
}


//- The one number of an option, likewise
static scalar numberOf
(
    const argList& args,
    const word& option,
    const scalar lower,
    const scalar upper,
    const scalar defaultValue
)
{
    const scalarList numbers
    (
        numbersOf(args, option, lower, upper, {defaultValue})
    );

    if (numbers.size() != 1)
    {
        FatalErrorInFunction
            << "Option -" << option << " takes one number" << nl
            << exit(FatalError);
    }

    return numbers[0];
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
    argList::addOption("csv", "file", "Write the laws, a row per gap/fraction");
    argList::addOption("gap", "list", "Gaps of -csv [m], e.g. '(1e-9 1e-8)'");
    argList::addOption
    (
        "fraction", "list", "Solid fractions, default '(0.001 0.005 0.01)'"
    );
    argList::addOption("length", "Lx", "Of the rim [m], default 0.01");
    argList::addOption("velocity", "u0", "Of the water [m/s], default 1e-5");
    argList::addOption
    (
        "secondsPerParticleStep", "s", "What a step costs [s], default 1e-6"
    );

    argList args(argc, argv);

    if (!args.checkRootCase())
    {
        FatalError.exit();
    }

    const scalarList gaps(numbersOf(args, "gap", 0, 1, scalarList()));
    const scalarList fractions
    (
        numbersOf(args, "fraction", 0, 1, {0.001, 0.005, 0.01})
    );
    scaleTable::run run
    {
        numberOf(args, "length", 0, GREAT, 0.01),
        numberOf(args, "velocity", 0, GREAT, 1e-5),
        0,
        numberOf(args, "secondsPerParticleStep", 0, GREAT, 1e-6)
    };

    Time runTime(Time::controlDictName, args);

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
            args.found("fraction") || gaps.empty() ? fractions : scalarList()
        );
    }
    else
    {
        scaleTable(properties, water, model, run).write(Info, fractions);
    }

    return 0;
}


// ************************************************************************* //
