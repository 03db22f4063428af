/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "surfaceCounters.H"

#include "userError.H"

#include <algorithm>
#include <cmath>

namespace plateletDynamics
{

namespace
{

//- The lattice has so many places across all that one look has to do with. One
//  bit less than latticeTriangle bears, for what rounding adds
constexpr int latticeBits = latticeTriangle::mostBits - 1;

//- Of a period, whose places need not meet in one product
constexpr int mostPeriodBits = 60;

} // End namespace


surfaceCounters::surfaceCounters
(
    const std::vector<countedSurface>& surfaces,
    const periodicBox& space,
    double longest
)
:
    space_(space),
    passages_(surfaces.size())
{
    bounds around;
    for (const countedSurface& surface : surfaces)
    {
        for (const std::array<vector, 3>& corners : surface.triangles)
        {
            for (const vector& corner : corners)
            {
                if (!isFinite(corner))
                {
                    throw userError
                    (
                        "A corner of a counted surface is not finite"
                    );
                }
                around.include(corner);
            }
        }
    }
    if (around.empty())
    {
        return;
    }
    chooseLattice(around, longest);

    std::vector<bounds> boxes;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
        for (const std::array<vector, 3>& corners : surfaces[i].triangles)
        {
            const latticeTriangle onLattice
            ({
                place(corners[0]), place(corners[1]), place(corners[2])
            });

            if (onLattice.hasArea())
            {
                triangles_.emplace_back(corners);
                onLattice_.push_back(onLattice);
                surfaceOf_.push_back(int(i));
                boxes.emplace_back();
                for (const vector& corner : corners)
                {
                    boxes.back().include(corner);
                }
            }
        }
    }
    tree_ = boxTree(std::move(boxes));
}


void surfaceCounters::chooseLattice(const bounds& around, double longest)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        const double extent =
            around.upper[axis] - around.lower[axis] + 2*longest;

        unit_[axis] = std::ldexp(extent, -latticeBits);
        origin_[axis] = around.lower[axis];

        if (space_.periodic[axis])
        {
            // A period is a whole number of units, and its ends are places
            const double period = space_.period(axis);
            const int bits = std::min
            (
                std::ilogb(period/unit_[axis]), mostPeriodBits
            );
            period_[axis] = std::int64_t(1) << bits;
            unit_[axis] = std::ldexp(period, -bits);
            origin_[axis] = space_.lower[axis];
        }
        longest_[axis] = longest/unit_[axis];
    }
}


latticePoint surfaceCounters::place(const vector& x) const
{
    latticePoint p;
    for (int axis = 0; axis < 3; ++axis)
    {
        p[axis] = std::llround((x[axis] - origin_[axis])/unit_[axis]);
    }
    return p;
}


std::array<std::int64_t, 2> surfaceCounters::periodsToMeet
(
    int axis,
    double lower,
    double upper,
    double toLower,
    double toUpper
) const
{
    const double period = unit_[axis]*double(period_[axis]);

    if (period <= 0)
    {
        return {0, 0};
    }
    return
    {
        std::llround(std::ceil((toLower - upper)/period - 1e-9)),
        std::llround(std::floor((toUpper - lower)/period + 1e-9))
    };
}


void surfaceCounters::list
(
    const kernelPoints& points,
    double reach,
    double holdsWithin
)
{
    clearance_.clear();
    stepSquared_.clear();
    listed_.clear();

    if (empty())
    {
        return;
    }
    listed_.assign
    (
        points.position.begin(), points.position.begin() + points.owned
    );

    // Images of the platelets that can be within the reach
    const bounds& all = tree_.around();
    std::array<std::array<std::int64_t, 2>, 3> times;
    for (int axis = 0; axis < 3; ++axis)
    {
        times[axis] = periodsToMeet
        (
            axis,
            space_.lower[axis], space_.upper[axis],
            all.lower[axis] - reach, all.upper[axis] + reach
        );
    }
    std::vector<vector> shifts;
    for (std::int64_t i = times[0][0]; i <= times[0][1]; ++i)
    for (std::int64_t j = times[1][0]; j <= times[1][1]; ++j)
    for (std::int64_t k = times[2][0]; k <= times[2][1]; ++k)
    {
        shifts.emplace_back
        (
            double(i)*space_.period(0),
            double(j)*space_.period(1),
            double(k)*space_.period(2)
        );
    }

    // Rounding must not hide a passage
    const double tolerance = 1e-9*reach + 4*unit_.maxCoeff();

    for (std::size_t k = 0; k < listed_.size(); ++k)
    {
        double nearest = reach*reach;

        for (const vector& shift : shifts)
        {
            const vector x(listed_[k] + shift);
            tree_.near
            (
                x,
                nearest,
                [&](int item)
                {
                    const vector foot(triangles_[item].nearest(x).point);
                    nearest = std::min(nearest, (foot - x).squaredNorm());
                }
            );
        }
        clearance_.push_back((1 - 1e-9)*std::sqrt(nearest) - tolerance);

        // How far they have moved is known in units of kernelPoints
        const double step =
            std::max(clearance_.back() - (1 + 1e-5)*holdsWithin, 0.0);
        stepSquared_.push_back(step*step);
    }
}


