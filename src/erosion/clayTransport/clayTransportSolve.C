/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayTransport.H"
#include "fvcGrad.H"
#include "linear.H"
#include "surfaceInterpolationScheme.H"
#include "upwind.H"
#include "zeroGradientFvPatchFields.H"

namespace
{

// Shares of a clay fraction that count as clay where errors are measured
constexpr Foam::scalar clayFloor = 1e-4;

// Change of a step towards the steady state, measured likewise
constexpr Foam::scalar steadyTolerance = 1;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::clayTransport::outflow(const surfaceScalarField& F)
{
    const fvMesh& mesh = F.mesh();
    scalarField sum(mesh.nCells(), Zero);

    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();
    const scalarField& internal = F.primitiveField();

    forAll(internal, facei)
    {
        sum[owner[facei]] += internal[facei];
        sum[neighbour[facei]] -= internal[facei];
    }
    forAll(F.boundaryField(), patchi)
    {
        const scalarField& patch = F.boundaryField()[patchi];
        const labelUList& cells = mesh.boundary()[patchi].faceCells();

        forAll(patch, i)
        {
            sum[cells[i]] += patch[i];
        }
    }
    return sum;
}


void Foam::clayTransport::addDerivatives
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


Foam::tmp<Foam::surfaceScalarField> Foam::clayTransport::advected() const
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
    return phi_*scheme().interpolate(alpha_);
}


void Foam::clayTransport::addAdvection
(
    surfaceScalarField& F,
    fvScalarMatrix* derivatives
) const
{
    F +=
        overUpwind_.valid()
      ? phi_*upwind<scalar>(mesh_, phi_).interpolate(alpha_) + overUpwind_()
      : advected();

    if (!derivatives)
    {
        return;
    }

    // As upwind, whose matrix has no coefficient of the wrong sign; what limited
    // schemes add depends on alpha in its own way
    const scalarField& phi = phi_.primitiveField();
    addDerivatives
    (
        *derivatives,
        max(phi, scalar(0)),
        min(phi, scalar(0))
    );
    forAll(F.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = alpha_.boundaryField()[patchi];
        const scalarField& patchPhi = phi_.boundaryField()[patchi];

        if (patch.coupled())
        {
            derivatives->internalCoeffs()[patchi] += max(patchPhi, scalar(0));
            derivatives->boundaryCoeffs()[patchi] -= min(patchPhi, scalar(0));
        }
        else
        {
            derivatives->internalCoeffs()[patchi] +=
                patchPhi
               *patch.valueInternalCoeffs
                (
                    mesh_.weights().boundaryField()[patchi]
                );
        }
    }
}


void Foam::clayTransport::evaluate
(
    scalarField& potential,
    scalarField& D,
    const scalarField& alpha
) const
{
    const diffusionPotential::atConcentration law
    (
        potential_.at(concentration_)
    );

    forAll(alpha, i)
    {
        potential[i] = law.value(alpha[i]);
        D[i] = law.slope(alpha[i]);
    }
}


