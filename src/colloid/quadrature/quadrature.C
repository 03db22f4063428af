/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "quadrature.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Positive half of the nodes on [-1, 1] and their weights
constexpr Foam::scalar nodes[8][2] =
{
    {0.0950125098376374402, 0.189450610455068496},
    {0.281603550779258913, 0.182603415044923589},
    {0.458016777657227386, 0.169156519395002538},
    {0.617876244402643748, 0.149595988816576732},
    {0.755404408355003034, 0.124628971255533872},
    {0.865631202387831744, 0.0951585116824927848},
    {0.944575023073232576, 0.0622535239386478929},
    {0.989400934991649933, 0.0271524594117540949}
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::integralOverPanel
(
    const std::function<scalar(scalar)>& f,
    const scalar lower,
    const scalar upper
)
{
    const scalar centre = 0.5*(lower + upper);
    const scalar halfWidth = 0.5*(upper - lower);

    scalar sum = 0;

    for (const auto& node : nodes)
    {
        const scalar offset = halfWidth*node[0];
        sum += node[1]*(f(centre - offset) + f(centre + offset));
    }

    return halfWidth*sum;
}


Foam::scalar Foam::colloid::integralToInfinity
(
    const std::function<scalar(scalar)>& f,
    const scalar lower,
    const scalar decayLength
)
{
    scalar sum = 0;
    scalar from = lower;

    // Panels that double their end while the function is a power law and are
    // two decay lengths wide when it is an exponential: 16 points are exact to
    // rounding on both
    while (true)
    {
        const scalar to = from + std::min(from, 2*decayLength);
        const scalar part = integralOverPanel(f, from, to);

        sum += part;
        from = to;

        // The rest is less than the last exponential panel
        if (from > 2*decayLength && part <= 1e-17*sum)
        {
            return sum;
        }
    }
}


// ************************************************************************* //
