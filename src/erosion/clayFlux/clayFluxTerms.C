/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayFlux.H"
#include "fvcGrad.H"
#include "linear.H"
#include "surfaceInterpolationScheme.H"
#include "upwind.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::clayFlux::addDerivatives
(
    fvScalarMatrix& matrix,
    const scalarField& byOwner,
    const scalarField& byNeighbour
)
{
    // What leaves the owner enters the neighbour; the diagonal follows at last
    scalarField& lower = matrix.lower();
    scalarField& upper = matrix.upper();

    forAll(byOwner, facei)
    {
        lower[facei] -= byOwner[facei];
        upper[facei] += byNeighbour[facei];
    }
}


Foam::tmp<Foam::volScalarField> Foam::clayFlux::carried() const
{
    if
    (
        !salt_
     && potential_.uniform().phases().kind() != coexistence::state::twoPhases
    )
    {
        return tmp<volScalarField>(alpha_);
    }

    const IOobject io
    (
        "carried",
        mesh_.time().timeName(),
        mesh_,
        IOobject::NO_READ,
        IOobject::NO_WRITE,
        false
    );
    tmp<volScalarField> ta(new volScalarField(io, alpha_));
    volScalarField& a = ta.ref();

    const auto limit = [&](scalarField& part, const scalarField* c)
    {
        forAll(part, i)
        {
            part[i] =
                potential_.at(c ? (*c)[i] : concentration_).carried(part[i]);
        }
    };
    limit(a.primitiveFieldRef(), salt_ ? &salt_->primitiveField() : nullptr);
    forAll(a.boundaryField(), patchi)
    {
        limit
        (
            a.boundaryFieldRef()[patchi],
            salt_ ? &salt_->boundaryField()[patchi] : nullptr
        );
    }
    return ta;
}


Foam::tmp<Foam::surfaceScalarField> Foam::clayFlux::advected
(
    const volScalarField& a
) const
{
    ITstream& entry = mesh_.divScheme("div(phi,alpha.clay)");
    const word Gauss(entry);

    if (Gauss != "Gauss")
    {
        FatalIOErrorInFunction(mesh_.schemesDict().subDict("divSchemes"))
            << "div(phi,alpha.clay) begins with " << Gauss << nl
            << "Valid: Gauss and an interpolation scheme, such as"
            << " 'Gauss vanLeer'" << exit(FatalIOError);
    }
    const tmp<surfaceInterpolationScheme<scalar>> scheme
    (
        surfaceInterpolationScheme<scalar>::New(mesh_, phi_, entry)
    );
    return phi_*scheme().interpolate(a);
}


Foam::tmp<Foam::surfaceScalarField> Foam::clayFlux::upwindAdvected
(
    const volScalarField& a
) const
{
    return phi_*upwind<scalar>(mesh_, phi_).interpolate(a);
}


void Foam::clayFlux::addAdvection
(
    surfaceScalarField& F,
    fvScalarMatrix* derivatives
) const
{
    const tmp<volScalarField> ta(carried());
    const volScalarField& a = ta();

    F += upwindAdvected(a);

    if (!derivatives)
    {
        return;
    }

    // As upwind, whose matrix has no coefficient of the wrong sign; what limited
    // schemes add depends on alpha in its own way
    const scalarField& phi = phi_.primitiveField();

    // 1, 0 where there is a gel that coheres
    const auto slopeOf = [](const scalarField& part, const scalarField& all)
    {
        return scalarField(pos(part - all + 1e-9*mag(all) + VSMALL));
    };
    const scalarField slope(slopeOf(a.primitiveField(), alpha_.primitiveField()));
    scalarField byOwner(max(phi, scalar(0)));
    scalarField byNeighbour(min(phi, scalar(0)));

    forAll(phi, facei)
    {
        byOwner[facei] *= slope[mesh_.owner()[facei]];
        byNeighbour[facei] *= slope[mesh_.neighbour()[facei]];
    }
    addDerivatives(*derivatives, byOwner, byNeighbour);

    const surfaceScalarField& weights = mesh_.weights();
    forAll(F.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = alpha_.boundaryField()[patchi];
        const scalarField& patchPhi = phi_.boundaryField()[patchi];
        const scalarField patchSlope(slope, mesh_.boundary()[patchi].faceCells());

        if (patch.coupled())
        {
            const scalarField otherSlope
            (
                slopeOf
                (
                    a.boundaryField()[patchi].patchNeighbourField()(),
                    patch.patchNeighbourField()()
                )
            );
            derivatives->internalCoeffs()[patchi] +=
                patchSlope*max(patchPhi, scalar(0));
            derivatives->boundaryCoeffs()[patchi] -=
                otherSlope*min(patchPhi, scalar(0));
        }
        else
        {
            derivatives->internalCoeffs()[patchi] +=
                patchSlope*patchPhi
               *patch.valueInternalCoeffs
                (
                    weights.boundaryField()[patchi]
                );
        }
    }
}