void Foam::clayTransport::addDiffusion
(
    surfaceScalarField& F,
    fvScalarMatrix* derivatives
) const
{
    surfaceScalarField J("J", 0*F);

    const surfaceScalarField conductance
    (
        linearInterpolate(aperture_)*diffusing_*mesh_.magSf()
       *mesh_.nonOrthDeltaCoeffs()
    );
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const scalarField& alpha = alpha_.primitiveField();

    // Potential less that of the other side of a face, and its derivatives
    const auto difference =
    [](
        const diffusionPotential::atConcentration& law,
        const scalar here,
        const scalar there
    )
    {
        return law.value(here) - law.value(there);
    };

    scalarField byOwner(mesh_.nInternalFaces());
    scalarField byNeighbour(mesh_.nInternalFaces());
    scalarField D(mesh_.nCells());

    if (salt_)
    {
        const surfaceScalarField concentration(linearInterpolate(*salt_));

        forAll(byOwner, facei)
        {
            const scalar G = conductance[facei];
            const label o = owner[facei];
            const label n = neighbour[facei];
            const auto law = potential_.at(concentration[facei]);

            J[facei] += G*difference(law, alpha[o], alpha[n]);
            byOwner[facei] = G*law.slope(alpha[o]);
            byNeighbour[facei] = -G*law.slope(alpha[n]);
        }
        forAll(D, celli)
        {
            D[celli] = potential_.at((*salt_)[celli]).slope(alpha[celli]);
        }
    }
    else
    {
        scalarField potential(mesh_.nCells());
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
                mesh_.weights().boundaryField()[patchi]
               *salt_->boundaryField()[patchi].patchInternalField()
              + (1 - mesh_.weights().boundaryField()[patchi])
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

            if (coupled)
            {
                patchJ[i] += G[i]*difference(law, inside[i], outside[i]);
                if (derivatives)
                {
                    derivatives->internalCoeffs()[patchi][i] +=
                        G[i]*law.slope(inside[i]);
                    derivatives->boundaryCoeffs()[patchi][i] +=
                        G[i]*law.slope(outside[i]);
                }
                continue;
            }

            // The mean of D from the cell to the boundary, with the gradient
            // that the boundary condition has there
            const scalar step = outside[i] - inside[i];
            const scalar mean =
                mag(step) > 1e-12
              ? -difference(law, inside[i], outside[i])/step
              : law.slope(inside[i]);
            const scalar area =
                G[i]/mesh_.nonOrthDeltaCoeffs().boundaryField()[patchi][i];

            patchJ[i] -= area*mean*gradient[i];

            if (derivatives)
            {
                derivatives->internalCoeffs()[patchi][i] -=
                    area*gradientInternal[i]
                   *(patch.fixesValue() ? law.slope(inside[i]) : mean);
            }
        }
    }

    if (skewed_)
    {
        addSkewness(J, D);
    }
    F += J;
}


void Foam::clayTransport::addSkewness
(
    surfaceScalarField& J,
    const scalarField& D
) const
{
    volVectorField gradient(fvc::grad(alpha_));
    gradient.primitiveFieldRef() *= D;
    gradient.correctBoundaryConditions();

    const surfaceScalarField correction
    (
        linearInterpolate(aperture_)*diffusing_*mesh_.magSf()
       *(mesh_.nonOrthCorrectionVectors() & linearInterpolate(gradient))
    );

    // At most as large as the rest, as OpenFOAM's limited 0.5
    const auto limited = [](const scalar c, const scalar straight)
    {
        return sign(c)*min(mag(c), mag(straight));
    };

    forAll(J, facei)
    {
        J[facei] -= limited(correction[facei], J[facei]);
    }
    forAll(J.boundaryField(), patchi)
    {
        if (alpha_.boundaryField()[patchi].coupled())
        {
            scalarField& patchJ = J.boundaryFieldRef()[patchi];
            const scalarField& c = correction.boundaryField()[patchi];

            forAll(patchJ, i)
            {
                patchJ[i] -= limited(c[i], patchJ[i]);
            }
        }
    }
}


