/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    quadraticGradient against fields of which the gradient is known, on one
    rank and on several.
\*---------------------------------------------------------------------------*/

#include "boxMesh.H"
#include "quadraticGradient.H"

#include "mathematicalConstants.H"

#include <gtest/gtest.h>

#include <random>

using namespace Foam;

namespace
{

constexpr scalar nm = 1e-9;

//- Every rank touches many others
int patchwork(const indices& cell)
{
    return (cell[0]/3 + cell[1]/2 + cell[2]/2)%Pstream::nProcs();
}


//- A box of 100 nm, its inner nodes moved by up to a fifth of a cell along the
//  axes given, by a hash of their indices so that all ranks agree
boxSettings irregularBox(const indices& n, const vector& along = vector::one)
{
    boxSettings box;
    box.n = n;
    box.size = 100*nm*vector::one;
    box.rank = patchwork;
    box.map = [n, along](const point& regular, const indices& at)
    {
        point p(regular);
        for (int axis = 0; axis < 3; ++axis)
        {
            // A single layer is of prisms
            const label layer = n[2] == 1 ? 0 : at[2];
            std::mt19937 random
            (
                at[0]%n[0] + 100*(at[1]%n[1]) + 10000*layer + 1000000*axis
            );
            if (at[axis] > 0 && at[axis] < n[axis])
            {
                p[axis] += along[axis]*20*nm/n[axis]
                   *std::uniform_real_distribution<>(-1, 1)(random);
            }
        }
        return p;
    };
    return box;
}


//- A field, and its gradient
struct knownField
{
    std::function<scalar(const point&)> value;
    std::function<vector(const point&)> gradient;
};


//- 0.01 + g.x + x.H.x/2 + c (e.x)^3, all terms of the same order over 100 nm
knownField polynomial
(
    const unsigned seed,
    const scalar quadratic,
    const scalar cubic
)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<> uniform(-1, 1);
    const auto some = [&]{ return uniform(random); };

    const scalar L = 100*nm;
    const vector g(vector(some(), some(), some())/L);
    const symmTensor H
    (
        quadratic/sqr(L)
       *symmTensor(some(), some(), some(), some(), some(), some())
    );
    const vector e(vector(some(), some(), some())/L);

    return
    {
        [=](const point& x)
        {
            return 0.01 + (g & x) + 0.5*(x & H & x) + cubic*pow3(e & x);
        },
        [=](const point& x)
        {
            return vector(g + (H & x) + 3*cubic*sqr(e & x)*e);
        }
    };
}


//- Largest error of the gradient over all ranks, times 100 nm. The field varies
//  along these axes only
scalar errorOf
(
    const boxSettings& settings,
    const knownField& known,
    const vector& along = vector::one
)
{
    const boxMesh box(settings);
    const vectorField& C = box.mesh().cellCentres();

    scalarField values(C.size());
    forAll(C, celli)
    {
        values[celli] = known.value(cmptMultiply(along, C[celli]));
    }
    const vectorField found
    (
        quadraticGradient(box.mesh(), periodicAxes(box.mesh())).gradient(values)
    );

    scalar worst = 0;
    forAll(C, celli)
    {
        const vector wanted
        (
            cmptMultiply
            (
                along, known.gradient(cmptMultiply(along, C[celli]))
            )
        );
        worst = max(worst, mag(found[celli] - wanted)*100*nm);
    }
    reduce(worst, maxOp<scalar>());
    return worst;
}

} // End anonymous namespace


TEST(quadraticGradient, isExactForQuadraticFields)
{
    for (const unsigned seed : {1, 2, 3})
    {
        // At boundaries too, where stencils are one-sided; some ten terms of
        // order one, over a cell of a twelfth
        EXPECT_LT
        (
            errorOf(irregularBox({{12, 9, 7}}), polynomial(seed, 1, 0)),
            1e-12
        );
    }
}


TEST(quadraticGradient, isExactInFlatCells)
{
    boxSettings box(irregularBox({{9, 6, 6}}));
    const auto inner = box.map;
    box.map = [inner](const point& regular, const indices& at)
    {
        const point p(inner(regular, at));
        return point(p.x(), p.y(), 1e-3*p.z());
    };
    EXPECT_LT(errorOf(box, polynomial(4, 1, 0)), 1e-9);
}


