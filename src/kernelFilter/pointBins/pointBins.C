/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointBins.H"

Foam::label Foam::pointBins::bin
(
    const direction axis,
    const scalar coordinate
) const
{
    const scalar i = (coordinate - bounds_.min()[axis])/edge_[axis];
    return i <= 0 ? 0 : i >= n_[axis] ? n_[axis] - 1 : label(i);
}


Foam::pointBins::pointBins(const UList<point>& points, const scalar width)
:
    bounds_(points, false),
    edge_(0.25*width, width, width),
    n_(1)
{
    // Few bins that are empty: as many bins as points, and some
    const scalar most = 2.*points.size() + 1000;
    const vector span(points.empty() ? vector(Zero) : bounds_.span());
    const auto count = [&](const direction axis)
    {
        return std::floor(span[axis]/edge_[axis]) + 1;
    };

    while (count(0)*count(1)*count(2) > most)
    {
        edge_ *= 1.2;
    }
    for (direction axis = 0; axis < 3; ++axis)
    {
        n_[axis] = label(count(axis));
    }

    labelList binOf(points.size());
    starts_.setSize(n_[0]*n_[1]*n_[2] + 1, 0);
    forAll(points, pointi)
    {
        const point& p = points[pointi];
        binOf[pointi] =
            bin(0, p.x()) + n_[0]*(bin(1, p.y()) + n_[1]*bin(2, p.z()));
        ++starts_[binOf[pointi] + 1];
    }
    for (label i = 1; i < starts_.size(); ++i)
    {
        starts_[i] += starts_[i - 1];
    }

    labelList next(starts_);
    order_.setSize(points.size());
    forAll(points, pointi)
    {
        order_[next[binOf[pointi]]++] = pointi;
    }
}
