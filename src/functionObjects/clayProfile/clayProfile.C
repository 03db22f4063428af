/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayProfile.H"
#include "addToRunTimeSelectionTable.H"
#include "keptNumbers.H"
#include "volFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clayProfile, 0);
    addToRunTimeSelectionTable(functionObject, clayProfile, dictionary);
}
}


Foam::functionObjects::runFunction::requirements
Foam::functionObjects::clayProfile::needs(const dictionary& dict)
{
    const bool average = dict.getOrDefault("average", false);

    return
    {
        {"direction", "slabs", "average"},
        "clayFoam",
        {"alpha.clay", "U.clay", "U"},
        average ? "means over time need each step of the run" : "",
        true
    };
}


Foam::functionObjects::clayProfile::clayProfile
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    runFunction(name, runTime, dict, needs(dict)),
    runTable(mesh_, name),
    direction_(Zero),
    slabs_(0),
    lowest_(0),
    thickness_(0),
    average_(false),
    duration_(0)
{
    read(dict);
    if (!postProcess)
    {
        restore();
    }
}


void Foam::functionObjects::clayProfile::writeHeading(Ostream& os) const
{
    writeHeader(os, "Means over slabs, one block per time");
    writeCommented(os, "time[s]");
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
        writeTabbed(os, column);
    }
    os  << nl;
}


bool Foam::functionObjects::clayProfile::read(const dictionary& dict)
{
    runFunction::read(dict);
    runTable::read(dict);

    direction_ = dict.get<vector>("direction");
    if (mag(direction_) < SMALL)
    {
        FatalIOErrorInFunction(dict)
            << "direction is " << direction_ << "; it should not be zero"
            << exit(FatalIOError);
    }
    direction_.normalise();

    slabs_ = dict.getCheck<label>("slabs", [](label n){ return n > 0; });
    average_ = dict.getOrDefault("average", false);
    divide();
    clearIntegral();
    return true;
}


void Foam::functionObjects::clayProfile::divide()
{
    const scalarField height(mesh_.points() & direction_);
    lowest_ = gMin(height);
    thickness_ = (gMax(height) - lowest_)/slabs_;

    const vectorField& centres = mesh_.cellCentres();
    const scalarField& volumes = mesh_.cellVolumes();

    slabOf_.setSize(mesh_.nCells());
    forAll(slabOf_, celli)
    {
        const scalar above = (centres[celli] & direction_) - lowest_;

        // A centre between two slabs is in the upper one, whatever its rounding,
        // which other ranks do differently
        slabOf_[celli] =
            max(label(0), min(slabs_ - 1, label(above/thickness_ + 1e-9)));
    }

    volume_ = scalarField(slabs_, Zero);
    forAll(slabOf_, celli)
    {
        volume_[slabOf_[celli]] += volumes[celli];
    }
    sumOfRanks(volume_);
}


template<class Type>
void Foam::functionObjects::clayProfile::sumOfRanks(Field<Type>& values)
{
    Pstream::listCombineGather(values, plusEqOp<Type>());
    Pstream::listCombineScatter(values);
}


Foam::functionObjects::clayProfile::profile
Foam::functionObjects::clayProfile::present() const
{
    const volScalarField& alpha = lookupObject<volScalarField>("alpha.clay");
    const volVectorField& Uclay = lookupObject<volVectorField>("U.clay");
    const volVectorField& U = lookupObject<volVectorField>("U");

    profile mean
    {
        scalarField(slabs_, Zero),
        vectorField(slabs_, Zero),
        vectorField(slabs_, Zero)
    };
    forAll(slabOf_, celli)
    {
        const label slab = slabOf_[celli];
        const scalar V = mesh_.V()[celli];

        mean.alpha[slab] += V*alpha[celli];
        mean.U[slab] += V*U[celli];
        mean.flux[slab] += V*alpha[celli]*Uclay[celli];
    }
    sumOfRanks(mean.alpha);
    sumOfRanks(mean.U);
    sumOfRanks(mean.flux);

    // A slab thinner than the cells may hold no cell centre
    const scalarField volume(max(volume_, VSMALL));
    mean.alpha /= volume;
    mean.U /= volume;
    mean.flux /= volume;

    return mean;
}