void Foam::clayTransport::addSettling
(
    surfaceScalarField& F,
    fvScalarMatrix* derivatives
) const
{
    if (weight_ == vector(Zero))
    {
        return;
    }

    // By the cell from which it sinks
    const surfaceScalarField drive
    (
        linearInterpolate(aperture_)
       *(mesh_.Sf() & dimensionedVector("weight", dimless, weight_))
    );
    const scalarField& alpha = alpha_.primitiveField();
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();

    scalarField byOwner(mesh_.nInternalFaces(), Zero);
    scalarField byNeighbour(mesh_.nInternalFaces(), Zero);

    forAll(byOwner, facei)
    {
        const bool fromOwner = drive[facei] > 0;
        const scalar a = alpha[fromOwner ? owner[facei] : neighbour[facei]];
        const scalar velocity = drive[facei]/friction_->value(max(a, scalar(0)));

        F[facei] += velocity*a;
        (fromOwner ? byOwner : byNeighbour)[facei] = velocity;
    }
    if (derivatives)
    {
        addDerivatives(*derivatives, byOwner, byNeighbour);
    }

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
        const scalarField valueInternal
        (
            patch.coupled()
          ? scalarField()
          : patch.valueInternalCoeffs
            (
                mesh_.weights().boundaryField()[patchi]
            )()
        );

        forAll(patchF, i)
        {
            const scalar d = drive.boundaryField()[patchi][i];
            const scalar a = d > 0 ? inside[i] : outside[i];
            const scalar velocity = d/friction_->value(max(a, scalar(0)));

            patchF[i] += velocity*a;

            if (!derivatives)
            {
                continue;
            }
            if (d > 0)
            {
                derivatives->internalCoeffs()[patchi][i] += velocity;
            }
            else if (patch.coupled())
            {
                derivatives->boundaryCoeffs()[patchi][i] -= velocity;
            }
            else
            {
                derivatives->internalCoeffs()[patchi][i] +=
                    velocity*valueInternal[i];
            }
        }
    }
}


void Foam::clayTransport::flux
(
    surfaceScalarField& F,
    fvScalarMatrix* derivatives
) const
{
    F == dimensionedScalar(F.dimensions(), Zero);

    if (derivatives)
    {
        derivatives->lower() = 0;
        derivatives->upper() = 0;
        derivatives->diag() = 0;
        forAll(derivatives->internalCoeffs(), patchi)
        {
            derivatives->internalCoeffs()[patchi] = 0;
            derivatives->boundaryCoeffs()[patchi] = 0;
        }
    }
    addAdvection(F, derivatives);
    addDiffusion(F, derivatives);
    addSettling(F, derivatives);

    if (derivatives)
    {
        derivatives->negSumDiag();
    }
}


void Foam::clayTransport::solveFor
(
    volScalarField& change,
    fvScalarMatrix& matrix,
    const scalarField& source
) const
{
    // OpenFOAM adds 1e-20 to the norm of every linear system, of the order of
    // a fracture's fluxes in SI: scaled to order one
    const scalar scale = gAverage(mag(matrix.diag()));
    const scalar largest = gMax(mag(source));

    change == dimensionedScalar(change.dimensions(), Zero);

    if (largest <= 0)
    {
        return;
    }

    matrix.diag() /= scale;
    matrix.lower() /= scale;
    matrix.upper() /= scale;
    forAll(matrix.internalCoeffs(), patchi)
    {
        matrix.internalCoeffs()[patchi] /= scale;
        matrix.boundaryCoeffs()[patchi] /= scale;

        // Whatever the boundary gives does not change
        if (!mesh_.boundary()[patchi].coupled())
        {
            matrix.boundaryCoeffs()[patchi] = 0;
        }
    }
    matrix.source() = source/largest;

    // Without a line in the log
    const int logged = SolverPerformance<scalar>::debug;
    SolverPerformance<scalar>::debug = 0;
    matrix.solve(mesh_.solver(alpha_.name()));
    SolverPerformance<scalar>::debug = logged;

    change.primitiveFieldRef() *= largest/scale;
}


Foam::tmp<Foam::volScalarField> Foam::clayTransport::newChange() const
{
    // Coupled where alpha is; elsewhere the derivatives say all
    wordList types(alpha_.boundaryField().size());

    forAll(types, patchi)
    {
        types[patchi] =
            alpha_.boundaryField()[patchi].coupled()
          ? alpha_.boundaryField()[patchi].type()
          : mesh_.boundary()[patchi].type() == "empty"
          ? word("empty")
          : zeroGradientFvPatchScalarField::typeName;
    }
    return tmp<volScalarField>::New
    (
        IOobject("change", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero),
        types
    );
}


