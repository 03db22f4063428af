/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "transportCase.H"
#include "fixedValueFvPatchFields.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "zeroGradientFvPatchFields.H"

using namespace Foam;


transportCase::transportCase
(
    const boxSpec& spec,
    const wordList& fixed,
    const texts& text
)
:
    c(spec),
    matter(dictionaryOf(text.clay)),
    erosion(dictionaryOf(text.erosion))
{
    c.writeClayProperties(text.clay);
    write
    (
        "system/fvSchemes",
        "ddtSchemes { default " + text.ddt + "; }"
        "gradSchemes { default Gauss linear; }"
        "divSchemes { div(phi,alpha.clay) Gauss " + text.advection + ";"
        " div(phi,c) Gauss linear; }"
        "interpolationSchemes { default linear; }"
        "laplacianSchemes { default Gauss linear corrected; }"
        "snGradSchemes { default corrected; }"
    );
    write
    (
        "system/fvSolution",
        "solvers { alpha.clay { solver PBiCGStab; preconditioner DILU;"
        " tolerance 1e-14; relTol 1e-4; }"
        " c { solver PBiCGStab; preconditioner DILU;"
        " tolerance 1e-12; relTol 0; } }"
        "erosion {" + text.controls + "}"
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
    flow = fractureFlow::New(c.mesh(), alpha(), dictionaryOf(text.flow));
}


void transportCase::makeTransport
(
    const surfaceScalarField* phi,
    const volScalarField* apertureRatio
)
{
    alpha->correctBoundaryConditions();
    clay.reset
    (
        new clayTransport
        (
            alpha(),
            phi ? *phi : flow->phi(),
            apertureRatio ? *apertureRatio : flow->apertureRatio(),
            nullptr,
            matter,
            erosion
        )
    );
}


void transportCase::write(const fileName& name, const string& text)
{
    if (Pstream::master())
    {
        const fileName file(c.time().globalPath()/name);
        mkDir(file.path());
        OFstream os(file);
        os  << "FoamFile { version 2.0; format ascii; class "
            << (name.name() == "g" ? "uniformDimensionedVectorField" : "dictionary")
            << "; object " << name.name().c_str() << "; }\n" << text.c_str()
            << endl;
    }
    label written = 1;
    reduce(written, sumOp<label>());
}


scalarField& transportCase::patch(const word& name)
{
    return alpha->boundaryFieldRef()
        [c.mesh().boundaryMesh().findPatchID(name)];
}


const vectorField& transportCase::faceCentres(const word& name)
{
    return c.mesh().Cf().boundaryField()
        [c.mesh().boundaryMesh().findPatchID(name)];
}


label transportCase::solveSteady(const label most)
{
    for (label i = 1; i <= most; ++i)
    {
        ++c.time();
        flow->solve();
        if (clay->converged(clay->iterate()))
        {
            return i;
        }
    }
    return -1;
}


void transportCase::advance(const scalar duration)
{
    for (scalar done = 0; done < duration*(1 - 1e-12); )
    {
        const scalar step = min(clay->nextDeltaT(), duration - done);

        // OpenFOAM keeps a list of what was solved at a time
        ++c.time();
        clay->advance(step);
        done += step;
    }
}


scalar transportCase::leaving(const word& name)
{
    return gSum
    (
        clay->alphaPhi().boundaryField()
            [c.mesh().boundaryMesh().findPatchID(name)]
    );
}


boxSpec bar(const label n, const scalar length)
{
    boxSpec spec;
    spec.size = vector(length, 1, 1);
    spec.cells = {n, 1, 1};
    spec.patches = {"left", "right", "sides", "sides", "sides", "sides"};
    spec.types = {"patch", "patch", "empty", "empty", "empty", "empty"};
    return spec;
}


tmp<volScalarField> fieldOf
(
    const fvMesh& mesh,
    const word& name,
    const dimensionSet& dimensions,
    const std::function<scalar(const vector&)>& f
)
{
    tmp<volScalarField> tfield
    (
        new volScalarField
        (
            IOobject
            (
                name,
                mesh.time().timeName(),
                mesh,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh,
            dimensionedScalar(dimensions, Zero)
        )
    );
    volScalarField& field = tfield.ref();

    forAll(field, celli)
    {
        field[celli] = f(mesh.C()[celli]);
    }
    forAll(field.boundaryField(), patchi)
    {
        fvPatchScalarField& patch = field.boundaryFieldRef()[patchi];
        forAll(patch, i)
        {
            patch[i] = f(mesh.Cf().boundaryField()[patchi][i]);
        }
    }
    field.correctBoundaryConditions();
    return tfield;
}