void Foam::functionObjects::clayProfile::clearIntegral()
{
    integral_.alpha = scalarField(slabs_, Zero);
    integral_.U = vectorField(slabs_, Zero);
    integral_.flux = vectorField(slabs_, Zero);
    duration_ = 0;
}


void Foam::functionObjects::clayProfile::keep() const
{
    if (!average_ || !time_.writeTime() || postProcess)
    {
        return;
    }

    scalarList numbers({direction_.x(), direction_.y(), direction_.z()});
    numbers.append(duration_);
    for (label slab = 0; slab < slabs_; ++slab)
    {
        numbers.append(integral_.alpha[slab]);
        for (direction axis = 0; axis < 3; ++axis)
        {
            numbers.append(integral_.U[slab][axis]);
            numbers.append(integral_.flux[slab][axis]);
        }
    }

    HashTable<scalarList> lists;
    lists.set("integral", numbers);
    keptNumbers(time_, name(), lists).save();
}


void Foam::functionObjects::clayProfile::restore()
{
    if (!average_)
    {
        return;
    }
    const keptNumbers kept(time_, name());
    const auto found = kept.lists.cfind("integral");

    if (!found.found())
    {
        return;
    }
    const scalarList& numbers = *found;

    if
    (
        numbers.size() != 4 + 7*slabs_
     || vector(numbers[0], numbers[1], numbers[2]) != direction_
    )
    {
        WarningInFunction
            << "The means in " << kept.objectPath() << " are over other slabs"
            << " than those of " << name() << " now: they begin anew" << nl
            << endl;
        return;
    }

    duration_ = numbers[3];
    if (duration_ > 0)
    {
        leaveOutStart();
    }
    for (label slab = 0; slab < slabs_; ++slab)
    {
        const scalar* of = &numbers[4 + 7*slab];
        integral_.alpha[slab] = of[0];
        for (direction axis = 0; axis < 3; ++axis)
        {
            integral_.U[slab][axis] = of[1 + 2*axis];
            integral_.flux[slab][axis] = of[2 + 2*axis];
        }
    }
}


bool Foam::functionObjects::clayProfile::execute()
{
    if (postProcess)
    {
        return true;
    }
    begin();

    if (average_)
    {
        const scalar deltaT = time_.deltaTValue();
        const profile now(present());

        integral_.alpha += deltaT*now.alpha;
        integral_.U += deltaT*now.U;
        integral_.flux += deltaT*now.flux;
        duration_ += deltaT;
    }
    keep();
    return true;
}


void Foam::functionObjects::clayProfile::append()
{
    profile mean(duration_ > 0 ? integral_ : present());
    if (duration_ > 0)
    {
        mean.alpha /= duration_;
        mean.U /= duration_;
        mean.flux /= duration_;
    }

    if (Pstream::master())
    {
        Ostream& os = rows();

        for (label slab = 0; slab < slabs_; ++slab)
        {
            if (volume_[slab] <= 0)
            {
                continue;
            }

            const vector& u = mean.U[slab];
            const vector& q = mean.flux[slab];

            writeTime(os);
            os  << tab << (slab + 0.5)*thickness_
                << tab << mean.alpha[slab]
                << tab << u.x() << tab << u.y() << tab << u.z()
                << tab << q.x() << tab << q.y() << tab << q.z() << nl;
        }
        os  << nl << nl;
    }
    endRows();
}


bool Foam::functionObjects::clayProfile::write()
{
    if (ready())
    {
        append();
        clearIntegral();
        keep();
    }
    return true;
}


bool Foam::functionObjects::clayProfile::end()
{
    if (!hasNow() && ready())
    {
        append();
    }
    return true;
}
