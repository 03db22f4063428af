/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "benchmarkPlaces.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "error.H"

#include <cstdio>
#include <fstream>
#include <random>

#include <mpi.h>

namespace
{

using namespace Foam;
using plateletDynamics::platelets;
using place = plateletDynamics::vector;

//- Bricks of the cube, one per rank
class bricks
{
    const scalar edge_;
    int n_[3] = {1, 1, 1};

public:

    explicit bricks(const scalar edge)
    :
        edge_(edge)
    {
        if (Pstream::parRun())
        {
            n_[0] = n_[1] = n_[2] = 0;
            MPI_Dims_create(Pstream::nProcs(), 3, n_);
        }
    }

    bool mine(const place& x) const
    {
        int owner = 0;
        for (int axis = 0; axis < 3; ++axis)
        {
            const int brick = int(n_[axis]*x[axis]/edge_);
            owner = owner*n_[axis] + std::min(brick, n_[axis] - 1);
        }
        return owner == Pstream::myProcNo();
    }
};


//- The nearest image of a displacement in the cube
place nearest(const place& d, const scalar edge)
{
    return d - edge*(d/edge).array().round().matrix();
}


//- A data file of LAMMPS up to its places; returns their number
label readHeader(std::ifstream& is, const fileName& file)
{
    label number = 0;
    std::string line;

    while (std::getline(is, line) && line.compare(0, 5, "Atoms") != 0)
    {
        if (line.find(" atoms") != std::string::npos)
        {
            number = std::atoi(line.c_str());
        }
    }
    if (!is || number <= 0)
    {
        FatalErrorInFunction
            << file << " is not a data file of LAMMPS" << exit(FatalError);
    }
    return number;
}


//- Rank after rank appends its lines to the file, from 17 digits each
template<class Line>
void append(const fileName& file, const platelets& local, const Line& line)
{
    for (int rank = 0; rank < Pstream::nProcs(); ++rank)
    {
        if (rank == Pstream::myProcNo())
        {
            std::ofstream os(file, std::ios::app);
            os.precision(17);
            for (std::size_t k = 0; k < local.size(); ++k)
            {
                line(os, k);
            }
            if (!os)
            {
                FatalErrorInFunction
                    << "Cannot write " << file << exit(FatalError);
            }
        }
        // Wait for it
        returnReduce(rank, sumOp<label>());
    }
}

} // End anonymous namespace


Foam::scalar Foam::benchmarkPlaces::edge(const label number)
{
    return std::cbrt(scalar(number));
}


plateletDynamics::periodicBox Foam::benchmarkPlaces::cube(const label number)
{
    plateletDynamics::periodicBox space;
    space.upper.setConstant(edge(number));
    space.periodic = {true, true, true};
    return space;
}


plateletDynamics::platelets Foam::benchmarkPlaces::random(const label number)
{
    const scalar minimumDistance = 0.7;
    const scalar length = edge(number);
    const bricks share(length);

    // Cells as wide as the minimum distance: only neighbours can be too near
    const int n = std::max(1, int(length/minimumDistance));
    std::vector<std::vector<place>> cells(std::size_t(n)*n*n);
    const auto cellAt = [&](int i, int j, int k) -> std::vector<place>&
    {
        const auto wrapped = [n](int m){ return std::size_t((m + n) % n); };
        return cells[(wrapped(i)*n + wrapped(j))*n + wrapped(k)];
    };

    std::mt19937_64 numbers(1);
    const auto uniform = [&]{ return (numbers() >> 11)*std::ldexp(1.0, -53); };

    platelets local;
    for (label id = 1; id <= number;)
    {
        const scalar x = uniform();
        const scalar y = uniform();
        const scalar z = uniform();
        const place candidate(length*place(x, y, z));
        const int at[3] = {int(n*x), int(n*y), int(n*z)};

        bool free = true;
        for (int m = 0; m < 27 && free; ++m)
        {
            for
            (
                const place& other
              : cellAt(at[0] + m/9 - 1, at[1] + m/3%3 - 1, at[2] + m%3 - 1)
            )
            {
                free = free
                 && nearest(candidate - other, length).norm() > minimumDistance;
            }
        }
        if (free)
        {
            cellAt(at[0], at[1], at[2]).push_back(candidate);
            if (share.mine(candidate))
            {
                local.append(id, candidate);
            }
            ++id;
        }
    }
    return local;
}


Foam::label Foam::benchmarkPlaces::numberIn(const fileName& file)
{
    std::ifstream is(file);
    return readHeader(is, file);
}


plateletDynamics::platelets Foam::benchmarkPlaces::read(const fileName& file)
{
    std::ifstream is(file);
    const label number = readHeader(is, file);
    const bricks share(edge(number));

    platelets local;
    for (label k = 0; k < number; ++k)
    {
        std::int64_t id;
        int type;
        place x;
        is >> id >> type >> x[0] >> x[1] >> x[2];
        if (!is)
        {
            FatalErrorInFunction
                << file << " ends before its " << number << " places"
                << exit(FatalError);
        }
        if (share.mine(x))
        {
            local.append(id, x);
        }
    }
    return local;
}


void Foam::benchmarkPlaces::writeData
(
    const fileName& file,
    const label number,
    const plateletDynamics::platelets& local
)
{
    if (Pstream::master())
    {
        std::ofstream os(file);
        os.precision(17);
        os  << "places of engineBenchmark\n\n" << number << " atoms\n"
            << "1 atom types\n";
        for (const char* axis : {"x", "y", "z"})
        {
            os  << "0 " << edge(number) << ' ' << axis << "lo " << axis
                << "hi\n";
        }
        os  << "\nAtoms\n\n";
    }
    append(file, local, [&](std::ostream& os, std::size_t k)
    {
        os  << local.id[k] << " 1 " << local.position[k][0] << ' '
            << local.position[k][1] << ' ' << local.position[k][2] << '\n';
    });
}


void Foam::benchmarkPlaces::writeUnwrapped
(
    const fileName& file,
    const label number,
    const plateletDynamics::platelets& local
)
{
    if (Pstream::master())
    {
        std::remove(file.c_str());
    }
    append(file, local, [&](std::ostream& os, std::size_t k)
    {
        os  << local.id[k];
        for (int axis = 0; axis < 3; ++axis)
        {
            os  << ' ' << local.position[k][axis]
                + local.crossings[k][axis]*edge(number);
        }
        os  << '\n';
    });
}


Foam::scalar Foam::benchmarkPlaces::neighboursInRange
(
    const label number,
    const plateletDynamics::platelets& local,
    const scalar cutOff
)
{
    // Those of the first rank; platelets are in the order of space
    List<List<scalar>> sample(min(label(1000), label(local.size())));
    for (label k = 0; k < sample.size(); ++k)
    {
        const place& x = local.position[k];
        sample[k] = {x[0], x[1], x[2]};
    }
    Pstream::scatter(sample);

    scalar found = 0;
    for (const List<scalar>& s : sample)
    {
        const place x(s[0], s[1], s[2]);
        for (const place& other : local.position)
        {
            found += nearest(other - x, edge(number)).norm() < cutOff;
        }
    }
    // Itself
    return returnReduce(found, sumOp<scalar>())/sample.size() - 1;
}
