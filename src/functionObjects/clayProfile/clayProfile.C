/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayProfile.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clayProfile, 0);
    addToRunTimeSelectionTable(functionObject, clayProfile, dictionary);
}
}


Foam::functionObjects::clayProfile::clayProfile
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, name, dict),
    direction_(Zero),
    slabs_(0),
    lowest_(0),
    thickness_(0)
{
    read(dict);
    writeHeader(file(), "Means over slabs, one block per time");
    writeCommented(file(), "time[s]");
    for
    (
        const char* column
      : {
            "distance[m]", "alpha.clay[-]",
            "Ux[m/s]", "Uy[m/s]", "Uz[m/s]",
            "clayFluxx[m/s]", "clayFluxy[m/s]", "clayFluxz[m/s]"
        }
    )
    {
        writeTabbed(file(), column);
    }
    file() << endl;
}


bool Foam::functionObjects::clayProfile::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    direction_ = dict.get<vector>("direction");
    if (mag(direction_) < SMALL)
    {
        FatalIOErrorInFunction(dict)
            << "direction is " << direction_ << "; it should not be zero"
            << exit(FatalIOError);
    }
    direction_.normalise();

    slabs_ = dict.getCheck<label>("slabs", [](label n){ return n > 0; });
    divide();
    return true;
}


void Foam::functionObjects::clayProfile::divide()
{
    const scalarField height(mesh_.points() & direction_);
    lowest_ = gMin(height);
    thickness_ = (gMax(height) - lowest_)/slabs_;

    slabOf_.setSize(mesh_.nCells());
    forAll(slabOf_, celli)
    {
        const scalar above = (mesh_.C()[celli] & direction_) - lowest_;
        slabOf_[celli] =
            max(label(0), min(slabs_ - 1, label(above/thickness_)));
    }
}


bool Foam::functionObjects::clayProfile::write()
{
    const volScalarField& alpha = lookupObject<volScalarField>("alpha.clay");
    const volVectorField& Uclay = lookupObject<volVectorField>("U.clay");
    const volVectorField& U = lookupObject<volVectorField>("U");

    scalarField volume(slabs_, Zero);
    scalarField meanAlpha(slabs_, Zero);
    vectorField meanU(slabs_, Zero);
    vectorField meanFlux(slabs_, Zero);

    forAll(slabOf_, celli)
    {
        const label slab = slabOf_[celli];
        const scalar V = mesh_.V()[celli];

        volume[slab] += V;
        meanAlpha[slab] += V*alpha[celli];
        meanU[slab] += V*U[celli];
        meanFlux[slab] += V*alpha[celli]*Uclay[celli];
    }
    for (label slab = 0; slab < slabs_; ++slab)
    {
        reduce(volume[slab], sumOp<scalar>());
        reduce(meanAlpha[slab], sumOp<scalar>());
        reduce(meanU[slab], sumOp<vector>());
        reduce(meanFlux[slab], sumOp<vector>());
    }

    if (Pstream::master())
    {
        OFstream& os = file();

        for (label slab = 0; slab < slabs_; ++slab)
        {
            // A slab thinner than the cells may hold no cell centre
            if (volume[slab] <= 0)
            {
                continue;
            }

            const vector u(meanU[slab]/volume[slab]);
            const vector q(meanFlux[slab]/volume[slab]);

            os  << time_.value()
                << tab << (slab + 0.5)*thickness_
                << tab << meanAlpha[slab]/volume[slab]
                << tab << u.x() << tab << u.y() << tab << u.z()
                << tab << q.x() << tab << q.y() << tab << q.z() << nl;
        }
        os  << nl << nl;
        os.flush();
    }
    return true;
}
