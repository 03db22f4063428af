/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Random motion against statistical mechanics, each within four standard
    errors, with units in which neither kT nor friction is 1.
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"

#include <gtest/gtest.h>

namespace
{

constexpr double kT = 0.3;
constexpr double xi = 1.7;

engineSettings settings(double deltaT)
{
    engineSettings chosen;
    chosen.cutOff = 1;
    chosen.integrator = "auto";
    chosen.thermalEnergy = kT;
    chosen.seed = 5;
    chosen.deltaT = deltaT;
    return chosen;
}


//- Without forces, spread over a cube
platelets freeOnes(int count, double edge)
{
    platelets all(scatter(count, vector::Constant(edge)));
    all.friction.assign(count, xi);
    return all;
}


std::vector<vector> positions(const engine& system, std::size_t count)
{
    return gather(system.local(), system.local().position, count);
}


//- A spring without length: a harmonic well around a fixed platelet
struct well
:
    noForce
{
    static constexpr double stiffness = 2;

    double force(double gap) const override
    {
        return -stiffness*gap;
    }

    double slope(double) const override
    {
        return -stiffness;
    }
};


//- Mean square along an axis of the distance from the well, over kT/stiffness,
//  for a step times rate of decay; 120 000 values that hardly know each other
double varianceInWells(double stepTimesRate)
{
    constexpr int wells = 400;
    const double deltaT = stepTimesRate*xi/well::stiffness;
    platelets all;
    for (int k = 0; k < wells; ++k)
    {
        const vector centre(300*k, 0, 0);
        all.append(2*k, centre);
        all.fixed.back() = 1;
        all.tag.back() = 2*k;
        all.append(2*k + 1, centre + vector(0.1, 0.2, 0.3));
        all.friction.back() = xi;
        all.tag.back() = 2*k + 1;
    }

    engineSettings chosen(settings(deltaT));
    chosen.cutOff = 100;
    chosen.pairKernel = engineSettings::kernel::exact;
    engine system
    (
        periodicBox(), {}, std::make_shared<well>(), chosen, MPI_COMM_WORLD
    );
    system.load(share(all));
    system.advance(20*deltaT);

    double sum = 0;
    constexpr int samples = 100;
    for (int sample = 0; sample < samples; ++sample)
    {
        system.advance(8*deltaT);
        const auto x = positions(system, all.size());
        for (int k = 0; k < wells; ++k)
        {
            sum += (x[2*k + 1] - x[2*k]).squaredNorm();
        }
    }
    return sum/(3*samples*wells)*well::stiffness/kT;
}

} // End namespace


TEST(brownian, freePlateletsMoveBySixDT)
{
    constexpr int count = 4000;
    const platelets all(freeOnes(count, 40));
    engine system
    (
        periodicBox(), {}, std::make_shared<noForce>(), settings(0.02),
        MPI_COMM_WORLD
    );
    system.load(share(all));

    // From the first step on
    double time = 0;
    for (const double duration : {0.02, 0.02, 0.5})
    {
        system.advance(duration);
        time += duration;

        double sum = 0;
        vector mean = vector::Zero();
        const auto x = positions(system, count);
        for (int k = 0; k < count; ++k)
        {
            sum += (x[k] - all.position[k]).squaredNorm();
            mean += (x[k] - all.position[k])/count;
        }
        const double perAxis = 2*kT/xi*time;

        EXPECT_NEAR(sum/(3*count)/perAxis, 1, 4*std::sqrt(2.0/(3*count)));
        EXPECT_LT(mean.norm()/std::sqrt(3*perAxis), 4/std::sqrt(1.0*count));
    }
}


TEST(brownian, varianceInAWellIsExactForLongSteps)
{
    // Values 8 steps apart do not know each other; Euler's would be 1.33 and 2
    const double standardError = std::sqrt(2.0/120000);

    EXPECT_NEAR(varianceInWells(0.5), 1, 4*standardError);
    EXPECT_NEAR(varianceInWells(1), 1, 4*standardError);
}


TEST(brownian, weightIsHeldAgainstDiffusion)
{
    if (nRanks() > 1)
    {
        GTEST_SKIP() << "Statistics of a path that is the same on one rank:"
            << " isTheSameOnAnyNumberOfRanks";
    }

    // Above a floor the density falls as exp(-z weight/kT)
    constexpr int count = 2000;
    constexpr double weight = 0.6;
    constexpr double height = kT/weight;

    platelets all(freeOnes(count, 10));
    for (int k = 0; k < count; ++k)
    {
        all.position[k][2] = -height*std::log((k + 0.5)/count);
    }
    boundarySurface floor;
    addSheet
    (
        floor, vector(-1, -1, 0), vector(12, 0, 0), vector(0, 12, 0),
        action::reflect
    );
    periodicBox space(cube(10, true, true, false));

    engineSettings chosen(settings(0));
    chosen.bodyForce = vector(0, 0, -weight);
    chosen.thermalStep = 0.1*height;
    chosen.spacing = 10;
    engine system
    (
        space, floor, std::make_shared<noForce>(), chosen, MPI_COMM_WORLD
    );
    system.load(share(all));

    // Values a time of relaxation apart
    const double relaxation = 4*xi*height/weight;
    double sum = 0;
    double squares = 0;
    constexpr int samples = 5;
    for (int sample = 0; sample < samples; ++sample)
    {
        system.advance(relaxation);
        for (const vector& x : positions(system, count))
        {
            ASSERT_GE(x[2], -1e-9);
            sum += x[2]/height;
            squares += x[2]*x[2]/(height*height);
        }
    }
    const double n = count*samples;

    // Means 1 and 2 of the exponential distribution, variances 1 and 20
    EXPECT_NEAR(sum/n, 1, 4/std::sqrt(n));
    EXPECT_NEAR(squares/n, 2, 4*std::sqrt(20/n));
}


