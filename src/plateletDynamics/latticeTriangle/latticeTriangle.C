/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "latticeTriangle.H"

namespace plateletDynamics
{

namespace
{

latticePoint minus(const latticePoint& a, const latticePoint& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

} // End namespace


latticeTriangle::wide latticeTriangle::cross
(
    const latticePoint& a,
    const latticePoint& b
)
{
    return
    {
        product(a[1])*b[2] - product(a[2])*b[1],
        product(a[2])*b[0] - product(a[0])*b[2],
        product(a[0])*b[1] - product(a[1])*b[0]
    };
}


int latticeTriangle::sign(product value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}


int latticeTriangle::firstSign(const wide& v)
{
    return v[0] != 0 ? sign(v[0]) : v[1] != 0 ? sign(v[1]) : sign(v[2]);
}


latticeTriangle::latticeTriangle(const std::array<latticePoint, 3>& corners)
:
    corners_(corners),
    normal_
    (
        cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
    )
{}


bool latticeTriangle::hasArea() const
{
    return firstSign(normal_) != 0;
}


int latticeTriangle::side(const latticePoint& x) const
{
    const latticePoint r(minus(x, corners_[0]));
    const int exact =
        sign(normal_[0]*r[0] + normal_[1]*r[1] + normal_[2]*r[2]);

    // In the plane: the scalar product of the normal with the infinitesimal
    return exact != 0 ? exact : firstSign(normal_);
}


int latticeTriangle::side
(
    int i,
    const latticePoint& p,
    const latticePoint& d
) const
{
    const latticePoint& a = corners_[i];
    const latticePoint& b = corners_[(i + 1)%3];
    const wide v(cross(minus(a, p), minus(b, p)));
    const int exact = sign(v[0]*d[0] + v[1]*d[1] + v[2]*d[2]);

    // Through the edge: p shifted by the infinitesimal
    return exact != 0 ? exact : -firstSign(cross(minus(b, a), d));
}


int latticeTriangle::passes(const latticePoint& p, const latticePoint& q) const
{
    const int from = side(p);
    if (from == side(q))
    {
        return 0;
    }

    const latticePoint d(minus(q, p));
    for (int i = 0; i < 3; ++i)
    {
        // A line along the normal's direction has all edges to its left
        if (side(i, p, d) != -from)
        {
            return 0;
        }
    }
    return -from;
}

} // End namespace plateletDynamics
