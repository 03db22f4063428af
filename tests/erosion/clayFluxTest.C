/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "transportCase.H"
#include "clayFlux.H"
#include "simpson.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

namespace
{

using ofPlace = std::function<scalar(const vector&)>;

constexpr scalar packing = 0.65;
const dimensionSet molPerVolume(0, -3, 0, 0, 1);

//- A face, as what is on either side: of the boundary, the face's own middle
struct side
{
    vector P;
    vector N;
    vector at;
    vector S;

    //- Share of P in what is linear between the two
    scalar weight() const
    {
        return (S & (N - at))/(S & (N - P));
    }

    scalar linear(const ofPlace& f) const
    {
        return weight()*f(P) + (1 - weight())*f(N);
    }
};

//- For each face within, also those between ranks: its sides and the flux there
void forInternalFaces
(
    const fvMesh& mesh,
    const surfaceScalarField& F,
    const std::function<void(const side&, const scalar)>& check
)
{
    forAll(mesh.owner(), facei)
    {
        check
        (
            {
                mesh.C()[mesh.owner()[facei]],
                mesh.C()[mesh.neighbour()[facei]],
                mesh.Cf()[facei],
                mesh.Sf()[facei]
            },
            F[facei]
        );
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (!patch.coupled())
        {
            continue;
        }
        const vectorField delta(patch.delta());
        forAll(delta, i)
        {
            const vector P = mesh.C()[patch.faceCells()[i]];
            check
            (
                {P, P + delta[i], patch.Cf()[i], patch.Sf()[i]},
                F.boundaryField()[patchi][i]
            );
        }
    }
}

//- The same of a patch
void forFacesOf
(
    const word& name,
    const fvMesh& mesh,
    const surfaceScalarField& F,
    const std::function<void(const side&, const scalar)>& check
)
{
    const label patchi = mesh.boundaryMesh().findPatchID(name);
    const fvPatch& patch = mesh.boundary()[patchi];
    forAll(patch, i)
    {
        const vector P = mesh.C()[patch.faceCells()[i]];
        const vector at = patch.Cf()[i];
        check({P, at, at, patch.Sf()[i]}, F.boundaryField()[patchi][i]);
    }
}

//- A rectangle of cells that are open, but for the bottom, and empty across
boxSpec rectangle(const label nx, const label ny)
{
    boxSpec spec;
    spec.cells = {nx, ny, 1};
    spec.patches = {"left", "right", "bottom", "top", "back", "front"};
    spec.types = {"patch", "patch", "wall", "patch", "empty", "empty"};
    return spec;
}

//- A transportCase whose fields are functions of place, and its clayFlux
struct fluxCase
{
    transportCase t;
    const fvMesh& mesh;
    tmp<volScalarField> w;
    tmp<volScalarField> salt;
    surfaceScalarField phi;
    autoPtr<clayFlux> flux;

    //- The velocity of water times the aperture ratio is the flux; without
    //  salt it is null
    fluxCase
    (
        const boxSpec& spec,
        const wordList& fixed,
        const transportCase::texts& text,
        const ofPlace& alpha,
        const ofPlace& apertureRatio,
        const ofPlace& c,
        const vector& U
    )
    :
        t(spec, fixed, text),
        mesh(t.c.mesh()),
        w(fieldOf(mesh, "w", dimless, apertureRatio)),
        phi
        (
            "phi",
            mesh.Sf() & dimensionedVector("U", dimVelocity, U)
        )
    {
        if (c)
        {
            salt = fieldOf(mesh, "c", molPerVolume, c);
        }
        forAll(t.alpha(), celli)
        {
            t.alpha->primitiveFieldRef()[celli] = alpha(mesh.C()[celli]);
        }
        for (const word& name : fixed)
        {
            scalarField& patch = t.patch(name);
            forAll(patch, i)
            {
                patch[i] = alpha(t.faceCentres(name)[i]);
            }
        }
        t.alpha->correctBoundaryConditions();
    }

