/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <Eigen/Dense>

#include "quadraticGradient.H"

namespace
{

using column = Eigen::VectorXd;

//- Cells in one layer have their centres within this part of the cell's half
//  thickness; those of other layers are farther than it
constexpr double singleLayer = 0.2;

//- Part of a term that the others do not make up, from which on it is fitted.
//  Lower, a term of the wanted field would be found from a small difference
//  of large ones
constexpr double distinct = 0.05;


//- Orthonormal columns and the terms that they are made of
struct basis
{
    std::vector<column> terms;
    std::vector<column> directions;

    //- Keep the term if those before do not make it up nearly
    bool take(const column& term)
    {
        const double length = term.norm();
        column rest(term);

        // Twice is enough (Kahan)
        for (int pass = 0; pass < 2; ++pass)
        {
            for (const column& q : directions)
            {
                rest -= q.dot(rest)*q;
            }
        }
        if (!(rest.norm() > distinct*length))
        {
            return false;
        }
        terms.push_back(term);
        directions.push_back(rest.normalized());
        return true;
    }
};

} // End anonymous namespace


Foam::vectorField Foam::quadraticGradient::weights
(
    const UList<vector>& separations,
    const UList<vector>& corners
)
{
    const label n = separations.size();
    vectorField result(n, Zero);

    scalar longest = 0;
    for (const vector& d : separations)
    {
        longest = max(longest, mag(d));
    }
    if (longest <= 0)
    {
        return result;
    }

    // Principal directions of the stencil, in units of its radius
    Eigen::MatrixX3d place(n, 3);
    forAll(separations, i)
    {
        const vector d(separations[i]/longest);
        place.row(i) << d.x(), d.y(), d.z();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal
    (
        place.transpose()*place
    );
    // Coordinates along those that are spanned, each in its own unit; they come
    // in increasing order
    std::vector<column> along;
    std::vector<Eigen::Vector3d> inverse;
    for (int axis = 2; axis >= 0; --axis)
    {
        const Eigen::Vector3d unit(principal.eigenvectors().col(axis));
        const column x(place*unit);
        const scalar spread = x.norm()/Foam::sqrt(scalar(n));

        const vector direction(unit[0], unit[1], unit[2]);
        scalar halfThickness = 0;
        for (const vector& corner : corners)
        {
            halfThickness = max(halfThickness, mag(corner & direction));
        }

        if (spread*longest > singleLayer*halfThickness)
        {
            along.push_back(x/spread);
            inverse.push_back(unit/(spread*longest));
        }
    }
    const std::size_t dimensions = along.size();

    column weight(column::Zero(n));
    for (const column& x : along)
    {
        weight += x.cwiseAbs2();
    }
    weight = weight.cwiseSqrt().cwiseInverse();

    // Those that matter most first
    basis fit;
    std::vector<Eigen::Vector3d> taken;
    for (std::size_t a = 0; a < dimensions; ++a)
    {
        if (fit.take(weight.cwiseProduct(along[a])))
        {
            taken.push_back(inverse[a]);
        }
    }
    for (std::size_t apart = 0; apart < dimensions; ++apart)
    {
        for (std::size_t a = 0; a + apart < dimensions; ++a)
        {
            fit.take
            (
                weight.cwiseProduct(along[a]).cwiseProduct(along[a + apart])
            );
        }
    }

    Eigen::MatrixXd terms(n, fit.terms.size());
    for (std::size_t t = 0; t < fit.terms.size(); ++t)
    {
        terms.col(t) = fit.terms[t];
    }

    // The rows of the pseudo-inverse that belong to the gradient
    const Eigen::MatrixXd solved
    (
        terms.householderQr().solve
        (
            Eigen::MatrixXd(weight.asDiagonal())
        )
    );
    for (std::size_t a = 0; a < taken.size(); ++a)
    {
        forAll(result, i)
        {
            const Eigen::Vector3d w(solved(a, i)*taken[a]);
            result[i] += vector(w[0], w[1], w[2]);
        }
    }
    return result;
}
