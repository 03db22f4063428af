/*---------------------------------------------------------------------------*\
bentoFoam: erosion of bentonite clay in fractures, from platelets to fracture
SPDX-License-Identifier: GPL-3.0-or-later

Description
    The main of GoogleTest tests that use OpenFOAM; no case is needed, neither
    in serial nor with

        mpirun -np 2 <library>Test -parallel

    FatalError and FatalIOError throw (EXPECT_THROW(..., Foam::error)).
    OpenFOAM's floating-point traps are on. In Make/files:

        $(BENTOFOAM_DIR)/tests/main/openfoamMain.C

    and in Make/options `$(BENTOFOAM_TEST_LIBS)` after the tested libraries.

\*---------------------------------------------------------------------------*/

#include "testRun.H"

#include "argList.H"
#include "error.H"

#include <cstdlib>
#include <exception>
#include <iostream>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- GoogleTest shows std::exception::what(), which OpenFOAM's errors leave
//  empty. It reports while it handles the exception, so the message is at hand
class messagesOfOpenFOAM
:
    public testing::EmptyTestEventListener
{
public:

    void OnTestPartResult(const testing::TestPartResult& result) override
    {
        if (!result.failed() || !std::current_exception())
        {
            return;
        }

        try
        {
            std::rethrow_exception(std::current_exception());
        }
        catch (const Foam::error& err)
        {
            std::cerr<< err.message() << std::endl;
        }
        catch (...)
        {}
    }
};


int main(int argc, char** argv)
{
    // First, since argList would take GoogleTest's flags for its own
    testing::InitGoogleTest(&argc, argv);

    Foam::argList::noBanner();
    Foam::argList::noJobInfo();
    Foam::argList::noCheckProcessorDirectories();

    // Never destroyed: in v1912 its destructor ends the program with exit(0)
    new Foam::argList(argc, argv);

    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();

    testing::UnitTest::GetInstance()->listeners().Append
    (
        new messagesOfOpenFOAM
    );

    const int returnCode = runTests();

    std::cout.flush();
    if (mpiIsRunning())
    {
        MPI_Finalize();
    }

    // Without OpenFOAM's static destructors, which assume that argList is gone
    std::_Exit(returnCode);
}

// ************************************************************************* //