TEST(brownian, freePlateletsStayUniformWhereFrictionVaries)
{
    if (nRanks() > 1)
    {
        GTEST_SKIP() << "Statistics of a path that is the same on one rank:"
            << " isTheSameOnAnyNumberOfRanks";
    }

    // Mobility (1 + 0.8 sin(2 pi x))/xi on a period of 1
    constexpr int count = 4096;
    constexpr double pi = 3.14159265358979323846;
    platelets all(freeOnes(count, 1));
    for (int k = 0; k < count; ++k)
    {
        all.position[k] = vector((k + 0.5)/count, 3*(k % 64), 3*(k/64));
    }
    all.mobilitySlope.assign(count, vector::Zero());
    periodicBox space(cube(1, true, false, false));

    engineSettings chosen(settings(0));
    chosen.cutOff = 0.4;
    chosen.spacing = 10;
    chosen.thermalStep = 0.03;
    engine system
    (
        space, {}, std::make_shared<noForce>(), chosen, MPI_COMM_WORLD
    );
    system.load(share(all));

    // As the cloud does, friction anew after some steps
    constexpr int samples = 60;
    double sine = 0;
    double cosine = 0;
    for (int sample = 0; sample < samples; ++sample)
    {
        for (int part = 0; part < 5; ++part)
        {
            platelets& local = system.local();
            for (std::size_t k = 0; k < local.size(); ++k)
            {
                const double angle = 2*pi*local.position[k][0];
                const double mobility = 1 + 0.8*std::sin(angle);
                local.friction[k] = xi/mobility;
                local.mobilitySlope[k] =
                    vector(2*pi*0.8*std::cos(angle)/mobility, 0, 0);
            }
            system.advance(2e-3*xi/kT);
        }
        for (const vector& x : positions(system, count))
        {
            sine += std::sin(2*pi*x[0]);
            cosine += std::cos(2*pi*x[0]);
        }
    }

    // The slowest mode decays in about 0.03 xi/kT, so that the values of the 60
    // times, 0.01 xi/kT apart, are worth a third of them at the least
    const double standardError = 1/std::sqrt(2.0*count*samples/6);

    EXPECT_NEAR(sine/(count*samples), 0, 4*standardError);
    EXPECT_NEAR(cosine/(count*samples), 0, 4*standardError);
}


TEST(brownian, pairsAreAtEachDistanceAsOftenAsBoltzmannSays)
{
    if (nRanks() > 1)
    {
        GTEST_SKIP() << "Statistics of a path that is the same on one rank:"
            << " isTheSameOnAnyNumberOfRanks";
    }

    constexpr int count = 400;
    constexpr double edge = 27;
    constexpr double range = 1.2;
    const double thermal = 0.1;

    platelets all(freeOnes(count, edge));
    engineSettings chosen(settings(0));
    chosen.cutOff = 3;
    chosen.spacing = 1;
    chosen.thermalEnergy = thermal;
    chosen.thermalStep = 0.1;
    engine system
    (
        cube(edge), {}, std::make_shared<repulsion>(), chosen, MPI_COMM_WORLD
    );
    system.load(share(all));
    system.advance(3*xi/thermal);

    // Pairs nearer than the range, in six shells
    constexpr int shells = 6;
    std::vector<double> found(shells, 0);
    constexpr int samples = 1500;
    for (int sample = 0; sample < samples; ++sample)
    {
        system.advance(0.1*xi/thermal);
        const auto x = positions(system, count);
        for (int i = 0; i < count; ++i)
        {
            for (int j = 0; j < i; ++j)
            {
                vector d(x[i] - x[j]);
                for (int axis = 0; axis < 3; ++axis)
                {
                    d[axis] -= edge*std::round(d[axis]/edge);
                }
                if (d.squaredNorm() < range*range)
                {
                    ++found[int(d.norm()/range*shells)];
                }
            }
        }
    }

    for (int shell = 0; shell < shells; ++shell)
    {
        double expected = 0;
        constexpr int parts = 100;
        for (int part = 0; part < parts; ++part)
        {
            const double r = (shell + (part + 0.5)/parts)*range/shells;
            expected +=
                std::exp(-std::exp(-3*r)/(3*thermal))
               *4*3.14159265358979*r*r*range/shells/parts;
        }
        expected *= 0.5*count*(count - 1)/std::pow(edge, 3)*samples;

        EXPECT_NEAR(found[shell], expected, 4*std::sqrt(expected));
    }
}