    void make(const scalar tolerance = 1e-3)
    {
        flux.reset
        (
            new clayFlux
            (
                t.alpha(),
                phi,
                w(),
                salt.valid() ? &salt() : nullptr,
                t.matter,
                t.erosion,
                packing
            )
        );
        flux->update(tolerance);
    }

    surfaceScalarField evaluate() const
    {
        surfaceScalarField F
        (
            IOobject("F", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimVolume/dimTime, Zero)
        );
        flux->evaluate(F, nullptr);
        return F;
    }

    //- Velocity of platelets of a fraction by a unit of g
    scalar sinking(const scalar alpha) const
    {
        const colloid::water water(t.matter.waterAt(0));
        const colloid::platelet& clay = t.matter.clay();

        return
            clay.volume()*(clay.density - water.density)
           /t.matter.newFriction("KozenyCarman", water)->value(alpha);
    }
};

scalar noAperture(const vector&)
{
    return 1;
}

} // End anonymous namespace


// Constant D, a fraction that is linear in place and faces that are not normal to
// the line between cells: -w D S.grad(alpha), where what these add is less than what
// is along that line; else as much as that
TEST(clayFlux, ofALinearFractionIsExactOnAShearedMesh)
{
    const scalar D = 1e-9;
    const scalar w = 0.7;

    boxSpec spec(rectangle(2, 2));
    spec.map = [](const vector& x)
    {
        return vector(x.x() + 0.5*x.y(), x.y(), x.z());
    };
    transportCase::texts text;
    text.erosion = "diffusivity { model constant; value 1e-9; }";

    for (const bool limited : {false, true})
    {
        const vector slope =
            limited ? vector(0.01, -0.1, 0) : vector(0.1, 0.04, 0);

        fluxCase f
        (
            spec,
            {"left", "right", "bottom", "top"},
            text,
            [=](const vector& x) { return 0.3 + (slope & x); },
            [=](const vector&) { return w; },
            nullptr,
            Zero
        );
        f.make();
        label nLimited = 0;

        forInternalFaces
        (
            f.mesh,
            f.evaluate(),
            [&](const side& s, const scalar F)
            {
                const vector n = s.S/mag(s.S);
                const vector d = s.N - s.P;
                const scalar along = (slope & d)/(n & d);
                const scalar rest = (slope & n) - along;
                const scalar most = min(mag(rest), mag(along));
                nLimited += mag(rest) > mag(along);

                EXPECT_NEAR
                (
                    F/(-w*D*mag(s.S)*mag(slope)),
                    (along + (rest > 0 ? most : -most))/mag(slope),
                    1e-9
                );
            }
        );
        reduce(nLimited, sumOp<label>());
        EXPECT_EQ(nLimited > 0, limited);
    }
}


