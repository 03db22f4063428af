/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayTransport.H"

namespace
{

// Shares of a clay fraction that count as clay where errors are measured
constexpr Foam::scalar clayFloor = 1e-4;

// Change of a step towards the steady state, measured likewise
constexpr Foam::scalar steadyTolerance = 1;

// Of a time step: each brings the advection nearer to that of its end
constexpr Foam::label nCorrections = 3;

// Parts of a time step without a word of warning
constexpr Foam::label mostParts = 10;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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

    // Where next to nothing is left, as if it were one cell
    return sqrt(sum/max(volume, gMax(V)));
}


bool Foam::clayTransport::step
(
    const scalarField& old,
    const scalar deltaT,
    surfaceScalarField& F
)
{
    scalarField& alpha = alpha_.primitiveFieldRef();
    scalarField missing;

    const scalarField content(aperture_.primitiveField()*mesh_.V()/deltaT);

    // What is explicit is held while Newton's method works, and brought up to
    // date after it
    flux_.holdCorrection(1);

    for (label i = 1; ; ++i)
    {
        if (!iterateNewton(old, deltaT, F, missing))
        {
            flux_.releaseCorrection();
            return false;
        }

        // That of the fluxes: conservative whatever the residual
        alpha += missing/content;
        alpha_.correctBoundaryConditions();

        if (i < nCorrections)
        {
            flux_.releaseCorrection();
            flux_.holdCorrection(1);
            continue;
        }

        // Upwind where the scheme has left the bounds, which it may in steps in
        // which the water crosses several cells
        boolList outside(alpha.size(), false);
        bool bounded = true;
        forAll(alpha, celli)
        {
            if
            (
                alpha[celli] < -10*residual_
             || alpha[celli] > packing_ + 10*residual_
            )
            {
                outside[celli] = true;
                bounded = false;
            }
        }
        reduce(bounded, andOp<bool>());

        if (bounded || i == 2*nCorrections)
        {
            flux_.releaseCorrection();
            return bounded;
        }
        flux_.withoutCorrection(outside);
    }
}


void Foam::clayTransport::refuseAfter
(
    const label most,
    const label nTries,
    const scalar deltaT,
    const bool solved,
    const scalar error
) const
{
    if (nTries >= most)
    {
        // Collective
        const scalar least = gMin(alpha_.primitiveField());
        const scalar largest = gMax(alpha_.primitiveField());

        FatalIOErrorInFunction
        (
            mesh_.solutionDict().subOrEmptyDict("erosion")
        )
            << "No step from " << mesh_.time().timeName() << " s is small"
            << " enough: the last try was " << deltaT << " s, "
            << (solved ? "solved with an estimated error of " : "not solved");
        if (solved)
        {
            FatalIOError << error;
        }
        FatalIOError << nl
            << "    Before it " << alpha_.name() << " was from " << least << " to "
            << largest << nl
            << "    Residual " << residual_ << ", at most " << maxIterations_
            << " iterations, tolerance " << tolerance_
            << " (fvSolution, erosion)" << exit(FatalIOError);
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
    flux_.update(tolerance_);

    // At the very start the change is that of the present fluxes
    if (!steady() && !begun())
    {
        surfaceScalarField F("F", alphaPhi_);
        flux_.evaluate(F, nullptr);
        rate_.primitiveFieldRef() =
            -clayFlux::outflow(F)/(aperture_.primitiveField()*mesh_.V());
    }
}


bool Foam::clayTransport::shorten
(
    const scalarField& old,
    scalar& part,
    surfaceScalarField& F,
    const label nTries
)
{
    const bool solved = step(old, part, F);
    const scalar error =
        solved ? errorOf(old, rate_.primitiveField(), part) : scalar(0);

    // Of the step that just meets the tolerance, with some reserve
    const scalar growth = 0.9*sqrt(tolerance_/max(error, SMALL));

    if (solved && error <= 2*tolerance_)
    {
        nextDeltaT_.value() = part*min(max(growth, scalar(0.2)), scalar(1.5));
        return false;
    }
    ++(solved ? nRepeated_ : nFailed_);
    alpha_.primitiveFieldRef() = old;
    alpha_.correctBoundaryConditions();

    refuseAfter(40, nTries + 1, part, solved, error);
    part *= solved ? min(max(growth, scalar(0.1)), scalar(0.7)) : 0.25;
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::clayTransport::nextDeltaT()
{
    if (!begun())
    {
        begin();

        surfaceScalarField F("F", alphaPhi_);
        const scalarField old(alpha_.primitiveField());
        scalar first = nextDeltaT_.value();

        for (label nTries = 0; shorten(old, first, F, nTries); ++nTries)
        {}
        alpha_.primitiveFieldRef() = old;
        alpha_.correctBoundaryConditions();
        nextDeltaT_.value() = first;
    }
    return nextDeltaT_.value();
}


void Foam::clayTransport::advance(const scalar deltaT)
{
    begin();

    scalarField& alpha = alpha_.primitiveFieldRef();
    surfaceScalarField F("F", alphaPhi_);

    alphaPhi_ == dimensionedScalar(alphaPhi_.dimensions(), Zero);

    scalar done = 0;
    scalar part = deltaT;
    label nParts = 0;

    while (done < (1 - 1e-9)*deltaT)
    {
        part = min(part, deltaT - done);
        const scalarField old(alpha);

        for (label nTries = 0; shorten(old, part, F, nTries); ++nTries)
        {}

        ++nSteps_;
        ++nParts;
        done += part;
        rate_.primitiveFieldRef() = (alpha - old)/part;
        alphaPhi_ += (part/deltaT)*F;
        part = nextDeltaT_.value();
    }

    if (nParts > mostParts && !warnedOfParts_)
    {
        warnedOfParts_ = true;
        WarningInFunction
            << "The step of " << deltaT << " s to " << mesh_.time().timeName()
            << " s was made in " << nParts << " parts" << nl
            << "    Flow and salt stayed as they were before it: a shorter"
            << " deltaT, or adjustTimeStep yes, lets them follow."
            << " Said once" << endl;
    }
}


Foam::scalar Foam::clayTransport::iterate()
{
    begin();

    // Of the present alpha with the present flow: over what passes the boundary
    // or, where nothing does, what moves within
    flux_.evaluate(alphaPhi_, nullptr);
    const scalar residual =
        gSum(mag(clayFlux::outflow(alphaPhi_)))
       /max(max(throughBoundary(), 1e-3*gSum(mag(alphaPhi_.primitiveField()))), VSMALL);

    flux_.holdCorrection(0.5);

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
    scalarField missing;

    for (label nTries = 0; ; ++nTries)
    {
        const bool solved =
            iterateNewton(old, nextDeltaT_.value(), F, missing, 0.5);
        alpha_.primitiveFieldRef() =
            min(max(alpha_.primitiveField(), scalar(0)), packing_);
        alpha_.correctBoundaryConditions();

        const scalar error = solved ? errorOf(old, rate, nextDeltaT_.value()) : GREAT;
        const scalar growth = steadyTolerance/max(error, SMALL);

        if (solved && (error < 2*steadyTolerance))
        {
            ++nSteps_;
            nextDeltaT_.value() *= min(max(growth, scalar(0.5)), scalar(worse ? 1 : 2));
            flux_.releaseCorrection();
            return residual;
        }
        refuseAfter(40, nTries, nextDeltaT_.value(), solved, error);
        ++(solved ? nRepeated_ : nFailed_);

        alpha_.primitiveFieldRef() = old;
        alpha_.correctBoundaryConditions();
        nextDeltaT_.value() *= 0.25;
    }
}
