/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "surfaceTriangle.H"

#include <Eigen/Geometry>

namespace plateletDynamics
{

surfaceTriangle::surfaceTriangle(const std::array<vector, 3>& c)
:
    corners(c),
    normal((c[1] - c[0]).cross(c[2] - c[0]))
{
    const double twiceArea = normal.norm();
    const double size =
        std::max((c[1] - c[0]).squaredNorm(), (c[2] - c[0]).squaredNorm());

    if (twiceArea > 1e-10*size)
    {
        normal /= twiceArea;
    }
    else
    {
        normal.setZero();
    }

    for (int i = 0; i < 3; ++i)
    {
        intoFromEdge[i] = normal.cross(corners[(i + 1)%3] - corners[i]);
    }
}


surfaceTriangle::foot surfaceTriangle::nearest(const vector& x) const
{
    // Within which edges? Outside several only the edges can be nearest
    bool inside = true;
    foot best{vector::Zero(), foot::face};
    double bestSquared = 0;

    for (int i = 0; i < 3; ++i)
    {
        const vector& a = corners[i];
        const vector edge(corners[(i + 1)%3] - a);
        const vector fromCorner(x - a);

        if (intoFromEdge[i].dot(fromCorner) >= 0)
        {
            continue;
        }

        const double along = edge.dot(fromCorner)/edge.squaredNorm();
        const int feature =
            along <= 0 ? foot::corner + i
          : along >= 1 ? foot::corner + (i + 1)%3
          : foot::edge + i;

        const vector point
        (
            feature >= foot::corner
          ? corners[feature - foot::corner]
          : vector(a + along*edge)
        );
        const double squared = (x - point).squaredNorm();

        if (inside || squared < bestSquared)
        {
            best = {point, feature};
            bestSquared = squared;
        }
        inside = false;
    }

    return inside ? foot{x - height(x)*normal, foot::face} : best;
}


bool surfaceTriangle::contains(const vector& x, double tolerance) const
{
    for (int i = 0; i < 3; ++i)
    {
        const vector edge(corners[(i + 1)%3] - corners[i]);

        if
        (
            intoFromEdge[i].dot(x - corners[i]) < -tolerance*edge.squaredNorm()
        )
        {
            return false;
        }
    }
    return true;
}


bool surfaceTriangle::between(const vector& x, const vector& y) const
{
    const double hx = height(x);
    const double hy = height(y);

    return
        ((hx > 0 && hy < 0) || (hx < 0 && hy > 0))
     && contains(x + hx/(hx - hy)*(y - x));
}

} // End namespace plateletDynamics
