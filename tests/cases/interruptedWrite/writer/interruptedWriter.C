/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    interruptedWriter

Description
    A solver without a mesh, to try what happens to runs that are interrupted
    while they write: three lists of numbers, each a function of its former
    self and the time, advanced in steps that follow them. Can kill itself,
    or one of its ranks, in the middle of a file.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "progress.H"
#include "restartableTime.H"
#include "scalarIOField.H"

#include <csignal>

using namespace Foam;

//- A list that is written with the time, and may end the program half-way
class numbers
:
    public scalarIOField
{
public:

    bool deadly = false;

    numbers(const word& name, const label size, const Time& runTime)
    :
        scalarIOField
        (
            IOobject
            (
                name,
                runTime.timeName(),
                runTime,
                IOobject::READ_IF_PRESENT,
                IOobject::AUTO_WRITE
            )
        )
    {
        if (empty())
        {
            resize(size);
            forAll(*this, i)
            {
                (*this)[i] = std::sin(scalar(i));
            }
        }
    }

    void advance(const scalar time)
    {
        for (scalar& number : *this)
        {
            number = std::cos(3*number + time);
        }
    }

    virtual bool writeData(Ostream& os) const
    {
        if (deadly)
        {
            os << SubList<scalar>(*this, size()/2) << flush;
            std::raise(SIGKILL);
        }
        return scalarIOField::writeData(os);
    }
};


int main(int argc, char *argv[])
{
    argList::addOption("size", "n", "Length of a list");
    argList::addOption("killAt", "time", "Kill the run when it writes this");
    argList::addOption("killRank", "n", "And only this rank");

    #include "setRootCase.H"
    const fileName begunWith;
    #include "createRestartableTime.H"

    const label size = args.getOrDefault<label>("size", 5000);
    numbers alpha("alpha", size, runTime);
    numbers beta("beta", size, runTime);
    numbers gamma("gamma", size, runTime);

    const progress log(runTime);

    while (runTime.run())
    {
        runTime.setDeltaT(0.03*(1.5 + alpha[0]));
        ++runTime;

        for (numbers* list : {&alpha, &beta, &gamma})
        {
            list->advance(runTime.value());
        }

        beta.deadly =
            args.getOrDefault<word>("killAt", word()) == runTime.timeName()
         && args.getOrDefault<label>("killRank", Pstream::myProcNo())
         == Pstream::myProcNo();

        runTime.writeIfDue();
        log.report();
    }

    return 0;
}