Foam::scalar Foam::clayTransport::errorOf
(
    const scalarField& old,
    const scalarField& rate,
    const scalar deltaT
) const
{
    const scalarField& alpha = alpha_.primitiveField();
    const scalarField& V = mesh_.V();

    // Backward Euler errs by half the second derivative; so does, on the other
    // side, going on with the old rate
    scalar sum = 0;
    scalar volume = 0;

    forAll(alpha, celli)
    {
        const scalar error =
            0.5*(alpha[celli] - old[celli] - deltaT*rate[celli]);

        sum += V[celli]*sqr(error/(alpha[celli] + clayFloor));
        volume += V[celli]*max(alpha[celli], scalar(0))/(alpha[celli] + clayFloor);
    }
    reduce(sum, sumOp<scalar>());
    reduce(volume, sumOp<scalar>());

    return sqrt(sum/max(volume, VSMALL));
}


bool Foam::clayTransport::step
(
    const scalarField& old,
    const scalar deltaT,
    surfaceScalarField& F,
    const scalar relative
)
{
    scalarField& alpha = alpha_.primitiveFieldRef();
    const scalarField content(aperture_.primitiveField()*mesh_.V()/deltaT);

    tmp<volScalarField> tchange(newChange());
    volScalarField& change = tchange.ref();
    fvScalarMatrix derivatives(change, dimVolume/dimTime);

    // What the fluxes would change alpha by, less what it has changed
    const auto imbalance = [&](fvScalarMatrix* matrix)
    {
        alpha_.correctBoundaryConditions();
        flux(F, matrix);
        return scalarField(-outflow(F) - content*(alpha - old));
    };

    scalarField missing(imbalance(&derivatives));

    // In units of alpha: what a cell alone would change by
    const scalarField stiffness(derivatives.diag() + content);
    const auto sizeOf = [&]
    {
        return gMax(mag(missing/stiffness));
    };
    scalar size = sizeOf();

    if (relative > 0 && size < ROOTVSMALL + 1e-14*gMax(alpha))
    {
        // Round-off
        return true;
    }
    const scalar start = size;
    const scalar enough = relative > 0 ? relative*start : residual_;

    // Towards the steady state anything less will do
    bool stuck = false;

    for (label i = 0; size > enough && !stuck; ++i)
    {
        if (i == maxIterations_ || !(size < GREAT))
        {
            return false;
        }
        ++nIterations_;
        derivatives.diag() += content;
        solveFor(change, derivatives, missing);

        // Newton's step, halved until the imbalance is less
        const scalarField from(alpha);
        const scalar before = size;
        scalar share = 1;

        for (label halvings = 0; ; ++halvings)
        {
            alpha = from + share*change.primitiveField();
            missing = imbalance(&derivatives);
            size = sizeOf();

            if (size < before || size <= enough)
            {
                break;
            }
            if (halvings == 6)
            {
                if (!(relative > 0 && size < start))
                {
                    return false;
                }
                stuck = true;
                break;
            }
            share *= 0.5;
        }
    }

    if (relative > 0)
    {
        // On the way to the steady state
        alpha = min(max(alpha, scalar(0)), packing_);
        alpha_.correctBoundaryConditions();
        return true;
    }

    // That of the fluxes: conservative whatever the residual
    alpha += missing/content;
    alpha_.correctBoundaryConditions();

    return
        gMin(alpha) > -10*residual_ && gMax(alpha) < packing_ + 10*residual_;
}


void Foam::clayTransport::refuseAfter
(
    const label most,
    const label nTries,
    const scalar deltaT
) const
{
    if (nTries >= most)
    {
        FatalErrorInFunction
            << "No step from " << mesh_.time().timeName() << " s is small"
            << " enough: the last try was " << deltaT << " s" << nl
            << "    Residual " << residual_ << ", at most " << maxIterations_
            << " iterations (fvSolution, erosion)" << exit(FatalError);
    }
}


Foam::scalar Foam::clayTransport::throughBoundary() const
{
    scalar sum = 0;
    forAll(alphaPhi_.boundaryField(), patchi)
    {
        if (!mesh_.boundary()[patchi].coupled())
        {
            sum += 0.5*Foam::sum(mag(alphaPhi_.boundaryField()[patchi]));
        }
    }
    return returnReduce(sum, sumOp<scalar>());
}