void Foam::clayFlux::evaluate
(
    scalarField& potential,
    scalarField& D,
    const scalarField& alpha
) const
{
    forAll(alpha, celli)
    {
        const potentialInWater::point here(lawOf(celli).at(alpha[celli]));
        potential[celli] = here.potential;
        D[celli] = here.diffusivity;
    }
}


void Foam::clayFlux::addDiffusion
(
    surfaceScalarField& F,
    fvScalarMatrix* derivatives
) const
{
    surfaceScalarField J("J", 0*F);

    const surfaceScalarField& conductance = conductance_;
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const scalarField& alpha = alpha_.primitiveField();

    scalarField byOwner(mesh_.nInternalFaces());
    scalarField byNeighbour(mesh_.nInternalFaces());

    if (salt_)
    {
        const surfaceScalarField concentration(linearInterpolate(*salt_));

        forAll(byOwner, facei)
        {
            const scalar G = conductance[facei];
            const label o = owner[facei];
            const label n = neighbour[facei];
            const auto law = potential_.at(concentration[facei]);
            const potentialInWater::point here(law.at(alpha[o]));
            const potentialInWater::point there(law.at(alpha[n]));

            J[facei] += G*(here.potential - there.potential);
            byOwner[facei] = G*here.diffusivity;
            byNeighbour[facei] = -G*there.diffusivity;
        }
    }
    else
    {
        scalarField potential(mesh_.nCells());
        scalarField D(mesh_.nCells());
        evaluate(potential, D, alpha);

        forAll(byOwner, facei)
        {
            const scalar G = conductance[facei];
            const label o = owner[facei];
            const label n = neighbour[facei];

            J[facei] += G*(potential[o] - potential[n]);
            byOwner[facei] = G*D[o];
            byNeighbour[facei] = -G*D[n];
        }
    }

    if (derivatives)
    {
        addDerivatives(*derivatives, byOwner, byNeighbour);
    }

    const surfaceScalarField& weights = mesh_.weights();
    const surfaceScalarField& deltaCoeffs = mesh_.nonOrthDeltaCoeffs();

    forAll(J.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = alpha_.boundaryField()[patchi];
        scalarField& patchJ = J.boundaryFieldRef()[patchi];
        const scalarField& G = conductance.boundaryField()[patchi];
        const scalarField inside(patch.patchInternalField());

        if (patch.empty())
        {
            continue;
        }

        const bool coupled = patch.coupled();
        const scalarField outside
        (
            coupled ? patch.patchNeighbourField()() : scalarField(patch)
        );
        const scalarField gradient(coupled ? scalarField() : patch.snGrad()());
        const scalarField gradientInternal
        (
            coupled ? scalarField() : patch.gradientInternalCoeffs()()
        );
        // Of a processor patch the mean of both sides, elsewhere the boundary's
        const scalarField concentration
        (
            !salt_ ? scalarField()
          : coupled
          ? scalarField
            (
                weights.boundaryField()[patchi]
               *salt_->boundaryField()[patchi].patchInternalField()
              + (1 - weights.boundaryField()[patchi])
               *salt_->boundaryField()[patchi].patchNeighbourField()
            )
          : scalarField(salt_->boundaryField()[patchi])
        );

        forAll(patchJ, i)
        {
            const auto law = potential_.at
            (
                salt_ ? concentration[i] : concentration_
            );
            const potentialInWater::point here(law.at(inside[i]));
            const potentialInWater::point there(law.at(outside[i]));

            if (coupled)
            {
                patchJ[i] += G[i]*(here.potential - there.potential);
                if (derivatives)
                {
                    derivatives->internalCoeffs()[patchi][i] +=
                        G[i]*here.diffusivity;
                    derivatives->boundaryCoeffs()[patchi][i] +=
                        G[i]*there.diffusivity;
                }
                continue;
            }

            // The mean of D from the cell to the boundary, with the gradient
            // that the boundary condition has there
            const scalar step = outside[i] - inside[i];
            const scalar mean =
                mag(step) > 1e-12
              ? (there.potential - here.potential)/step
              : here.diffusivity;
            const scalar area =
                G[i]/deltaCoeffs.boundaryField()[patchi][i];

            patchJ[i] -= area*mean*gradient[i];

            if (derivatives)
            {
                derivatives->internalCoeffs()[patchi][i] -=
                    area*gradientInternal[i]
                   *(patch.fixesValue() ? here.diffusivity : mean);
            }
        }
    }

    F += J;
}