void surfaceCounters::countStraight
(
    const latticePoint& p,
    const latticePoint& q
)
{
    if (p == q)
    {
        return;
    }

    bounds way;
    for (const latticePoint& end : {p, q})
    {
        way.include
        (
            origin_
          + unit_.cwiseProduct
            (
                vector(double(end[0]), double(end[1]), double(end[2]))
            )
        );
    }

    const double tolerance = 4*unit_.maxCoeff();
    const bounds& all = tree_.around();
    std::array<std::array<std::int64_t, 2>, 3> times;
    for (int axis = 0; axis < 3; ++axis)
    {
        times[axis] = periodsToMeet
        (
            axis,
            way.lower[axis], way.upper[axis],
            all.lower[axis] - tolerance, all.upper[axis] + tolerance
        );
    }

    for (std::int64_t i = times[0][0]; i <= times[0][1]; ++i)
    for (std::int64_t j = times[1][0]; j <= times[1][1]; ++j)
    for (std::int64_t k = times[2][0]; k <= times[2][1]; ++k)
    {
        const latticePoint shift
        {
            i*period_[0], j*period_[1], k*period_[2]
        };
        latticePoint from(p);
        latticePoint to(q);
        bounds moved(way);
        for (int axis = 0; axis < 3; ++axis)
        {
            from[axis] += shift[axis];
            to[axis] += shift[axis];
            moved.lower[axis] += unit_[axis]*double(shift[axis]);
            moved.upper[axis] += unit_[axis]*double(shift[axis]);
        }

        tree_.near
        (
            moved,
            tolerance,
            [&](int item)
            {
                const int passed = onLattice_[item].passes(from, to);

                passages& sum = passages_[surfaceOf_[item]];
                sum.forward += passed > 0;
                sum.backward += passed < 0;
            }
        );
    }
}


void surfaceCounters::count
(
    const vector& from,
    const vector& d,
    const vector& to
)
{
    // Along open axes the lattice ends not far from the surfaces
    const bounds& all = tree_.around();
    for (int axis = 0; axis < 3; ++axis)
    {
        const double tolerance = 4*unit_[axis];
        if
        (
            !period_[axis]
         && (
                std::max(from[axis], to[axis]) < all.lower[axis] - tolerance
             || std::min(from[axis], to[axis]) > all.upper[axis] + tolerance
            )
        )
        {
            return;
        }
    }

    vector inside(from);
    space_.wrap(inside);
    latticePoint p(place(inside));

    inside = to;
    space_.wrap(inside);
    latticePoint end(place(inside));

    // To the image that d leads to
    double pieces = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
        if (period_[axis])
        {
            const double missing =
                double(p[axis] - end[axis]) + d[axis]/unit_[axis];

            end[axis] +=
                period_[axis]*std::llround(missing/double(period_[axis]));
        }
        pieces = std::max
        (
            pieces,
            std::ceil(std::abs(double(end[axis] - p[axis]))/longest_[axis])
        );
    }

    for (double left = pieces; left > 0; --left)
    {
        latticePoint q(end);
        for (int axis = 0; axis < 3 && left > 1; ++axis)
        {
            q[axis] =
                p[axis] + std::llround(double(end[axis] - p[axis])/left);
        }
        countStraight(p, q);
        p = q;
    }
}

} // End namespace plateletDynamics
