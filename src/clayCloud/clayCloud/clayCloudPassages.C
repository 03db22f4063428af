/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayCloud.H"
#include "asFatalError.H"

#include "Pstream.H"

void Foam::clayCloud::countThrough
(
    const word& name,
    const UList<FixedList<point, 3>>& triangles
)
{
    const reducedUnits& units = interactions_.units();

    label number = countedNames_.find(name);
    if (number < 0)
    {
        number = countedNames_.size();
        countedNames_.append(name);
        counted_.emplace_back();
    }

    // What a restart has found stays
    state_.passages(name, scalarList(2, Zero));

    counted_[number].triangles.clear();
    for (const FixedList<point, 3>& triangle : triangles)
    {
        std::array<plateletDynamics::vector, 3> corners;
        for (label i = 0; i < 3; ++i)
        {
            corners[i] = reduced(triangle[i], units.length());
        }
        counted_[number].triangles.push_back(corners);
    }
    asFatalError
    (
        units, properties_, [&]{ engine_->setCountedSurfaces(counted_); }
    );
}


void Foam::clayCloud::addPassages()
{
    if (countedNames_.empty())
    {
        return;
    }

    // Numbers that a scalar holds exactly
    scalarList through(2*countedNames_.size(), Zero);
    forAll(countedNames_, i)
    {
        through[2*i] = scalar(engine_->counted()[i].forward);
        through[2*i + 1] = scalar(engine_->counted()[i].backward);
    }
    Pstream::listCombineGather(through, plusEqOp<scalar>());
    Pstream::listCombineScatter(through);

    forAll(countedNames_, i)
    {
        state_.passages[countedNames_[i]][0] += through[2*i];
        state_.passages[countedNames_[i]][1] += through[2*i + 1];
    }
}


Foam::scalar Foam::clayCloud::parcelNumber() const
{
    return pow3(state_.coarseGraining);
}


Foam::scalar Foam::clayCloud::parcelVolume() const
{
    return interactions_.parcelVolume();
}


Foam::scalar Foam::clayCloud::parcelMass() const
{
    return matter_.clay().density*interactions_.parcelVolume();
}
