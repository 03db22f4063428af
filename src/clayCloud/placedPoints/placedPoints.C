/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "placedPoints.H"

Foam::placedPoints::placedPoints
(
    const periodicAxes& axes,
    const scalar reach
)
:
    axes_(axes),
    reach_(reach),
    binWidth_(reach/binsInReach),
    hashBits_(10),
    first_(1 << hashBits_, -1)
{}


void Foam::placedPoints::addImage(const point& x)
{
    const auto link = [this](const label i)
    {
        label& first = first_[hash(entries_[i].key)];
        entries_[i].next = first;
        first = i;
    };

    entries_.push_back({x, key(binOf(x)), -1});

    if (entries_.size() <= first_.size())
    {
        link(label(entries_.size()) - 1);
        return;
    }

    // So few points have the same hash that looking for them costs nothing
    hashBits_ += 2;
    first_.assign(std::size_t(1) << hashBits_, -1);
    for (label i = 0; i < label(entries_.size()); ++i)
    {
        link(i);
    }
}


void Foam::placedPoints::add(const point& x)
{
    // Along each axis: where it is and, near a periodic boundary, where its
    // images are
    FixedList<scalar, 3> at[3];
    label number[3];
    for (direction axis = 0; axis < 3; ++axis)
    {
        at[axis][0] = x[axis];
        number[axis] = 1;
        if (axes_.periodic(axis))
        {
            const scalar period = axes_.period(axis);
            if (x[axis] + period < axes_.upper(axis) + reach_)
            {
                at[axis][number[axis]++] = x[axis] + period;
            }
            if (x[axis] - period > axes_.lower(axis) - reach_)
            {
                at[axis][number[axis]++] = x[axis] - period;
            }
        }
    }

    for (label i = 0; i < number[0]; ++i)
    {
        for (label j = 0; j < number[1]; ++j)
        {
            for (label k = 0; k < number[2]; ++k)
            {
                addImage(point(at[0][i], at[1][j], at[2][k]));
            }
        }
    }
}


Foam::scalar Foam::placedPoints::nearest
(
    const point& x,
    const scalar enough
) const
{
    const bin centre(binOf(x));
    const scalar near = sqr(max(enough, scalar(0)));
    scalar least = sqr(reach_);

    for (label distance = 0; distance <= binsInReach; ++distance)
    {
        forShell
        (
            centre,
            distance,
            [&](const bin& b)
            {
                forBin
                (
                    b, x, [&](const vector& d){ least = min(least, magSqr(d)); }
                );
            }
        );

        // Bins farther out are farther away than their distance
        if (least < near || least <= sqr(distance*binWidth_))
        {
            break;
        }
    }
    return Foam::sqrt(least);
}
