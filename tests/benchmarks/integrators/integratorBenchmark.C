/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    integratorBenchmark

Description
    How many evaluations of the forces an integrator needs for an accuracy.
    Clay at the solid fraction 0.01 in water of 0.1 mol/m3, constant friction,
    cut-off 2.5 spacings, without Brownian motion, starts on a lattice with
    random displacements of up to a tenth of the spacing and expands:

        block   10 x 10 x 10, to 8 times its volume; error: the farthest that a
                platelet is from its place, over the spacing
        ball    20 x 20 x 20, likewise; error of the radius of gyration
        slab    6 x 6 x 40 (periodic in y and z) between a wall and space, until
                the density at the wall has halved; error of that density
        chain   200 layers, likewise

    Against a run with a tolerance of 1e-6. Adams-Bashforth 2 is not run but
    counted: with the largest step that is stable from the start on, 0.95/rho,
    and with that of each moment. Units: spacing, force at the spacing, friction.

    integratorBenchmark [-case NAME] [-integrator NAME] [-tolerance X]
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "benchmarkForce.H"
#include "engine.H"

#include <cstdio>
#include <functional>
#include <memory>
#include <random>

using namespace Foam;
using namespace plateletDynamics;

//- A case, and what is looked at in it
struct expansion
{
    std::array<int, 3> number;
    periodicBox space;

    //- The first platelet of the chain and the first layer of the slab stay
    bool hasWall;

    //- Observed; the end has come when the first of it is so many times what
    //  it was
    std::function<std::vector<double>(const std::vector<vector>&)> observe;
    double end;

    //- The error that is asked for: relative, or of any observed in spacings
    bool isRelative;
    double accuracy;
};


platelets start(const expansion& chosen)
{
    std::mt19937 numbers(1);
    const auto random = [&]{ return 0.2*(numbers()/4294967296.0 - 0.5); };
    const bool isChain = chosen.number[1] == 1;

    platelets all;
    int tag = 0;
    for (int i = 0; i < chosen.number[0]; ++i)
    for (int j = 0; j < chosen.number[1]; ++j)
    for (int k = 0; k < chosen.number[2]; ++k)
    {
        const bool fixed = chosen.hasWall && i == 0;
        vector x(i, j, k);
        if (!fixed)
        {
            x[0] += random();
            x[1] += isChain ? 0 : random();
            x[2] += isChain ? 0 : random();
        }
        all.append(tag, x);
        all.tag.back() = tag++;
        all.fixed.back() = fixed;
    }
    return all;
}


std::vector<vector> placesByTag(const engine& clay)
{
    std::vector<vector> places(clay.local().size());
    for (std::size_t k = 0; k < places.size(); ++k)
    {
        places[clay.local().tag[k]] = clay.local().position[k];
    }
    return places;
}


double radiusOfGyration(const std::vector<vector>& places)
{
    vector centre(vector::Zero());
    for (const vector& x : places)
    {
        centre += x/double(places.size());
    }
    double square = 0;
    for (const vector& x : places)
    {
        square += (x - centre).squaredNorm()/double(places.size());
    }
    return std::sqrt(square);
}


//- The mean height of the first layer above the wall: the inverse of the
//  density there
double firstGap(const std::vector<vector>& places, int inLayer)
{
    double sum = 0;
    for (int k = inLayer; k < 2*inLayer; ++k)
    {
        sum += places[k][0]/inLayer;
    }
    return sum;
}


expansion caseOf(const word& name)
{
    const auto gyration = [](const std::vector<vector>& places)
    {
        return std::vector<double>{radiusOfGyration(places)};
    };
    const auto gap = [](int inLayer)
    {
        return [inLayer](const std::vector<vector>& places)
        {
            return std::vector<double>{firstGap(places, inLayer)};
        };
    };

    if (name == "block")
    {
        const auto all = [](const std::vector<vector>& places)
        {
            std::vector<double> seen{radiusOfGyration(places)};
            for (const vector& x : places)
            {
                seen.insert(seen.end(), x.data(), x.data() + 3);
            }
            return seen;
        };
        return {{10, 10, 10}, {}, false, all, 2, false, 0.01};
    }
    if (name == "ball")
    {
        return {{20, 20, 20}, {}, false, gyration, 2, true, 0.01};
    }
    if (name == "slab")
    {
        periodicBox space;
        space.upper.setConstant(6);
        space.periodic = {false, true, true};
        return {{40, 6, 6}, space, true, gap(36), 2, true, 0.03};
    }
    if (name == "chain")
    {
        return {{200, 1, 1}, {}, true, gap(1), 2, true, 0.01};
    }
    FatalErrorInFunction
        << "Unknown case " << name << ": block, ball, slab, chain"
        << exit(FatalError);
    return {};
}


