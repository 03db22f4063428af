/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    engineBenchmark

Description
    Times the engine (plateletDynamics) alone, without mesh and cloud: platelets
    in a periodic cube, explicit Euler steps. Units: spacing d at the solid
    fraction 0.01, force F(d), friction 1.

    Prints a line per repeat of words and values: the wall time of a step over
    the number of platelets (nanoseconds; all ranks together, not summed),
    rebuilds of the lists, entries of the lists per platelet, neighbours within
    the cut-off, the skin, shares of lists and forces in the time, and the
    memory that the engine added to the process, bytes per platelet. Writes
    forces and places for LAMMPS; see ../peer.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "benchmarkForce.H"
#include "benchmarkPlaces.H"
#include "engine.H"
#include "PstreamReduceOps.H"
#include "taperedForce.H"

#include <chrono>
#include <cstdio>
#include <fstream>

#include <sys/resource.h>

using namespace Foam;
using namespace plateletDynamics;

//- Largest memory that this process has had so far [bytes]
double peakMemory()
{
    rusage use;
    getrusage(RUSAGE_SELF, &use);
    return 1024.0*use.ru_maxrss;
}


//- The engine's force as a table of LAMMPS (pair_style table), equidistant in
//  the square of the distance
void writeTable
(
    const fileName& file,
    const taperedForce& force,
    const benchmarkForce& units
)
{
    const int n = 20001;
    const double begin = 0.1;
    const double end = force.cutOff();
    const auto distance = [&](int i)
    {
        return std::sqrt(begin*begin + (end*end - begin*begin)*i/(n - 1));
    };
    const auto forceAt = [&](double r)
    {
        return force.force(r - force.thickness());
    };

    // LAMMPS takes the force as it stands; the energy, by Simpson's rule from
    // the cut-off inwards, is only for its output
    std::vector<double> energy(n, 0);
    for (int i = n - 2; i >= 0; --i)
    {
        const double a = distance(i);
        const double b = distance(i + 1);
        energy[i] = energy[i + 1]
          + (b - a)/6*(forceAt(a) + 4*forceAt((a + b)/2) + forceAt(b));
    }

    std::ofstream os(file);
    os.precision(15);
    os  << "# units: length " << units.spacing() << " m, force " << units.unit()
        << " N\n\nbentoFoam\nN " << n << " RSQ " << begin << ' ' << end
        << "\n\n";
    for (int i = 0; i < n; ++i)
    {
        os  << i + 1 << ' ' << distance(i) << ' ' << energy[i] << ' '
            << forceAt(distance(i)) << '\n';
    }
    if (!os)
    {
        FatalErrorInFunction << "Cannot write " << file << exit(FatalError);
    }
}


//- The engine's settings of the options
engineSettings settingsFrom(const argList& args, const benchmarkForce& force)
{
    const word kernel(args.getOrDefault<word>("kernel", "fast"));

    if (kernel != "exact" && kernel != "table" && kernel != "fast")
    {
        FatalErrorInFunction
            << "Unknown kernel " << kernel << ": fast, table or exact"
            << exit(FatalError);
    }

    engineSettings settings;
    settings.thickness = force.thickness();
    settings.cutOff = args.getOrDefault<scalar>("cutOff", 2.5);
    settings.spacing = 1;
    settings.skin = args.getOrDefault<scalar>("skin", 0);
    settings.integrator = "Euler";
    settings.deltaT = args.getOrDefault<scalar>("deltaT", 0.01);
    settings.pairKernel =
        kernel == "exact"
      ? engineSettings::kernel::exact
      : kernel == "table"
      ? engineSettings::kernel::table
      : engineSettings::kernel::fast;
    settings.instructions = args.getOrDefault<word>("instructions", "best");

    return settings;
}


//- Steps of the engine, with new lists after each stride. Returns the wall time
//  of the slowest rank [s]
double timeSteps
(
    engine& clay,
    const label steps,
    const label stride,
    const double deltaT
)
{
    using clock = std::chrono::steady_clock;

    // All ranks begin together
    returnReduce(steps, sumOp<label>());
    const auto begun = clock::now();

    for (label done = 0; done < steps; done += stride)
    {
        if (stride < steps)
        {
            clay.listsExpire();
        }
        clay.advance(min(stride, steps - done)*deltaT);
    }

    return returnReduce
    (
        std::chrono::duration<double>(clock::now() - begun).count(),
        maxOp<scalar>()
    );
}


