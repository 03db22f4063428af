/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "wallRegions.H"

#include <Eigen/Geometry>

namespace plateletDynamics
{

wallRegions::triangle::triangle
(
    const boundarySurface::triangle& from,
    const vector& shift
)
:
    surfaceTriangle
    ({
        from.corners[0] + shift,
        from.corners[1] + shift,
        from.corners[2] + shift
    }),
    does(from.does),
    patch(from.patch),
    opaque(from.opaque)
{}


bounds wallRegions::triangle::around() const
{
    return
    {
        corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
        corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])
    };
}


wallRegions::wallRegions
(
    const boundarySurface& surface,
    const periodicBox& space,
    double reach
)
{
    addImages(surface, space);
    connect(surface.featureAngle);
    dropFar(space, reach);
    collect();
}


void wallRegions::addImages
(
    const boundarySurface& surface,
    const periodicBox& space
)
{
    // Whole images, so that what is connected through one stays connected
    for (const vector& shift : space.shifts())
    {
        for (const auto& from : surface.triangles)
        {
            const triangle made(from, shift);

            // Without area there is no normal
            if (made.normal.squaredNorm() > 0.5)
            {
                triangles_.push_back(made);
            }
        }
    }
}


void wallRegions::dropFar(const periodicBox& space, double reach)
{
    const auto far = [&](const triangle& t)
    {
        const bounds b(t.around());

        for (int axis = 0; axis < 3; ++axis)
        {
            if
            (
                space.periodic[axis]
             && (
                    b.lower[axis] > space.upper[axis] + reach
                 || b.upper[axis] < space.lower[axis] - reach
                )
            )
            {
                return true;
            }
        }
        return false;
    };

    triangles_.erase
    (
        std::remove_if(triangles_.begin(), triangles_.end(), far),
        triangles_.end()
    );
}


void wallRegions::collect()
{
    std::stable_sort
    (
        triangles_.begin(), triangles_.end(),
        [](const triangle& a, const triangle& b) { return a.region < b.region; }
    );

    for (std::size_t begin = 0; begin < triangles_.size(); )
    {
        std::vector<bounds> triangleBounds;
        region made;
        made.does = triangles_[begin].does;
        made.opaque = triangles_[begin].opaque;
        made.begin = int(begin);
        made.planar = true;

        const triangle& first = triangles_[begin];
        std::size_t end = begin;

        for
        (
            ;
            end < triangles_.size() && triangles_[end].region == first.region;
            ++end
        )
        {
            const triangle& t = triangles_[end];
            const vector normal(first.normal);
            const double size = (t.corners[1] - t.corners[0]).norm();

            triangleBounds.push_back(t.around());
            for (const vector& corner : t.corners)
            {
                made.planar =
                    made.planar
                 && std::abs(first.height(corner)) < 1e-9*size
                 && t.normal.dot(normal) > 0;
            }
        }

        made.tree = boxTree(std::move(triangleBounds));
        regions_.push_back(std::move(made));
        begin = end;
    }

    for (std::size_t i = 0; i < regions_.size(); ++i)
    {
        const std::size_t end =
            i + 1 < regions_.size()
          ? regions_[i + 1].begin
          : triangles_.size();

        for (std::size_t t = regions_[i].begin; t < end; ++t)
        {
            triangles_[t].region = int(i);
        }
    }

    using action = boundarySurface::action;

    pushing_ = someRegions
    (
        regions_, [](const region& r) { return r.does == action::platelet; }
    );
    crossed_ = someRegions
    (
        regions_, [](const region& r) { return r.does != action::platelet; }
    );
    rock_ = someRegions
    (
        regions_,
        [](const region& r) { return r.opaque && r.does != action::absorb; }
    );
}


wallRegions::foot wallRegions::nearest(int number, const vector& x) const
{
    const triangle& t = triangles_[number];
    const surfaceTriangle::foot foot(t.surfaceTriangle::nearest(x));

    if (foot.feature == surfaceTriangle::foot::face)
    {
        return {foot.point, t.normal, true, false, true};
    }

    const bool rim = t.rim[foot.feature];
    return
    {
        foot.point,
        outward_[t.outward[foot.feature]],
        false,
        rim,
        !rim && regions_[t.region].planar
    };
}

} // End namespace plateletDynamics