TEST(quadraticGradient, isExactAlongASingleLayer)
{
    // Two directions, the field of them alone; across it there is no gradient
    boxSettings box(irregularBox({{12, 10, 1}}, vector(1, 1, 0)));
    EXPECT_LT(errorOf(box, polynomial(5, 1, 0), vector(1, 1, 0)), 1e-12);

    box.empty[2] = true;
    EXPECT_LT(errorOf(box, polynomial(5, 1, 0), vector(1, 1, 0)), 1e-12);
}


TEST(quadraticGradient, takesAnUnevenLayerForOneLayer)
{
    // Its top is uneven by 5 % of the thickness, and so are the centres, which
    // tell nothing about the gradient across
    boxSettings box(irregularBox({{12, 10, 1}}, vector(1, 1, 0)));
    const auto inner = box.map;
    box.map = [inner](const point& regular, const indices& at)
    {
        const scalar uneven = (7*at[0] + 3*at[1])%5/2.0 - 1;
        return point(inner(regular, at) + vector(0, 0, 5*nm*at[2]*uneven));
    };

    // The error is of third order, over a cell of a tenth; a gradient across
    // would be of some of it over one of the centres' differences
    EXPECT_LT(errorOf(box, polynomial(5, 1, 1), vector(1, 1, 0)), 0.2);
}


TEST(quadraticGradient, isExactForLinearFieldsInThinMeshes)
{
    EXPECT_LT
    (
        errorOf(irregularBox({{9, 2, 2}}), polynomial(6, 0, 0)), 1e-12
    );

    // A row of cells: one direction, in which quadratic fields are exact
    EXPECT_LT
    (
        errorOf
        (
            irregularBox({{12, 1, 1}}, vector(1, 0, 0)),
            polynomial(6, 1, 0),
            vector(1, 0, 0)
        ),
        1e-12
    );
}


TEST(quadraticGradient, errorOfThirdOrderTermsIsOfSecondOrder)
{
    // The same cells, refined: irregular at each refinement
    const auto error = [](const label n)
    {
        return errorOf(irregularBox({{n, n, n}}), polynomial(7, 1, 1));
    };
    const scalar coarse = error(8);
    const scalar fine = error(16);

    // The largest over eight times as many cells: a little less than the order
    EXPECT_GT(Foam::log(coarse/fine)/Foam::log(2.0), 1.8);
    EXPECT_LT(fine, 0.1);
}


TEST(quadraticGradient, reachesAcrossPeriods)
{
    const scalar k = constant::mathematical::twoPi/(100*nm);
    const knownField wave
    {
        [=](const point& x)
        {
            return Foam::sin(k*x.x() + 0.3)*Foam::cos(k*x.y());
        },
        [=](const point& x)
        {
            return k*vector
            (
                Foam::cos(k*x.x() + 0.3)*Foam::cos(k*x.y()),
                -Foam::sin(k*x.x() + 0.3)*Foam::sin(k*x.y()),
                0
            );
        }
    };
    const auto error = [&](const label n)
    {
        // Single in z: its neighbours across the period are itself
        boxSettings box(irregularBox({{n, n, 1}}, vector(1, 1, 0)));
        box.periodic = {{true, true, true}};
        return errorOf(box, wave);
    };
    const scalar coarse = error(16);
    const scalar fine = error(32);

    // Of the gradient's amplitude, 2 pi
    EXPECT_LT(fine, 0.02*constant::mathematical::twoPi);
    EXPECT_GT(Foam::log(coarse/fine)/Foam::log(2.0), 1.8);
}


TEST(quadraticGradient, isZeroWhereAPeriodHasTwoCells)
{
    boxSettings box(irregularBox({{8, 2, 1}}, vector::zero));
    box.periodic = {{false, true, false}};

    // Up and down along y: as far to one side as to the other
    const knownField zigzag
    {
        [=](const point& x) { return x.y() > 50*nm ? 1.0 : 0.0; },
        [=](const point&) { return vector(Zero); }
    };
    EXPECT_LT(errorOf(box, zigzag, vector(0, 1, 0)), 1e-12);
}