// Face by face with formulas written out, where aperture, salt and fraction differ
// from cell to cell: water carries what is linear between cells, clay sinks from the
// cell above as the one below takes it, and diffuses by the integral of D in the water of the face
TEST(clayFlux, isThatOfItsThreeTermsInEveryWaterAndAperture)
{
    const vector U(1e-8, 5e-9, 0);
    const vector g(-240, 160, 0);
    const auto alpha = [](const vector& x)
    {
        return 0.005*std::exp(2*x.x() + 1.5*x.y());
    };
    const auto w = [](const vector& x)
    {
        return 0.5 + 0.4*x.x() + 0.7*sqr(x.y());
    };
    const auto c = [](const vector& x)
    {
        return 0.2*std::exp(3*x.x() + x.y());
    };

    boxSpec spec(rectangle(8, 6));
    spec.map = [](const vector& x)
    {
        return vector(std::pow(x.x(), 1.2), std::pow(x.y(), 1.3), x.z());
    };
    transportCase::texts text;
    text.erosion = "diffusivity { model Liu; } gravity on;";
    text.advection = "linear";

    fluxCase f(spec, {"left", "top"}, text, alpha, w, c, U);
    f.t.write
    (
        "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (-240 160 0);"
    );
    f.make();

    const auto model = fractionDiffusivity::New
    (
        f.t.erosion.subDict("diffusivity"), f.t.matter
    );
    const auto integral = [&](const scalar from, const scalar to, const scalar at)
    {
        colloid::water water(f.t.matter.waterAt(0));
        water.concentration = at;
        const auto D = model->at(water);

        return simpson
        (
            [&](const scalar a) { return D->value(a); }, from, to, 100
        );
    };
    label nHindered = 0;
    const auto sinks = [&](const side& s, const scalar ratio)
    {
        // Godunov's flux by its definition: from a little clay to much the least
        // in between, from much to little the most
        const bool fromP = (s.S & g) > 0;
        const scalar above = alpha(fromP ? s.P : s.N);
        const scalar below = alpha(fromP ? s.N : s.P);
        const label n = 1000;
        scalar flux = above*f.sinking(above);
        for (label i = 1; i <= n; ++i)
        {
            const scalar a = above + i*(below - above)/n;
            const scalar here = a*f.sinking(a);
            flux = above < below ? min(flux, here) : max(flux, here);
        }
        nHindered += below*f.sinking(below) < above*f.sinking(above) && above < below;
        return ratio*(s.S & g)*flux;
    };

    scalar carriedShare = 0;
    scalar sinkingShare = 0;
    const auto checkOpen = [&](const side& s, const scalar F)
    {
        // Of the boundary too: its middle is where the other side is
        const scalar ratio = s.linear(w);
        const scalar carried = (U & s.S)*s.linear(alpha);
        const scalar sinking = sinks(s, ratio);
        const scalar diffusing =
            ratio*mag(s.S)/mag(s.N - s.P)
           *integral(alpha(s.N), alpha(s.P), s.linear(c));
        const scalar size = mag(carried) + mag(sinking) + mag(diffusing);

        EXPECT_NEAR(F/size, (carried + sinking + diffusing)/size, 5e-4)
            << "at " << s.at.x() << ' ' << s.at.y();
        carriedShare = max(carriedShare, mag(carried)/size);
        sinkingShare = max(sinkingShare, mag(sinking)/size);
    };

    const surfaceScalarField F(f.evaluate());
    forInternalFaces(f.mesh, F, checkOpen);
    forFacesOf("left", f.mesh, F, checkOpen);
    forFacesOf("top", f.mesh, F, checkOpen);

    // That none of the terms is next to nothing
    carriedShare = returnReduce(carriedShare, maxOp<scalar>());
    sinkingShare = returnReduce(sinkingShare, maxOp<scalar>());
    Info<< "Largest share of what is carried " << carriedShare
        << ", of what sinks " << sinkingShare << endl;
    EXPECT_GT(carriedShare, 0.2);
    EXPECT_GT(sinkingShare, 0.1);
    reduce(nHindered, sumOp<label>());
    EXPECT_GT(nHindered, 5);

    // The fraction of the cell on the right side; no clay sinks through the wall
    forFacesOf
    (
        "right",
        f.mesh,
        F,
        [&](const side& s, const scalar F)
        {
            const scalar a = alpha(s.P);
            const scalar expected =
                (U & s.S)*a + w(s.at)*(s.S & g)*a*f.sinking(a);
            EXPECT_NEAR(F/mag(expected), sign(expected), 1e-9);
        }
    );
    forFacesOf
    (
        "bottom",
        f.mesh,
        F,
        [&](const side& s, const scalar F)
        {
            EXPECT_NEAR(F/((U & s.S)*alpha(s.P)), 1, 1e-9);
        }
    );
}


