/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    kernelFilter against its plain twin, which does not know of ranks, bins or
    messages, and against what the filter promises. The same with one rank and
    with several: the meshes are decomposed in memory.
\*---------------------------------------------------------------------------*/

#include "boxMesh.H"
#include "kernelFilter.H"
#include "plainFilter.H"

#include <gtest/gtest.h>

#include <random>

using namespace Foam;

namespace
{

// A 10 nm mesh is the smallest in use; SI, so that absolute tolerances show
constexpr scalar nm = 1e-9;
constexpr scalar plateletVolume = 3.14159e-23;

// Sums of some thousand terms in another order
constexpr scalar roundOff = 1e-12;

// At the kernel's edge t = 1 - q has lost digits, and with it the weights of
// velocities where all platelets are that far
constexpr scalar roundOffAtEdge = 1e-10;


//- Cells of 10 nm, nodes moved by up to a fifth of a cell (not those at the
//  ends, so that periodic ends match)
boxSettings irregularBox(const indices& n)
{
    boxSettings box;
    box.n = n;
    box.size = 10*nm*vector(n[0], n[1], n[2]);
    box.map = [n](const point& regular, const indices& at)
    {
        point p(regular);
        for (int axis = 0; axis < 3; ++axis)
        {
            // Some hash of the indices, the same on all ranks and, around
            // periodic axes, at both ends
            std::mt19937 random
            (
                at[0]%n[0] + 100*(at[1]%n[1]) + 10000*(at[2]%n[2])
              + 1000000*axis
            );
            if (at[axis] > 0 && at[axis] < n[axis])
            {
                p[axis] +=
                    std::uniform_real_distribution<>(-2*nm, 2*nm)(random);
            }
        }
        return p;
    };
    return box;
}


//- Every rank touches many others
int patchwork(const indices& cell)
{
    return (cell[0]/3 + cell[1]/2 + cell[2]/2)%Pstream::nProcs();
}


//- A mesh, the platelets of all ranks, the fields of the filter and the twin
struct scene
{
    boxMesh box;
    plainCells cells;
    std::vector<plainPlatelet> all;

    pointField positions;
    vectorField velocities;
    labelList owners;

    volScalarField alpha;
    volVectorField U;

    template<class Type>
    static GeometricField<Type, fvPatchField, volMesh> field
    (
        const char* name,
        const fvMesh& mesh,
        const dimensionSet& dimensions
    )
    {
        return GeometricField<Type, fvPatchField, volMesh>
        (
            IOobject(name, mesh.time().timeName(), mesh),
            mesh,
            dimensioned<Type>(dimensions, Zero)
        );
    }

    scene(const boxSettings& settings, const label count)
    :
        box(settings),
        cells(box.mesh()),
        alpha(field<scalar>("alpha.clay", box.mesh(), dimless)),
        U(field<vector>("U.clay", box.mesh(), dimVelocity))
    {
        std::mt19937_64 random(20171);
        std::uniform_real_distribution<> uniform;

        DynamicList<point> myPositions;
        DynamicList<vector> myVelocities;
        DynamicList<label> myCells;
        labelList cell(count, -1);

        for (label k = 0; k < count; ++k)
        {
            plainPlatelet platelet;
            for (int axis = 0; axis < 3; ++axis)
            {
                platelet.position[axis] =
                    settings.size[axis]*uniform(random);
                platelet.velocity[axis] = 1e-5*(uniform(random) - 0.3);
            }
            all.push_back(platelet);

            const label celli = box.cellAt(platelet.position);
            if (celli >= 0)
            {
                myPositions.append(platelet.position);
                myVelocities.append(platelet.velocity);
                myCells.append(celli);
                cell[k] = cells.first + celli;
            }
        }
        positions = myPositions;
        velocities = myVelocities;
        owners = myCells;

        Pstream::listCombineGather(cell, maxEqOp<label>());
        Pstream::listCombineScatter(cell);
        for (label k = 0; k < count; ++k)
        {
            all[k].cell = cell[k];
        }
    }

    void update(kernelFilter& filter, const scalar deltaT = 0)
    {
        filter.update
        (
            positions,
            owners,
            velocities,
            plateletVolume,
            deltaT,
            alpha,
            U
        );
    }

    plainFields plain(const kernelFilter& filter, const scalar cube) const
    {
        const periodicAxes& axes = filter.axes();
        return plainFilter
        (
            cells,
            all,
            filter.length(),
            cube,
            vector(axes.period(0), axes.period(1), axes.period(2)),
            plateletVolume
        );
    }

    //- Clay in the mesh over the clay of the platelets, less 1
    scalar excess() const
    {
        return
            gSum(scalarField(alpha.primitiveField()*box.mesh().V()))
           /(all.size()*plateletVolume)
          - 1;
    }

    //- Largest difference from the twin's fields, over their largest value
    scalar alphaError(const plainFields& twin) const
    {
        scalar worst = 0;
        forAll(alpha, celli)
        {
            worst = max
            (
                worst,
                mag(alpha[celli] - twin.alpha[cells.first + celli])
            );
        }
        return returnReduce(worst, maxOp<scalar>())/max(twin.alpha);
    }

