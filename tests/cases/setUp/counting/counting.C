/*---------------------------------------------------------------------------*\
bentoFoam: erosion of bentonite clay in fractures, from platelets to fracture
SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests that pass and fail as the case setUp needs them.

\*---------------------------------------------------------------------------*/

#include <mpi.h>

#include <gtest/gtest.h>

#include "Pstream.H"
#include "error.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST(counting, passes)
{
    EXPECT_THROW
    (
        FatalErrorInFunction << "expected" << Foam::exit(Foam::FatalError),
        Foam::error
    );
}


TEST(counting, passesOnRank0)
{
    EXPECT_EQ(Foam::Pstream::myProcNo(), 0);
}


TEST(counting, throws)
{
    FatalErrorInFunction
        << "a message of OpenFOAM" << Foam::exit(Foam::FatalError);
}


TEST(counting, divides)
{
    volatile double zero = 0;
    volatile double quotient = 1/zero;
    EXPECT_GT(quotient, 0);
}

// ************************************************************************* //
