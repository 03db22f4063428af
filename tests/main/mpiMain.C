/*---------------------------------------------------------------------------*\
bentoFoam: erosion of bentonite clay in fractures, from platelets to fracture
SPDX-License-Identifier: GPL-3.0-or-later

Description
    The main of GoogleTest tests that need MPI but no OpenFOAM, alone or under
    mpirun. In Make/files:

        $(BENTOFOAM_DIR)/tests/main/mpiMain.C

    and in Make/options `$(BENTOFOAM_TEST_LIBS)` after the tested libraries.

\*---------------------------------------------------------------------------*/

#include "testRun.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    testing::InitGoogleTest(&argc, argv);

    const int returnCode = runTests();

    MPI_Finalize();

    return returnCode;
}

// ************************************************************************* //
