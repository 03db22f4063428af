/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayTransport.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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


Foam::scalarField Foam::clayTransport::stiffnessOf
(
    const fvScalarMatrix& matrix
) const
{
    scalarField stiffness(matrix.diag());

    forAll(mesh_.boundary(), patchi)
    {
        const labelUList& cells = mesh_.boundary()[patchi].faceCells();
        const scalarField& ofPatch = matrix.internalCoeffs()[patchi];

        forAll(ofPatch, i)
        {
            stiffness[cells[i]] += ofPatch[i];
        }
    }
    return stiffness;
}


bool Foam::clayTransport::iterateNewton
(
    const scalarField& old,
    const scalar deltaT,
    surfaceScalarField& F,
    scalarField& missing,
    const scalar relative
)
{
    scalarField& alpha = alpha_.primitiveFieldRef();
    const scalarField content(aperture_.primitiveField()*mesh_.V()/deltaT);

    tmp<volScalarField> tchange(newChange());
    volScalarField& change = tchange.ref();
    fvScalarMatrix derivatives(change, dimVolume/dimTime);
    scalarField stiffness;

    // What the fluxes would change alpha by, less what it has changed
    const auto evaluate = [&]
    {
        alpha_.correctBoundaryConditions();
        flux_.evaluate(F, &derivatives);
        missing = -clayFlux::outflow(F) - content*(alpha - old);
        derivatives.diag() += content;
        stiffness = stiffnessOf(derivatives);
    };

    // In units of alpha: what a cell alone would change by
    const auto largest = [&]
    {
        return gMax(mag(missing/stiffness));
    };

    // In this norm two fields of clay that spreads never part, which makes it
    // the one to go downhill by
    const auto total = [&]
    {
        return gSum(mag(missing));
    };

    evaluate();
    scalar size = total();
    const scalar start = size;
    const auto enough = [&]
    {
        return
            relative > 0
          ? size <= relative*start
         || largest() <= ROOTVSMALL + 1e-14*gMax(alpha)
          : largest() <= residual_;
    };

    for (label i = 0; !enough(); ++i)
    {
        if (i == maxIterations_ || !(size < GREAT))
        {
            return false;
        }
        ++nIterations_;
        solveFor(change, derivatives, missing);

        // Newton's step, halved until less is missing
        const scalarField from(alpha);
        const scalarField stiffnessThere(stiffness);
        const scalar before = size;
        scalar share = 1;

        for (label halvings = 0; ; ++halvings)
        {
            flux_.change
            (
                alpha,
                from,
                share*change.primitiveField(),
                stiffnessThere
            );
            evaluate();
            size = total();

            if (size < before || enough())
            {
                break;
            }
            if (halvings == 6)
            {
                // Towards the steady state anything less will do
                return relative > 0 && size < start;
            }
            share *= 0.5;
        }
    }
    return true;
}