double sum(const double x)
{
    return returnReduce(x, sumOp<scalar>());
}


int main(int argc, char *argv[])
{
    argList::addNote("Time of the engine alone, per platelet and step");
    argList::noBanner();
    argList::noCheckProcessorDirectories();

    argList::addOption("number", "N", "Platelets at random places (10000)");
    argList::addOption("positions", "file", "Places as a data file of LAMMPS");
    argList::addOption("cutOff", "d", "Where the force ends (2.5)");
    argList::addOption("skin", "d", "Of the lists (0: the engine's choice)");
    argList::addOption("kernel", "name", "fast | table | exact (fast)");
    argList::addOption("instructions", "name", "best | AVX-512 | AVX2 | SSE4 | ... (best)");
    argList::addOption("deltaT", "time", "Step of the engine (0.01)");
    argList::addOption("rebuildEvery", "S", "New lists every S steps at least");
    argList::addOption("warmUp", "S", "Steps before the clock runs (200)");
    argList::addOption("steps", "S", "Steps of each repeat (100)");
    argList::addOption("repeats", "R", "How often these are timed (1)");
    argList::addOption("writeTable", "file", "Force for LAMMPS");
    argList::addOption("writeData", "file", "Places at the end, for LAMMPS");
    argList::addOption("writePositions", "file", "id x y z at the end");

    const argList args(argc, argv);

    const label steps = args.getOrDefault<label>("steps", 100);
    const label stride = args.getOrDefault<label>("rebuildEvery", steps);
    const label warmUp = args.getOrDefault<label>("warmUp", 200);
    const label repeats = args.getOrDefault<label>("repeats", 1);

    const auto force = std::make_shared<benchmarkForce>();
    const engineSettings settings(settingsFrom(args, *force));

    if (args.found("writeTable") && Pstream::master())
    {
        writeTable
        (
            args["writeTable"],
            taperedForce(force, settings.thickness, settings.cutOff),
            *force
        );
    }

    const bool fromFile = args.found("positions");
    const label number =
        fromFile
      ? benchmarkPlaces::numberIn(args["positions"])
      : args.getOrDefault<label>("number", 10000);

    platelets places
    (
        fromFile
      ? benchmarkPlaces::read(args["positions"])
      : benchmarkPlaces::random(number)
    );
    const double memory = peakMemory();

    try
    {
        engine clay
        (
            benchmarkPlaces::cube(number),
            boundarySurface(),
            force,
            settings,
            Pstream::parRun() ? MPI_COMM_WORLD : MPI_COMM_SELF
        );
        clay.load(std::move(places));
        clay.advance(warmUp*settings.deltaT);

        const scalar inRange = benchmarkPlaces::neighboursInRange
        (
            number, clay.local(), settings.cutOff
        );

        for (label repeat = 1; repeat <= repeats; ++repeat)
        {
            const engineCounters before(clay.counters());
            const double seconds =
                timeSteps(clay, steps, stride, settings.deltaT);
            const engineCounters after(clay.counters());

            const double perRank = 1/seconds/Pstream::nProcs();
            const double lists = sum(after.listSeconds - before.listSeconds);
            const double forces = sum(after.forceSeconds - before.forceSeconds);
            const double lanes = 2*sum(after.listedPairs)/number;
            const double bytes = sum(peakMemory() - memory)/number;

            if (Pstream::master())
            {
                std::printf
                (
                    "number %d ranks %d instructions %s kernel %s repeat %d"
                    " nsPerParticleStep %.4g rebuilds %d lanes %.1f"
                    " inRange %.1f skin %.3g listShare %.3f forceShare %.3f"
                    " bytesPerPlatelet %.0f\n",
                    int(number), Pstream::nProcs(),
                    settings.instructions.c_str(),
                    args.getOrDefault<word>("kernel", "fast").c_str(),
                    int(repeat), seconds*1e9/number/steps,
                    int(after.rebuilds - before.rebuilds), lanes, inRange,
                    clay.skin(), lists*perRank, forces*perRank, bytes
                );
            }
        }

        if (args.found("writeData"))
        {
            benchmarkPlaces::writeData(args["writeData"], number, clay.local());
        }
        if (args.found("writePositions"))
        {
            benchmarkPlaces::writeUnwrapped
            (
                args["writePositions"], number, clay.local()
            );
        }
    }
    catch (const userError& error)
    {
        FatalErrorInFunction << error.what() << exit(FatalError);
    }

    return 0;
}