std::unique_ptr<engine> engineFor
(
    const expansion& chosen,
    const word& integrator,
    const double tolerance
)
{
    const auto force = std::make_shared<benchmarkForce>();

    engineSettings settings;
    settings.thickness = force->thickness();
    settings.cutOff = 2.5;
    settings.spacing = 1;
    settings.integrator = integrator;
    settings.stepTolerance = tolerance;
    settings.pairKernel = engineSettings::kernel::table;
    settings.tableTolerance = 1e-8;

    auto clay = std::make_unique<engine>
    (
        chosen.space, boundarySurface(), force, settings, MPI_COMM_SELF
    );
    clay->load(start(chosen));
    return clay;
}


double errorOf
(
    const expansion& chosen,
    const std::vector<double>& seen,
    const std::vector<double>& right
)
{
    double most = 0;
    for (std::size_t i = 0; i < seen.size(); ++i)
    {
        most = std::max
        (
            most,
            std::abs(seen[i] - right[i])/(chosen.isRelative ? right[i] : 1)
        );
    }
    return most;
}


void run(const word& name, const word& integrator, const double asked)
{
    const expansion chosen(caseOf(name));

    // The reference, until the end has come
    const auto tight = engineFor(chosen, "RKC2", 1e-6);
    const double rate = tight->stiffness();
    const double begin = chosen.observe(placesByTag(*tight))[0];

    double duration = 0;
    double fixed = 0;
    double adapted = 0;
    std::vector<double> right;
    do
    {
        const double interval = std::max(0.02*duration, 1/rate);
        adapted += interval*tight->stiffness()/0.95;
        fixed += interval*rate/0.95;
        tight->advance(interval);
        duration += interval;
        right = chosen.observe(placesByTag(*tight));
    }
    while (right[0] < chosen.end*begin);

    std::printf
    (
        "%s: duration %.4g, AdamsBashforth2 fixed %.4g evaluations, adapted"
        " %.4g\n",
        name.c_str(), duration, fixed, adapted
    );

    // The loosest tolerance that is accurate enough, or the one asked for
    for
    (
        double tolerance = asked > 0 ? asked : 10;
        tolerance > 1e-6;
        tolerance /= 2
    )
    {
        const auto clay = engineFor(chosen, integrator, tolerance);
        clay->advance(duration);
        const auto& count = clay->counters();
        const double evaluations =
            count.evaluations + count.stiffnessEvaluations;
        const double missed =
            errorOf(chosen, chosen.observe(placesByTag(*clay)), right);

        std::printf
        (
            "%s %s tolerance %.2g error %.2g (asked %.2g) evaluations %.0f of"
            " them stiffness %.0f steps %.0f fewer than fixed %.4g adapted"
            " %.4g\n",
            name.c_str(), integrator.c_str(), tolerance, missed,
            chosen.accuracy, evaluations, double(count.stiffnessEvaluations),
            double(count.steps), fixed/evaluations, adapted/evaluations
        );
        std::fflush(stdout);
        if (asked > 0 || missed <= chosen.accuracy)
        {
            break;
        }
    }
}


int main(int argc, char *argv[])
{
    argList::addNote("Evaluations of the forces for an accuracy");
    argList::noBanner();
    argList::noParallel();
    argList::noCheckProcessorDirectories();
    argList::addOption("case", "name", "block | ball | slab | chain (all)");
    argList::addOption("integrator", "name", "auto | RKC2 | BogackiShampine (auto)");
    argList::addOption("tolerance", "x", "of a step (the loosest that will do)");
    const argList args(argc, argv);

    try
    {
        const word integrator
        (
            args.getOrDefault<word>("integrator", "auto")
        );
        const scalar tolerance = args.getOrDefault<scalar>("tolerance", 0);

        for
        (
            const word& name
          : args.found("case")
          ? wordList{args.get<word>("case")}
          : wordList{"block", "chain", "slab", "ball"}
        )
        {
            run(name, integrator, tolerance);
        }
    }
    catch (const userError& error)
    {
        FatalErrorInFunction << error.what() << exit(FatalError);
    }
    return 0;
}