    scalar velocityError(const plainFields& twin) const
    {
        scalar worst = 0;
        forAll(U, celli)
        {
            worst = max(worst, mag(U[celli] - twin.U[cells.first + celli]));
        }
        return returnReduce(worst, maxOp<scalar>())/max(mag(twin.U));
    }
};


//- Axes, lengths and decompositions that a mesh of 10 nm cells is tried with
struct variant
{
    const char* name;
    indices n;
    std::array<bool, 3> periodic;
    scalar length;
    bool patches;
};

std::ostream& operator<<(std::ostream& os, const variant& v)
{
    return os << v.name;
}


class filterOfCells
:
    public testing::TestWithParam<variant>
{
protected:

    boxSettings settings() const
    {
        boxSettings box(irregularBox(GetParam().n));
        box.periodic = GetParam().periodic;
        if (GetParam().patches)
        {
            box.rank = patchwork;
        }
        return box;
    }
};

} // End anonymous namespace


TEST_P(filterOfCells, equalsPlainTwin)
{
    scene s(settings(), 60);
    kernelFilter filter(s.box.mesh(), GetParam().length, 0);
    s.update(filter);

    const plainFields twin(s.plain(filter, 0));
    EXPECT_LT(s.alphaError(twin), roundOff);
    EXPECT_LT(s.velocityError(twin), roundOffAtEdge);
}


TEST_P(filterOfCells, conservesClay)
{
    scene s(settings(), 60);
    kernelFilter filter(s.box.mesh(), GetParam().length, 0);
    s.update(filter);

    EXPECT_LT(mag(s.excess()), roundOff);
}


TEST_P(filterOfCells, reproducesConstantVelocity)
{
    scene s(settings(), 60);
    const vector velocity(1e-5, -3e-6, 2e-7);
    s.velocities = velocity;

    kernelFilter filter(s.box.mesh(), GetParam().length, 0);
    s.update(filter);

    forAll(s.U, celli)
    {
        const vector expected(s.alpha[celli] > 0 ? velocity : vector(Zero));
        EXPECT_LT(mag(s.U[celli] - expected), roundOff*mag(velocity));
    }
}


INSTANTIATE_TEST_SUITE_P
(
    kernelFilter,
    filterOfCells,
    testing::Values
    (
        variant{"open", {{12, 9, 7}}, {{false, false, false}}, 25*nm, false},
        variant{"patchwork", {{12, 9, 7}}, {{false, false, false}}, 31*nm, true},
        variant{"channel", {{12, 9, 7}}, {{true, false, true}}, 28*nm, false},
        variant{"periodic", {{12, 9, 7}}, {{true, true, true}}, 33*nm, true},
        // A kernel as wide as the box meets several images of a cell
        variant{"wide", {{5, 4, 4}}, {{true, true, true}}, 42*nm, false},
        // Half of the platelets reach no cell centre
        variant{"narrow", {{8, 6, 4}}, {{true, false, false}}, 5*nm, false},
        // One cell across a periodic axis
        variant{"sheet", {{8, 6, 1}}, {{true, false, true}}, 22*nm, true}
    ),
    [](const testing::TestParamInfo<variant>& info)
    {
        return std::string(info.param.name);
    }
);


namespace
{

class filterOfFineMesh
:
    public testing::TestWithParam<variant>
{
protected:

    boxSettings settings() const
    {
        boxSettings box(irregularBox(GetParam().n));
        box.periodic = GetParam().periodic;
        if (GetParam().patches)
        {
            box.rank = patchwork;
        }
        return box;
    }
};

} // End anonymous namespace


TEST_P(filterOfFineMesh, equalsPlainTwinOfAggregates)
{
    scene s(settings(), 40);
    const scalar length = GetParam().length;
    kernelFilter filter(s.box.mesh(), length, 0);
    s.update(filter);

    const plainFields twin
    (
        s.plain(filter, length/kernelFilter::cubesPerLength)
    );
    EXPECT_LT(s.alphaError(twin), roundOff);
    EXPECT_LT(s.velocityError(twin), roundOffAtEdge);
    EXPECT_LT(mag(s.excess()), roundOff);
    EXPECT_GE(gMin(s.alpha), 0);
}


INSTANTIATE_TEST_SUITE_P
(
    kernelFilter,
    filterOfFineMesh,
    testing::Values
    (
        // Two to three cells per edge of an aggregate
        variant{"open", {{24, 15, 12}}, {{false, false, false}}, 150*nm, false},
        variant{"periodic", {{24, 15, 12}}, {{true, false, true}}, 150*nm, true},
        // Some aggregates have one cell, others up to eight
        variant{"mixed", {{20, 12, 10}}, {{true, true, true}}, 80*nm, true},
        // Few platelets: gradients are limited in most aggregates
        variant{"edges", {{24, 15, 12}}, {{false, false, false}}, 60*nm, true}
    ),
    [](const testing::TestParamInfo<variant>& info)
    {
        return std::string(info.param.name);
    }
);
