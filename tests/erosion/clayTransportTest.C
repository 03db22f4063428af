/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowCase.H"
#include "clayTransport.H"
#include "rimSimilarity.H"
#include "fixedValueFvPatchFields.H"
#include "mathematicalConstants.H"
#include "OFstream.H"
#include "zeroGradientFvPatchFields.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

namespace
{

//- A flowCase with a solid fraction and its transport
struct transportCase
{
    flowCase c;

    const colloid::clayProperties matter;

    autoPtr<volScalarField> alpha;

    autoPtr<fractureFlow> flow;

    autoPtr<clayTransport> clay;


    transportCase
    (
        const boxSpec& spec,
        const wordList& fixed,
        const string& flowProperties,
        const string& erosionProperties,
        const word& ddt = "Euler",
        const string& controls = "",
        const string& properties =
            "water { concentration 0.1; } viscosity { gelStop off; }"
    )
    :
        c(spec),
        matter(dictionaryOf(properties))
    {
        c.writeClayProperties(properties);
        write
        (
            "fvSchemes",
            "ddtSchemes { default " + ddt + "; }"
            "gradSchemes { default Gauss linear; }"
            "divSchemes { div(phi,alpha.clay) Gauss vanLeer; }"
            "interpolationSchemes { default linear; }"
            "laplacianSchemes { default Gauss linear corrected; }"
            "snGradSchemes { default corrected; }"
        );
        write
        (
            "fvSolution",
            "solvers { alpha.clay { solver PBiCGStab; preconditioner DILU;"
            " tolerance 1e-14; relTol 1e-4; } }"
            "erosion {" + controls + "}"
        );
        c.mesh().fvSchemes::read();
        c.mesh().fvSolution::read();

        wordList types
        (
            c.mesh().boundary().size(), zeroGradientFvPatchScalarField::typeName
        );
        forAll(types, patchi)
        {
            const fvPatch& patch = c.mesh().boundary()[patchi];

            if (patch.coupled() || patch.type() == "empty")
            {
                types[patchi] = patch.type();
            }
            else if (fixed.found(patch.name()))
            {
                types[patchi] = fixedValueFvPatchScalarField::typeName;
            }
        }
        alpha.reset
        (
            new volScalarField
            (
                IOobject
                (
                    "alpha.clay",
                    c.time().timeName(),
                    c.mesh(),
                    IOobject::NO_READ,
                    IOobject::NO_WRITE,
                    false
                ),
                c.mesh(),
                dimensionedScalar(dimless, Zero),
                types
            )
        );
        flow = fractureFlow::New
        (
            c.mesh(), alpha(), dictionaryOf(flowProperties)
        );
        erosion = dictionaryOf(erosionProperties);
    }

    dictionary erosion;

    //- Once alpha is as it shall begin
    void makeTransport()
    {
        clay.reset
        (
            new clayTransport
            (
                alpha(),
                flow->phi(),
                flow->apertureRatio(),
                nullptr,
                matter,
                erosion
            )
        );
    }

    void write(const word& name, const string& text)
    {
        if (Pstream::master())
        {
            OFstream os(c.time().globalPath()/"system"/name);
            os  << "FoamFile { version 2.0; format ascii; class dictionary;"
                << " object " << name.c_str() << "; }\n" << text.c_str()
                << endl;
        }
        label written = 1;
        reduce(written, sumOp<label>());
    }

    scalarField& patch(const word& name)
    {
        return alpha->boundaryFieldRef()
            [c.mesh().boundaryMesh().findPatchID(name)];
    }

    const vectorField& faceCentres(const word& name)
    {
        return c.mesh().Cf().boundaryField()
            [c.mesh().boundaryMesh().findPatchID(name)];
    }

    //- Iterations to the steady state; -1 if there are too many
    label solveSteady(const label most = 400)
    {
        for (label i = 1; i <= most; ++i)
        {
            flow->solve();
            if (clay->converged(clay->iterate()))
            {
                return i;
            }
        }
        return -1;
    }