Foam::tmp<Foam::surfaceScalarField> Foam::clayFlux::skewness() const
{
    volVectorField gradient(fvc::grad(alpha_));
    forAll(gradient, celli)
    {
        gradient[celli] *= lawOf(celli).at(alpha_[celli]).diffusivity;
    }
    gradient.correctBoundaryConditions();

    tmp<surfaceScalarField> tskewness
    (
       -linearInterpolate(aperture_)*diffusing_*mesh_.magSf()
       *(mesh_.nonOrthCorrectionVectors() & linearInterpolate(gradient))
       *dimensionedScalar("1", dimVolume/dimTime/dimLength, 1)
    );
    surfaceScalarField& skew = tskewness.ref();
    skew.oriented() = phi_.oriented();

    surfaceScalarField straight("straight", 0*skew);
    addDiffusion(straight, nullptr);

    // At most as large as the rest, as OpenFOAM's limited 0.5
    const auto limit = [](scalarField& part, const scalarField& straight)
    {
        forAll(part, i)
        {
            part[i] = sign(part[i])*min(mag(part[i]), mag(straight[i]));
        }
    };

    limit(skew.primitiveFieldRef(), straight.primitiveField());
    forAll(skew.boundaryField(), patchi)
    {
        scalarField& patchSkew = skew.boundaryFieldRef()[patchi];

        if (alpha_.boundaryField()[patchi].coupled())
        {
            limit(patchSkew, straight.boundaryField()[patchi]);
        }
        else
        {
            patchSkew = 0;
        }
    }
    return tskewness;
}


Foam::tmp<Foam::surfaceScalarField> Foam::clayFlux::correction() const
{
    const tmp<volScalarField> a(carried());
    tmp<surfaceScalarField> over(advected(a()) - upwindAdvected(a()));

    return skewed_ ? over + skewness() : over;
}


Foam::clayFlux::settling Foam::clayFlux::settlingOf
(
    const scalar above,
    const scalar below
) const
{
    // What sinks per driving force, and its derivative
    const auto sinking = [&](const scalar a)
    {
        return a/friction_->value(a);
    };
    const auto slope = [&](const scalar a)
    {
        const scalar friction = friction_->value(a);
        return (1 - a*friction_->slope(a)/friction)/friction;
    };
    const scalar from = max(above, scalar(0));
    const scalar to = max(below, scalar(0));
    const scalar sent = sinking(min(from, fastestSinking_));
    const scalar taken = sinking(max(to, fastestSinking_));

    if (sent <= taken)
    {
        return {sent, from < fastestSinking_ ? slope(from) : scalar(0), 0};
    }
    return {taken, 0, to > fastestSinking_ ? slope(to) : scalar(0)};
}


void Foam::clayFlux::addSettling
(
    surfaceScalarField& F,
    fvScalarMatrix* derivatives
) const
{
    if (weight_ == vector(Zero))
    {
        return;
    }

    const surfaceScalarField drive
    (
        linearInterpolate(aperture_)
       *(mesh_.Sf() & dimensionedVector("weight", dimless, weight_))
    );
    const scalarField& alpha = alpha_.primitiveField();
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();

    scalarField byOwner(mesh_.nInternalFaces());
    scalarField byNeighbour(mesh_.nInternalFaces());

    forAll(byOwner, facei)
    {
        const scalar d = drive[facei];
        const scalar ownerAlpha = alpha[owner[facei]];
        const scalar neighbourAlpha = alpha[neighbour[facei]];
        const settling s =
            d > 0
          ? settlingOf(ownerAlpha, neighbourAlpha)
          : settlingOf(neighbourAlpha, ownerAlpha);

        F[facei] += d*s.flux;
        byOwner[facei] = d*(d > 0 ? s.byAbove : s.byBelow);
        byNeighbour[facei] = d*(d > 0 ? s.byBelow : s.byAbove);
    }
    if (derivatives)
    {
        addDerivatives(*derivatives, byOwner, byNeighbour);
    }

    const surfaceScalarField& weights = mesh_.weights();
    forAll(F.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = alpha_.boundaryField()[patchi];

        if (!settlesThrough(patchi) || patch.empty())
        {
            continue;
        }
        const scalarField inside(patch.patchInternalField());
        const scalarField outside
        (
            patch.coupled() ? patch.patchNeighbourField()() : scalarField(patch)
        );
        scalarField& patchF = F.boundaryFieldRef()[patchi];

        // Of the outer value by the inner one
        const scalarField valueInternal
        (
            patch.coupled()
          ? scalarField()
          : patch.valueInternalCoeffs
            (
                weights.boundaryField()[patchi]
            )()
        );

        forAll(patchF, i)
        {
            const scalar d = drive.boundaryField()[patchi][i];
            const settling s =
                d > 0
              ? settlingOf(inside[i], outside[i])
              : settlingOf(outside[i], inside[i]);
            const scalar byInside = d*(d > 0 ? s.byAbove : s.byBelow);
            const scalar byOutside = d*(d > 0 ? s.byBelow : s.byAbove);

            patchF[i] += d*s.flux;

            if (!derivatives)
            {
                continue;
            }
            derivatives->internalCoeffs()[patchi][i] += byInside;

            if (patch.coupled())
            {
                derivatives->boundaryCoeffs()[patchi][i] -= byOutside;
            }
            else
            {
                derivatives->internalCoeffs()[patchi][i] +=
                    byOutside*valueInternal[i];
            }
        }
    }
}
