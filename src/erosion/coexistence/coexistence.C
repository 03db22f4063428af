/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coexistence.H"
#include "quadrature.H"

#include <cmath>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;
using law = std::function<scalar(scalar)>;

//- Where f changes sign between a and b, by bisection of their logarithms
scalar root(const law& f, scalar a, scalar b)
{
    const bool rises = f(b) > 0;

    for (int i = 0; i < 200 && b > a*(1 + 1e-15); ++i)
    {
        const scalar middle = std::sqrt(a*b);

        ((f(middle) > 0) == rises ? b : a) = middle;
    }
    return std::sqrt(a*b);
}


//- Integrals of A dphi and A dphi/phi over a range, by panels of a tenth of a
//  decade
scalar integral(const law& f, const scalar from, const scalar to)
{
    const int panels =
        1 + int(std::ceil(10*std::abs(std::log10(to/from))));
    const scalar ratio = std::pow(to/from, 1.0/panels);

    scalar sum = 0;
    scalar a = from;

    for (int i = 0; i < panels; ++i)
    {
        const scalar b = i + 1 == panels ? to : a*ratio;
        sum += Foam::colloid::integralOverPanel(f, a, b);
        a = b;
    }
    return sum;
}

// Below it platelets feel nothing of each other: A = kT
constexpr scalar dilute = 1e-12;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coexistence::coexistence
(
    const std::function<scalar(scalar)>& A,
    const scalar largest
)
{
    const scalar ratio = 1.01;

    // The range of A < 0
    scalar phi = dilute;
    for (; phi < largest && A(phi) >= 0; phi *= ratio) {}

    if (phi >= largest && A(largest) >= 0)
    {
        return;
    }
    phi = Foam::min(phi, largest);
    lower_ = root(A, phi/ratio, phi);

    for (; phi < largest && A(phi) < 0; phi *= ratio) {}

    state_ = state::noGel;
    upper_ = largest;

    if (A(Foam::min(phi, largest)) < 0)
    {
        return;
    }
    upper_ = root(A, phi/ratio, Foam::min(phi, largest));

    // Pressure over the volume of a platelet, and potential, from the lower
    // end of the range on; below dilute those of an ideal gas
    const law potentialSlope = [&](const scalar x) { return A(x)/x; };
    const scalar kT = A(dilute);
    const scalar pressureAtLower = kT*dilute + integral(A, dilute, lower_);

    const auto pressureOfSol = [&](const scalar sol)
    {
        return
            sol < dilute
          ? kT*sol
          : pressureAtLower - integral(A, sol, lower_);
    };
    const scalar pressureAtUpper =
        pressureAtLower + integral(A, lower_, upper_);
    const scalar pressureAtLargest =
        pressureAtUpper + integral(A, upper_, largest);

    // Fraction of the gel with the pressure of the sol
    const auto gelOf = [&](const scalar sol)
    {
        const scalar p = pressureOfSol(sol);

        if (p >= pressureAtLargest)
        {
            return largest;
        }
        if (p <= pressureAtUpper)
        {
            return upper_;
        }
        return root
        (
            [&](const scalar gel)
            {
                return pressureAtUpper + integral(A, upper_, gel) - p;
            },
            upper_,
            largest
        );
    };

    // Potential of the gel less that of the sol
    const law excess = [&](const scalar sol)
    {
        const scalar belowDilute =
            sol < dilute ? kT*std::log(dilute/sol) : 0;

        return
            belowDilute
          + integral(potentialSlope, Foam::max(sol, dilute), gelOf(sol));
    };

    const scalar smallest = 1e-100;

    if (excess(smallest) < 0)
    {
        // What the sol has of clay is nothing
        gel_ = gelOf(smallest);
    }
    else
    {
        sol_ = root(excess, smallest, lower_);
        gel_ = gelOf(sol_);
    }
    if (gel_ < largest*(1 - 1e-9))
    {
        state_ = state::twoPhases;
    }
}
