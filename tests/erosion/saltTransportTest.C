/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "transportCase.H"
#include "saltTransport.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

namespace
{

constexpr scalar D = 1e-6;
constexpr scalar duration = 400;

//- Concentration of a half line with 1 at its end, carried at this velocity
//  (Ogata and Banks 1961)
scalar OgataBanks(const scalar x, const scalar velocity)
{
    const scalar spread = 2*std::sqrt(D*duration);

    return 0.5*
    (
        std::erfc((x - velocity*duration)/spread)
      + std::exp(velocity*x/D)*std::erfc((x + velocity*duration)/spread)
    );
}

//- Largest error of what the transport gives, the flux of water being U per
//  area of the mesh
scalar errorOfSalt
(
    const scalar U,
    const std::function<scalar(const vector&)>& apertureRatio,
    const scalar velocity
)
{
    transportCase t(bar(320, 0.16), {}, {});
    fvMesh& mesh = t.c.mesh();

    t.c.writeField
    (
        "c",
        "volScalarField",
        "[0 -3 0 0 1 0 0]",
        "uniform 0",
        {
            {"left", "type fixedValue; value uniform 1;"},
            {"right", "type fixedValue; value uniform 0;"}
        }
    );
    saltTransport salt
    (
        mesh, dictionaryOf("salt { model transported; diffusivity 1e-6; }")
    );
    const surfaceScalarField phi
    (
        "phi", mesh.Sf() & dimensionedVector("U", dimVelocity, vector(U, 0, 0))
    );
    const tmp<volScalarField> w(fieldOf(mesh, "w", dimless, apertureRatio));

    const label steps = 400;
    t.c.time().setDeltaT(duration/steps);
    for (label i = 0; i < steps; ++i)
    {
        ++t.c.time();
        salt.solve(phi, w());
    }

    scalar worst = 0;
    forAll(mesh.C(), celli)
    {
        worst = max
        (
            worst,
            mag
            (
                (*salt.concentration())[celli]
              - OgataBanks(mesh.C()[celli].x(), velocity)
            )
        );
    }
    return returnReduce(worst, maxOp<scalar>());
}

} // End anonymous namespace


// Euler's steps, 400 of them, leave some 1e-3
TEST(saltTransport, isCarriedAtTheVelocityInTheApertureAndDiffuses)
{
    const auto half = [](const vector&) { return 0.5; };

    EXPECT_LT(errorOfSalt(2.5e-5, half, 5e-5), 2e-3);
}


// d(w c)/dt = d(w D dc/dx)/dx with w = exp(k x): as if carried by -k D
TEST(saltTransport, diffusesIntoAnApertureThatWidens)
{
    const scalar k = 40;
    const auto widening = [=](const vector& x) { return std::exp(k*x.x()); };

    EXPECT_LT(errorOfSalt(0, widening, -k*D), 2e-3);
}