TEST(brownian, isTheSameOnAnyNumberOfRanks)
{
    constexpr int count = 300;
    const platelets all(freeOnes(count, 8));
    const auto after = [&](const platelets& mine, MPI_Comm ranks)
    {
        engineSettings chosen(settings(0));
        chosen.cutOff = 2;
        chosen.spacing = 0.5;
        chosen.pairKernel = engineSettings::kernel::exact;
        engine system
        (
            cube(8), {}, std::make_shared<repulsion>(), chosen, ranks
        );
        system.load(mine);
        system.advance(0.3);
        return std::make_pair(system.local(), system.counters().steps);
    };

    const auto together = after(share(all), MPI_COMM_WORLD);
    const auto alone = after(myRank() == 0 ? all : platelets(), MPI_COMM_SELF);

    if (myRank() == 0)
    {
        EXPECT_EQ(together.second, alone.second);
    }
    EXPECT_LT
    (
        largestDifference
        (
            gather(together.first, together.first.position, count),
            gather(alone.first, alone.first.position, count)
        ),
        1e-11
    );
}


TEST(brownian, restartsWithTheSameBits)
{
    constexpr int count = 300;
    const platelets all(freeOnes(count, 8));
    const auto made = [&]
    {
        engineSettings chosen(settings(0));
        chosen.cutOff = 2;
        chosen.spacing = 0.5;
        return std::make_unique<engine>
        (
            cube(8), boundarySurface(), std::make_shared<repulsion>(), chosen,
            MPI_COMM_WORLD
        );
    };

    const auto through = made();
    through->load(share(all));
    through->advance(0.2);
    through->listsExpire();
    const auto restarted = made();
    restarted->setSkinUse(through->skinUse());
    restarted->setIntegratorMemory(through->integratorMemory());
    restarted->load(through->local());

    through->advance(0.2);
    restarted->advance(0.2);

    EXPECT_EQ
    (
        largestDifference(positions(*through, count), positions(*restarted, count)),
        0
    );
    EXPECT_GT(largestDifference(positions(*through, count), all.position), 0.1);
}


TEST(brownian, isAnotherPathWithAnotherSeed)
{
    constexpr int count = 500;
    const platelets all(freeOnes(count, 40));
    std::vector<std::vector<vector>> ends;
    for (const std::uint64_t seed : {5, 6})
    {
        engineSettings chosen(settings(0.02));
        chosen.seed = seed;
        engine system
        (
            periodicBox(), {}, std::make_shared<noForce>(), chosen,
            MPI_COMM_WORLD
        );
        system.load(share(all));
        system.advance(0.5);
        ends.push_back(positions(system, count));
    }

    double sum = 0;
    double squares = 0;
    for (int k = 0; k < count; ++k)
    {
        sum += (ends[0][k] - all.position[k]).dot(ends[1][k] - all.position[k]);
        squares += (ends[0][k] - all.position[k]).squaredNorm();
    }
    EXPECT_LT(std::abs(sum/squares), 4/std::sqrt(3.0*count));
}


TEST(brownian, doesNotRepeatItselfAfterAPause)
{
    constexpr int count = 500;
    const platelets all(freeOnes(count, 40));
    const engineSettings random(settings(0.02));
    engineSettings still(random);
    still.thermalEnergy = 0;
    const auto none = std::make_shared<noForce>();

    engine system(periodicBox(), {}, none, random, MPI_COMM_WORLD);
    system.load(share(all));
    system.advance(0.5);
    const auto before = positions(system, count);
    system.change(none, still);
    system.advance(0.5);
    EXPECT_EQ(largestDifference(before, positions(system, count)), 0);

    // Nor if it was stopped in the pause
    engine restarted(periodicBox(), {}, none, still, MPI_COMM_WORLD);
    restarted.setIntegratorMemory(system.integratorMemory());
    restarted.load(system.local());
    restarted.change(none, random);
    restarted.advance(0.5);
    system.change(none, random);
    system.advance(0.5);
    const auto after = positions(system, count);
    EXPECT_EQ(largestDifference(after, positions(restarted, count)), 0);

    double sum = 0;
    double squares = 0;
    for (int k = 0; k < count; ++k)
    {
        sum += (before[k] - all.position[k]).dot(after[k] - before[k]);
        squares += (after[k] - before[k]).squaredNorm();
    }
    EXPECT_LT(std::abs(sum/squares), 4/std::sqrt(3.0*count));
    EXPECT_GT(squares, 0);
}


TEST(brownian, asksForAnIntegratorThatDoesIt)
{
    engineSettings chosen(settings(0));
    chosen.integrator = "RKC2";

    try
    {
        engine system
        (
            periodicBox(), {}, std::make_shared<noForce>(), chosen,
            MPI_COMM_WORLD
        );
        FAIL() << "went on";
    }
    catch (const userError& error)
    {
        EXPECT_NE
        (
            std::string(error.what()).find("RKC2 does no random motion"),
            std::string::npos
        );
    }
}