    //- Flux of clay out through a patch [m3/s]
    scalar leaving(const word& name)
    {
        return gSum
        (
            clay->alphaPhi().boundaryField()
                [c.mesh().boundaryMesh().findPatchID(name)]
        );
    }
};


//- A box along x, empty across
boxSpec bar(const label n, const scalar length)
{
    boxSpec spec;
    spec.size = vector(length, 1, 1);
    spec.cells = {n, 1, 1};
    spec.patches = {"left", "right", "sides", "sides", "sides", "sides"};
    spec.types = {"patch", "patch", "empty", "empty", "empty", "empty"};
    return spec;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * The rim  * * * * * * * * * * * * * * * * //

namespace
{

constexpr scalar edgeFraction = 0.005;
constexpr scalar waterVelocity = 1e-5;
constexpr scalar rimLength = 0.01;

//- Largest error of the loss of a gel's edge against (C), relative, over
//  x/Lx from 0.25 to 0.9. The rim begins at 0.1 Lx with the profile of (C)
scalar errorOfRim
(
    const label nx,
    const label ny,
    const bool streamwiseDiffusion
)
{
    const scalar first = 0.1*rimLength;

    boxSpec spec;
    spec.size = vector(1, 1, 1e-3);
    spec.cells = {nx, ny, 1};
    spec.patches = {"inlet", "outlet", "gel", "water", "back", "front"};
    spec.types = {"patch", "patch", "patch", "patch", "empty", "empty"};
    spec.map = [=](const vector& unit)
    {
        // Columns get wider downstream, layers outwards
        return vector
        (
            first*std::pow(rimLength/first, unit.x()),
            3e-3*(std::exp(3*unit.y()) - 1)/(std::exp(3.0) - 1),
            unit.z()
        );
    };

    transportCase t
    (
        spec,
        {"gel", "inlet"},
        "model localViscosity; localViscosityCoeffs"
        " { U (1e-5 0 0); gelPatch gel; }",
        "diffusivity { model Liu; }"
      + string
        (
            streamwiseDiffusion ? "" : "withoutDiffusionAlong (1 0 0);"
        ),
        "steadyState",
        "residual 1e-8;"
    );

    const colloid::water water(t.matter.waterAt(0));
    const dictionary model(dictionaryOf("model Liu;"));
    const auto liu = fractionDiffusivity::New(model, t.matter);
    const auto D = liu->at(water);
    const auto eta = t.matter.viscosity(water);

    const scalar D0 = D->value(0);
    const rimSimilarity rim
    (
        rimSimilarity::form::conservative,
        {
            [&](const scalar a) { return D->value(a); },
            [&](const scalar a) { return eta.relativeViscosity(a); },
            D0
        },
        edgeFraction,
        1600
    );

    t.patch("gel") = edgeFraction;
    scalarField& inlet = t.patch("inlet");
    forAll(inlet, i)
    {
        const vector& at = t.faceCentres("inlet")[i];
        const scalar z = at.y()/(2*std::sqrt(D0*at.x()/waterVelocity));

        scalar low = 1e-12;
        scalar high = edgeFraction;
        for (label k = 0; k < 60; ++k)
        {
            const scalar middle = 0.5*(low + high);
            (rim.distance(middle) > z ? low : high) = middle;
        }
        inlet[i] = z > rim.distance(1e-9) ? 0 : low;
    }

    t.makeTransport();
    EXPECT_GT(t.solveSteady(), 0);

    const label gel = t.c.mesh().boundaryMesh().findPatchID("gel");
    const scalarField& flux = t.clay->alphaPhi().boundaryField()[gel];
    scalar worst = 0;

    forAll(flux, i)
    {
        const scalar x = t.faceCentres("gel")[i].x();

        if (x > 0.25*rimLength && x < 0.9*rimLength)
        {
            const scalar area =
                t.c.mesh().magSf().boundaryField()[gel][i];
            const scalar q0 =
                -2*flux[i]/area*std::sqrt(x/(D0*waterVelocity));

            worst = max(worst, mag(q0/rim.edgeLoss() - 1));
        }
    }
    return returnReduce(worst, maxOp<scalar>());
}

} // End anonymous namespace


TEST(clayTransport, rimLosesWhatSimilarityHasAndConvergesAtSecondOrder)
{
    const scalar coarse = errorOfRim(20, 40, false);
    const scalar medium = errorOfRim(40, 80, false);
    const scalar fine = errorOfRim(80, 160, false);

    Info<< "Errors of q0 over x/Lx 0.25 ... 0.9: " << coarse << ", " << medium
        << ", " << fine << ", orders " << std::log2(coarse/medium) << ", "
        << std::log2(medium/fine) << endl;

    EXPECT_LT(fine, 0.01);
    EXPECT_GT(std::log2(medium/fine), 1.7);
}


TEST(clayTransport, streamwiseDiffusionIsThere)
{
    // Neglected in (C): of the order of D/(u0 x)
    const scalar without = errorOfRim(40, 80, false);
    const scalar with = errorOfRim(40, 80, true);

    Info<< "Without and with streamwise diffusion: " << without << ", " << with
        << endl;
    EXPECT_GT(with, without);
    EXPECT_LT(with, 0.05);
}