// Where salt holds a gel together the water of each cell carries the sol of its own
// concentration, that of a table
TEST(clayFlux, carriesTheSolOfItsOwnSalt)
{
    const scalar gel = 0.3;
    const vector U(1e-5, 0, 0);
    const auto number = [](const vector& x)
    {
        return 100 + label(10*x.x() + 1e-6);
    };
    const auto c = [&](const vector& x)
    {
        return std::pow(10, number(x)/40.0);
    };

    transportCase::texts text;
    text.erosion = "diffusivity { model Liu; }";
    text.advection = "upwind";
    fluxCase f
    (
        rectangle(10, 1),
        {},
        text,
        [=](const vector&) { return gel; },
        noAperture,
        c,
        U
    );
    f.make();

    const auto model = fractionDiffusivity::New
    (
        f.t.erosion.subDict("diffusivity"), f.t.matter
    );
    scalarField sols(10);
    forAll(sols, i)
    {
        colloid::water water(f.t.matter.waterAt(0));
        water.concentration = std::pow(10, (100 + i)/40.0);
        sols[i] = potentialInWater(model(), water, packing).phases().sol();
        ASSERT_GT(sols[i], 0);
        ASSERT_LT(sols[i], 0.1*gel);
    }

    forInternalFaces
    (
        f.mesh,
        f.evaluate(),
        [&](const side& s, const scalar F)
        {
            const vector& from = (U & s.S) > 0 ? s.P : s.N;
            const scalar sol = sols[number(from) - 100];
            EXPECT_NEAR(F/((U & s.S)*sol), 1, 1e-6);
        }
    );
}


// Water at half and at twice the velocity of which the tolerance is that of lone
// platelets that sink
TEST(clayFlux, hasGravityByItselfWhereClaySinksFastAgainstTheWater)
{
    const scalar alpha = 0.01;
    const scalar tolerance = 1e-3;

    for (const string word : {"auto", "off", "on"})
    {
        for (const scalar part : {0.5, 2.0})
        {
            transportCase::texts text;
            text.erosion =
                "diffusivity { model constant; value 1e-12; } gravity "
              + word + ";";
            fluxCase f
            (
                rectangle(2, 4),
                {},
                text,
                [=](const vector&) { return alpha; },
                noAperture,
                nullptr,
                Zero
            );
            const scalar U = part*f.sinking(0)*9.81/tolerance;
            f.phi =
                f.mesh.Sf()
              & dimensionedVector("U", dimVelocity, vector(U, 0, 0));
            f.t.write
            (
                "constant/g",
                "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);"
            );
            f.make(tolerance);

            const bool sinks = word == "on" || (word == "auto" && part < 1);
            forInternalFaces
            (
                f.mesh,
                f.evaluate(),
                [&](const side& s, const scalar F)
                {
                    const scalar sinking =
                        -9.81*s.S.y()*alpha*f.sinking(alpha);
                    EXPECT_NEAR
                    (
                        (F - U*s.S.x()*alpha)/(9.81*f.sinking(alpha)),
                        sinks ? sinking/(9.81*f.sinking(alpha)) : 0,
                        1e-9*alpha*max(scalar(1), U/(9.81*f.sinking(alpha)))
                    ) << word << ' ' << part;
                }
            );
        }
    }
}


