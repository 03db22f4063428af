/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Finds which triangles form smooth regions, and which side of their edges
    and corners is the water's.
\*---------------------------------------------------------------------------*/

#include "wallRegions.H"

#include "vertexWeld.H"

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace plateletDynamics
{

namespace
{

constexpr double pi = 3.14159265358979323846;


//- Sets of triangles that are connected
class connectedSets
{
    std::vector<int> parent_;

public:

    explicit connectedSets(std::size_t count)
    :
        parent_(count)
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    int find(int i)
    {
        while (parent_[i] != i)
        {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }

    void join(int i, int j)
    {
        // The lower number stays, whatever the order of joining
        const auto [low, high] = std::minmax({find(i), find(j)});
        parent_[high] = low;
    }
};


//- An edge or corner of a triangle, at a vertex or pair of vertices
struct place
{
    int first;
    int second;
    int triangle;
    int number;

    bool same(const place& other) const
    {
        return first == other.first && second == other.second;
    }
};


//- Call use(begin, end) for each group of features at the same place
template<class Use>
void forEachPlace(std::vector<place>& places, const Use& use)
{
    std::stable_sort
    (
        places.begin(), places.end(),
        [](const place& a, const place& b)
        {
            return
                std::make_pair(a.first, a.second)
              < std::make_pair(b.first, b.second);
        }
    );

    for (auto begin = places.begin(); begin != places.end(); )
    {
        auto end = begin;
        while (end != places.end() && end->same(*begin))
        {
            ++end;
        }
        use(begin, end);
        begin = end;
    }
}


//- Number of the vertex at each corner of each triangle
std::vector<std::array<int, 3>> vertices
(
    const std::vector<wallRegions::triangle>& triangles
)
{
    std::vector<vector> points;
    std::vector<double> tolerance;

    for (const auto& t : triangles)
    {
        const double shortest =
            std::min
            ({
                (t.corners[1] - t.corners[0]).norm(),
                (t.corners[2] - t.corners[1]).norm(),
                (t.corners[0] - t.corners[2]).norm()
            });

        for (const vector& corner : t.corners)
        {
            points.push_back(corner);
            tolerance.push_back(1e-4*shortest);
        }
    }

    const std::vector<int> number(vertexWeld(points, tolerance));
    std::vector<std::array<int, 3>> all(triangles.size());

    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
        all[t] = {number[3*t], number[3*t + 1], number[3*t + 2]};
    }
    return all;
}


double cornerAngle(const surfaceTriangle& t, int corner)
{
    const vector a(t.corners[(corner + 1)%3] - t.corners[corner]);
    const vector b(t.corners[(corner + 2)%3] - t.corners[corner]);

    return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // End namespace


void wallRegions::connect(double featureAngle)
{
    const double smooth = std::cos(featureAngle*pi/180);
    const auto vertex(vertices(triangles_));

    std::vector<place> edges;
    std::vector<place> corners;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
        for (int i = 0; i < 3; ++i)
        {
            const auto [low, high] =
                std::minmax({vertex[t][i], vertex[t][(i + 1)%3]});

            edges.push_back
            (
                {low, high, int(t), surfaceTriangle::foot::edge + i}
            );
            corners.push_back
            (
                {vertex[t][i], 0, int(t), surfaceTriangle::foot::corner + i}
            );
        }
    }

    const auto joined = [&](int a, int b)
    {
        return
            triangles_[a].does == triangles_[b].does
         && triangles_[a].opaque == triangles_[b].opaque
         && triangles_[a].normal.dot(triangles_[b].normal) > smooth;
    };

    connectedSets sets(triangles_.size());
    forEachPlace
    (
        edges,
        [&](auto begin, auto end)
        {
            for (auto a = begin; a != end; ++a)
            {
                for (auto b = a + 1; b != end; ++b)
                {
                    if (joined(a->triangle, b->triangle))
                    {
                        sets.join(a->triangle, b->triangle);
                    }
                }
            }
        }
    );
    for (std::size_t t = 0; t < triangles_.size(); ++t)
    {
        triangles_[t].region = sets.find(int(t));
    }

    // The rim of a region: edges that no neighbour of the region continues
    forEachPlace
    (
        edges,
        [&](auto begin, auto end)
        {
            for (auto a = begin; a != end; ++a)
            {
                vector own(vector::Zero());
                vector all(vector::Zero());
                bool rim = true;

                for (auto b = begin; b != end; ++b)
                {
                    const bool continues = joined(a->triangle, b->triangle);
                    const vector& normal = triangles_[b->triangle].normal;

                    all += normal;
                    own += continues ? normal : vector::Zero();
                    rim = rim && (a == b || !continues);
                }

                triangle& t = triangles_[a->triangle];
                t.rim[a->number] = rim;
                t.outward[a->number] = int(outward_.size());
                outward_.push_back(rim ? all : own);
            }
        }
    );

    forEachPlace
    (
        corners,
        [&](auto begin, auto end)
        {
            for (auto a = begin; a != end; ++a)
            {
                triangle& t = triangles_[a->triangle];
                vector own(vector::Zero());
                vector all(vector::Zero());
                bool rim = false;

                for (auto b = begin; b != end; ++b)
                {
                    const triangle& other = triangles_[b->triangle];
                    const int corner =
                        b->number - surfaceTriangle::foot::corner;

                    const vector weighted
                    (
                        cornerAngle(other, corner)*other.normal
                    );

                    all += weighted;
                    if (other.region == t.region)
                    {
                        own += weighted;

                        // The edges on either side of the corner
                        rim =
                            rim
                         || other.rim[corner]
                         || other.rim[(corner + 2)%3];
                    }
                }

                t.rim[a->number] = rim;
                t.outward[a->number] = int(outward_.size());
                outward_.push_back(rim ? all : own);
            }
        }
    );
}

} // End namespace plateletDynamics
