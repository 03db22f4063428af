/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scaledLaplacian.H"
#include "gaussLaplacianScheme.H"

template<class Type>
Foam::scaledLaplacian<Type>::scaledLaplacian
(
    const surfaceScalarField& conductance,
    GeometricField<Type, fvPatchField, volMesh>& field
)
:
    matrix_
    (
        new fvMatrix<Type>
        (
           -fv::gaussLaplacianScheme<Type, scalar>::fvmLaplacianUncorrected
            (
                conductance*field.mesh().magSf(),
                field.mesh().nonOrthDeltaCoeffs(),
                field
            )
        )
    ),

    // Of the interior, since a mesh without walls has no other
    scale_(gAverage(matrix_->diag()))
{
    matrix_() *= dimensionedScalar("scale", dimless, 1/scale_);
}


template<class Type>
void Foam::scaledLaplacian<Type>::solve
(
    GeometricField<Type, fvPatchField, volMesh>& field,
    const Field<Type>& source,
    const dictionary& controls
)
{
    field == dimensioned<Type>("zero", field.dimensions(), Zero);

    const scalar size = gAverage(mag(source)());

    if (size > 0)
    {
        matrix_->source() = source/size;

        // Without a line in the log
        const int logged = SolverPerformance<Type>::debug;
        SolverPerformance<Type>::debug = 0;
        matrix_->solve(controls);
        SolverPerformance<Type>::debug = logged;

        field.primitiveFieldRef() *= size/scale_;
        field.correctBoundaryConditions();
    }
}