void Foam::clayTransport::begin()
{
    readControls();
    updatePotential();
    if (gravity_ == "auto" || (gravity_ == "on" && !friction_.valid()))
    {
        decideGravity();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::clayTransport::advance(const scalar deltaT)
{
    begin();

    scalarField& alpha = alpha_.primitiveFieldRef();
    scalarField& rate = rate_.primitiveFieldRef();
    surfaceScalarField F("F", alphaPhi_);

    alphaPhi_ == dimensionedScalar(alphaPhi_.dimensions(), Zero);

    scalar done = 0;
    scalar part = deltaT;
    label nTries = 0;

    while (done < (1 - 1e-9)*deltaT)
    {
        part = min(part, deltaT - done);

        const scalarField old(alpha);
        const bool hasRate = nSteps_ > 0 || rate_.headerOk();
        const bool solved = step(old, part, F);
        const scalar error =
            solved && hasRate ? errorOf(old, rate, part) : scalar(0);

        // Of the step that just meets the tolerance, with some reserve
        const scalar growth = 0.9*sqrt(tolerance_/max(error, SMALL));

        if (!solved || error > 2*tolerance_)
        {
            ++(solved ? nRepeated_ : nFailed_);
            alpha = old;
            alpha_.correctBoundaryConditions();
            part *= solved ? min(max(growth, scalar(0.1)), scalar(0.7)) : 0.25;

            refuseAfter(40, ++nTries, part);
            continue;
        }

        ++nSteps_;
        done += part;
        rate = (alpha - old)/part;
        alphaPhi_ += (part/deltaT)*F;

        nextDeltaT_.value() = part*min(max(growth, scalar(0.2)), scalar(1.5));
        part = nextDeltaT_.value();
    }
}


Foam::scalar Foam::clayTransport::iterate()
{
    begin();

    // Of the present alpha with the present flow: over what passes the boundary
    // or, where nothing does, what moves within
    flux(alphaPhi_, nullptr);
    const scalar residual =
        gSum(mag(outflow(alphaPhi_)))
       /max(max(throughBoundary(), 1e-3*gSum(mag(alphaPhi_.primitiveField()))), VSMALL);

    // What the scheme adds to upwind stays as it is meanwhile: a limited one
    // would keep Newton's method from converging in so large a step
    overUpwind_ =
        advected() - phi_*upwind<scalar>(mesh_, phi_).interpolate(alpha_);

    // and half of it is that of the iteration before, or limiters flip for ever
    if (lastOverUpwind_.valid())
    {
        overUpwind_.ref() =
            0.5*(overUpwind_() + lastOverUpwind_());
    }
    // Shorter steps where the residual has grown, until it is less again
    const bool worse = residual > 1.2*bestResidual_;
    bestResidual_ = min(bestResidual_, residual);
    if (worse)
    {
        nextDeltaT_.value() = max(0.3*nextDeltaT_.value(), mesh_.time().deltaTValue());
    }

    const scalarField old(alpha_.primitiveField());
    const scalarField rate(old.size(), Zero);
    surfaceScalarField F("F", alphaPhi_);

    for (label nTries = 0; ; ++nTries)
    {
        const bool solved = step(old, nextDeltaT_.value(), F, 0.5);
        const scalar error = solved ? errorOf(old, rate, nextDeltaT_.value()) : GREAT;
        const scalar growth = steadyTolerance/max(error, SMALL);

        if (solved && (error < 2*steadyTolerance))
        {
            ++nSteps_;
            nextDeltaT_.value() *= min(max(growth, scalar(0.5)), scalar(worse ? 1 : 2));
            lastOverUpwind_ = overUpwind_;
            return residual;
        }
        refuseAfter(40, nTries, nextDeltaT_.value());
        ++(solved ? nRepeated_ : nFailed_);

        alpha_.primitiveFieldRef() = old;
        alpha_.correctBoundaryConditions();
        nextDeltaT_.value() *= 0.25;
    }
}