// Through the faces of the cells that are named, also of those of another rank,
// water carries by upwind; through the others by the scheme
TEST(clayFlux, withoutCorrectionIsByUpwindAroundTheCells)
{
    const vector U(1e-5, 2e-5, 0);
    const auto alpha = [](const vector& x)
    {
        return 0.01*std::exp(2*x.x() - 1.5*x.y());
    };
    const auto named = [](const vector& x)
    {
        // Beside the halves that ranks have
        return
            (x.x() > 0.375 && x.x() < 0.5) || (x.y() > 1/3.0 && x.y() < 0.5);
    };

    transportCase::texts text;
    text.erosion = "diffusivity { model constant; value 1e-12; }";
    text.advection = "linear";
    fluxCase f
    (
        rectangle(8, 6), {"right"}, text, alpha, noAperture, nullptr, U
    );
    f.make();

    boolList cells(f.mesh.nCells());
    forAll(cells, celli)
    {
        cells[celli] = named(f.mesh.C()[celli]);
    }
    const surfaceScalarField before(f.evaluate());
    f.flux->holdCorrection(1);
    f.flux->withoutCorrection(cells);
    const surfaceScalarField change(f.evaluate() - before);

    label nNamed = 0;
    forInternalFaces
    (
        f.mesh,
        change,
        [&](const side& s, const scalar by)
        {
            const scalar phi = U & s.S;
            const bool upwind = named(s.P) || named(s.N);
            nNamed += upwind;

            EXPECT_NEAR
            (
                by/mag(phi),
                upwind
              ? sign(phi)*(alpha(phi > 0 ? s.P : s.N) - s.linear(alpha))
              : 0,
                1e-14
            );
        }
    );
    EXPECT_GT(returnReduce(nNamed, sumOp<label>()), 0);
}


// A change that Newton's method asks for becomes that of what a cell holds and
// passes on, with the integral of D, its neighbours being as they are; D grows by
// decades within it
TEST(clayFlux, changesCellsAsFarAsTheirDiffusivityAllows)
{
    const scalar w = 0.7;
    const auto alpha = [](const vector& x) { return 1e-5*(1 + x.x() + x.y()); };

    transportCase::texts text;
    text.erosion = "diffusivity { model Liu; } gravity off;";
    fluxCase f
    (
        rectangle(5, 4), {"left", "top"}, text, alpha,
        [=](const vector&) { return w; }, nullptr, Zero
    );
    f.make();

    // Area over distance of the faces through which clay diffuses
    scalarField G(f.mesh.nCells(), Zero);
    const surfaceScalarField none(f.evaluate());
    const auto add = [&](const side& s, const scalar)
    {
        forAll(G, celli)
        {
            const vector& C = f.mesh.C()[celli];
            for (const vector& one : {s.P, s.N})
            {
                G[celli] +=
                    mag(C - one) < 1e-9 ? w*mag(s.S)/mag(s.N - s.P) : 0;
            }
        }
    };
    forInternalFaces(f.mesh, none, add);
    forFacesOf("left", f.mesh, none, add);
    forFacesOf("top", f.mesh, none, add);

    const auto D = fractionDiffusivity::New
    (
        f.t.erosion.subDict("diffusivity"), f.t.matter
    )->at(f.t.matter.waterAt(0));

    const scalarField from(f.t.alpha->primitiveField());
    scalarField holding(from.size());
    scalarField wanted(from.size());
    scalarField stiffness(from.size());
    scalarField linearChange(from.size());

    // What is held from a hundred times to a tenth of what diffuses, changes up
    // and down
    forAll(from, celli)
    {
        const scalar diffusing = G[celli]*D->value(from[celli]);
        holding[celli] = diffusing*std::pow(10, 2 - (celli % 4));
        linearChange[celli] = celli % 5 ? 0.02*(celli % 5) : -0.5*from[celli];
        stiffness[celli] = holding[celli] + diffusing;
        wanted[celli] = stiffness[celli]*linearChange[celli];
    }

    scalarField to(from);
    f.flux->change(to, from, linearChange, stiffness);

    scalar least = 1;
    forAll(from, celli)
    {
        const scalar passedOn = G[celli]*simpson
        (
            [&](const scalar a) { return D->value(a); },
            from[celli], to[celli], 2000
        );

        EXPECT_NEAR
        (
            (holding[celli]*(to[celli] - from[celli]) + passedOn)/wanted[celli],
            1,
            1e-3
        );
        least = min(least, (to[celli] - from[celli])/linearChange[celli]);
    }
    Info<< "Least share of a linear change " << least << endl;

    // Somewhere it matters
    EXPECT_LT(returnReduce(least, minOp<scalar>()), 0.5);
}
