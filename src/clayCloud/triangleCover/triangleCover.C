/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "triangleCover.H"

#include <algorithm>
#include <cmath>

Foam::label Foam::triangleCover::binOf
(
    const scalar x,
    const direction i
) const
{
    // In double precision first: what is far away has no number
    const scalar bin = std::floor((x - lower_[i])/width_[i]);
    return label(std::min(std::max(bin, scalar(0)), scalar(n_[i] - 1)));
}


Foam::triangleCover::triangleCover
(
    const std::vector<FixedList<point, 3>>& triangles,
    const vector& normal,
    const scalar reach
)
:
    reach_(reach)
{
    // The axis that is least along the normal, made perpendicular to it
    const vector size(cmptMag(normal));
    vector axis(Zero);
    axis
    [
        size.x() <= size.y() && size.x() <= size.z() ? 0
      : size.y() <= size.z() ? 1 : 2
    ] = 1;
    along_ = axis - (axis & normal)*normal;
    along_ /= mag(along_);
    across_ = normal ^ along_;

    corner upper{-GREAT, -GREAT};
    lower_ = corner{GREAT, GREAT};
    for (const auto& t : triangles)
    {
        FixedList<corner, 3> c{inPlane(t[0]), inPlane(t[1]), inPlane(t[2])};
        const scalar area =
            (c[1][0] - c[0][0])*(c[2][1] - c[0][1])
          - (c[1][1] - c[0][1])*(c[2][0] - c[0][0]);
        if (area < 0)
        {
            std::swap(c[1], c[2]);
        }
        triangles_.push_back(c);

        for (const corner& p : c)
        {
            for (direction i = 0; i < 2; ++i)
            {
                lower_[i] = std::min(lower_[i], p[i] - reach_);
                upper[i] = std::max(upper[i], p[i] + reach_);
            }
        }
    }

    const label n = label(std::ceil(std::sqrt(scalar(triangles.size()))));
    for (direction i = 0; i < 2; ++i)
    {
        n_[i] = n;
        width_[i] = (upper[i] - lower_[i])/n;
    }
    bins_.resize(std::size_t(n)*n);

    for (std::size_t k = 0; k < triangles_.size(); ++k)
    {
        const auto& c = triangles_[k];
        label from[2];
        label to[2];
        for (direction i = 0; i < 2; ++i)
        {
            from[i] = binOf(std::min({c[0][i], c[1][i], c[2][i]}) - reach_, i);
            to[i] = binOf(std::max({c[0][i], c[1][i], c[2][i]}) + reach_, i);
        }
        for (label a = from[0]; a <= to[0]; ++a)
        {
            for (label b = from[1]; b <= to[1]; ++b)
            {
                bins_[a + n_[0]*b].push_back(label(k));
            }
        }
    }
}


Foam::label Foam::triangleCover::over
(
    const point& x,
    const scalar margin
) const
{
    const corner p(inPlane(x));

    for (const label k : bins_[binOf(p[0], 0) + n_[0]*binOf(p[1], 1)])
    {
        const auto& c = triangles_[k];
        bool over = true;
        for (direction i = 0; i < 3 && over; ++i)
        {
            const corner& a = c[i];
            const corner& b = c[(i + 1)%3];
            const scalar inwards =
                (b[0] - a[0])*(p[1] - a[1]) - (b[1] - a[1])*(p[0] - a[0]);

            over = inwards >= -margin*std::hypot(b[0] - a[0], b[1] - a[1]);
        }
        if (over)
        {
            return k;
        }
    }
    return -1;
}
