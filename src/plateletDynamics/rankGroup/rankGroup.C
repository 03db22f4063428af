/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "rankGroup.H"

#include "userError.H"

namespace plateletDynamics
{

namespace
{

bool mpiIsRunning()
{
    int started = 0;
    int ended = 0;
    MPI_Initialized(&started);
    MPI_Finalized(&ended);

    return started && !ended;
}

} // End namespace


rankGroup::rankGroup(MPI_Comm communicator)
{
    if (mpiIsRunning())
    {
        // Our messages never meet the caller's
        MPI_Comm_dup(communicator, &communicator_);
        MPI_Comm_rank(communicator_, &rank_);
        MPI_Comm_size(communicator_, &size_);
    }
}


rankGroup::~rankGroup()
{
    if (communicator_ != MPI_COMM_NULL && mpiIsRunning())
    {
        MPI_Comm_free(&communicator_);
    }
}


void rankGroup::max(double* values, int count) const
{
    if (size_ > 1)
    {
        MPI_Allreduce
        (
            MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_MAX, communicator_
        );
    }
}


double rankGroup::max(double value) const
{
    max(&value, 1);
    return value;
}


double rankGroup::sum(double value) const
{
    // Summed in rank order: the same bits in every run
    double total = 0;
    for (const double part : gather({value}))
    {
        total += part;
    }
    return total;
}


std::vector<double> rankGroup::gather(const std::vector<double>& values) const
{
    if (size_ == 1)
    {
        return values;
    }

    std::vector<double> all(values.size()*size_);
    MPI_Allgather
    (
        values.data(), int(values.size()), MPI_DOUBLE,
        all.data(), int(values.size()), MPI_DOUBLE,
        communicator_
    );
    return all;
}


void rankGroup::agree(const std::string& problem) const
{
    if (size_ == 1)
    {
        if (!problem.empty())
        {
            throw userError(problem);
        }
        return;
    }

    int first = problem.empty() ? size_ : rank_;
    MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator_);

    if (first == size_)
    {
        return;
    }

    std::string shared(problem);
    int length = int(shared.size());
    MPI_Bcast(&length, 1, MPI_INT, first, communicator_);
    shared.resize(length);
    MPI_Bcast(shared.data(), length, MPI_CHAR, first, communicator_);

    throw userError(shared);
}

} // End namespace plateletDynamics
