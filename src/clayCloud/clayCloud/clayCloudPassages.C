/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayCloud.H"
#include "asFatalError.H"

#include "Pstream.H"

namespace
{

using namespace Foam;

//- What tells that a surface is the same however its triangles are divided and
//  ordered: its area [m2], the vector of that, its middle [m], and the volume
//  that it shuts in on its backward side, seen from there [m3]
scalarList identityOf(const UList<FixedList<point, 3>>& triangles)
{
    scalar area = 0;
    vector areaVector(Zero);
    vector middle(Zero);
    for (const FixedList<point, 3>& t : triangles)
    {
        const vector n(0.5*((t[1] - t[0]) ^ (t[2] - t[0])));
        area += mag(n);
        areaVector += n;
        middle += mag(n)*(t[0] + t[1] + t[2])/3;
    }
    middle /= max(area, ROOTVSMALL);

    scalar volume = 0;
    for (const FixedList<point, 3>& t : triangles)
    {
        const vector n(0.5*((t[1] - t[0]) ^ (t[2] - t[0])));
        volume += ((t[0] + t[1] + t[2])/3 - middle) & n/3;
    }
    return scalarList
    ({
        area, areaVector.x(), areaVector.y(), areaVector.z(),
        middle.x(), middle.y(), middle.z(), volume
    });
}


bool sameSurface(const scalarList& a, const scalarList& b)
{
    if (a.size() != 8 || b.size() != 8)
    {
        return false;
    }
    // Meshes may have six digits
    constexpr scalar digits = 1e-4;
    const scalar width = Foam::sqrt(max(a[0], b[0]));

    for (label i = 0; i < 8; ++i)
    {
        const scalar scale =
            i < 4 ? sqr(width) : i < 7 ? max(width, mag(a[i])) : pow3(width);

        if (mag(a[i] - b[i]) > digits*scale)
        {
            return false;
        }
    }
    return true;
}

} // End anonymous namespace


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

    // What a restart has found stays, if it is of this surface
    const scalarList what(identityOf(triangles));
    if (state_.surfaces.found(name) && !sameSurface(state_.surfaces[name], what))
    {
        WarningInFunction
            << name << " is another surface than that through which time "
            << mesh_.time().timeName() << " has counted under this name:" << nl
            << "    what passes is counted anew" << nl << endl;
        state_.passages.erase(name);
    }
    state_.surfaces.set(name, what);
    state_.passages(name, scalarList(6, Zero));

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
        scalarList& passed = state_.passages[countedNames_[i]];
        for (label way = 0; way < 2; ++way)
        {
            const scalar number = through[2*i + way];
            passed[way] += number;
            passed[2 + way] += number*parcelVolume();
            passed[4 + way] += number*parcelMass();
        }
    }
}


void Foam::clayCloud::countLeft(const word& from, const label number)
{
    state_.left(from, 0) += number;

    scalarList& amount = state_.amountLeft(from, scalarList(2, Zero));
    amount[0] += number*parcelVolume();
    amount[1] += number*parcelMass();
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
