/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "kernelFilter.H"

Foam::kernelFilter::kernelFilter
(
    const fvMesh& mesh,
    const scalar length,
    const scalar timeScale
)
:
    mesh_(mesh),
    axes_(mesh),
    length_(length),
    timeScale_(timeScale)
{}


void Foam::kernelFilter::update
(
    const UList<point>& positions,
    const labelUList& cells,
    const UList<vector>& velocities,
    const scalar plateletVolume,
    const scalar,
    volScalarField& alpha,
    volVectorField& Uclay
)
{
    const vectorField& C = mesh_.C();
    const scalarField& V = mesh_.V();
    scalarField weight(C.size(), Zero);
    vectorField momentum(C.size(), Zero);
    scalarField kernel(C.size());

    forAll(positions, k)
    {
        scalar total = 0;
        forAll(C, i)
        {
            const scalar q =
                mag(axes_.nearestImage(positions[k] - C[i]))/length_;
            kernel[i] = q < 1 ? (1 - sqr(q)*(3 - 2*q))*V[i] : 0;
            total += kernel[i];
        }
        if (total <= 0)
        {
            kernel[cells[k]] = total = 1;
        }
        forAll(C, i)
        {
            if (kernel[i] > 0)
            {
                weight[i] += kernel[i]/total;
                momentum[i] += kernel[i]/total*velocities[k];
            }
        }
    }

    forAll(C, i)
    {
        alpha[i] = weight[i]*plateletVolume/V[i];
        Uclay[i] = weight[i] > 0 ? momentum[i]/weight[i] : Zero;
    }
    alpha.correctBoundaryConditions();
    Uclay.correctBoundaryConditions();
}
