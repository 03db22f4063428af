/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fractureAperture.H"
#include "checkWords.H"
#include "cubicLaw.H"
#include "emptyPolyPatch.H"
#include "readInRange.H"
#include "zeroGradientFvPatchFields.H"


void Foam::fractureAperture::findThickness(const dictionary& coeffs)
{
    const Vector<label>& solved = mesh_.solutionD();

    // A wedge is solved in all directions, and no fracture
    if (solved != mesh_.geometricD() || mesh_.nSolutionD() != 2)
    {
        FatalIOErrorInFunction(coeffs)
            << "The mesh has no direction across the fracture: "
            << mesh_.nSolutionD() << " directions are solved in, by its patches"
            << " of type empty" << nl
            << "HeleShaw needs a mesh of the fracture's plane, one cell thick,"
            << " with type empty for the patches in front and behind." << nl
            << "Platelets (clayFoam) move in three dimensions and cannot have"
            << " that: for them Stokes or NavierStokes"
            << exit(FatalIOError);
    }

    labelList nEmptyFaces(mesh_.nCells(), Zero);
    scalar area = 0;

    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(pp))
        {
            for (const label celli : pp.faceCells())
            {
                ++nEmptyFaces[celli];
            }
            area += sum(mag(pp.faceAreas()))/2;
        }
    }

    bool oneCell = true;
    for (const label n : nEmptyFaces)
    {
        oneCell = oneCell && n == 2;
    }

    if (!returnReduce(oneCell, andOp<bool>()))
    {
        FatalIOErrorInFunction(coeffs)
            << "The mesh is not one cell thick: there are cells without an"
            << " empty patch both in front and behind"
            << exit(FatalIOError);
    }

    thickness_ = gSum(mesh_.V())/returnReduce(area, sumOp<scalar>());
}


void Foam::fractureAperture::readField
(
    const dictionary& coeffs,
    const word& entryName,
    const word& fieldName,
    const dimensionSet& dimensions
)
{
    const Time& time = mesh_.time();

    IOobject io
    (
        fieldName,
        time.timeName(),
        mesh_,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    // Both must be seen alike by all ranks
    const auto isThere = [&]()
    {
        return returnReduce
        (
            io.typeHeaderOk<volScalarField>(true), andOp<bool>()
        );
    };

    if (!isThere())
    {
        io.instance() = time.constant();

        if (!isThere())
        {
            FatalIOErrorInFunction(coeffs)
                << "Entry " << entryName << " names the field " << fieldName
                << ", a volScalarField that is neither in "
                << time.timePath() << " nor in " << io.path() << nl
                << "In parallel each processor folder needs its part:"
                << " decomposePar does that for fields in time directories"
                << exit(FatalIOError);
        }
    }

    const volScalarField field(io, mesh_);

    if (field.dimensions() != dimensions)
    {
        FatalIOErrorInFunction(coeffs)
            << io.objectPath() << ", the field of entry " << entryName
            << ", has dimensions " << field.dimensions() << ", not "
            << dimensions << exit(FatalIOError);
    }

    given_.reset
    (
        new volScalarField
        (
            IOobject
            (
                fieldName,
                time.timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            field
        )
    );
    aperture_.primitiveFieldRef() = field.primitiveField();
}


void Foam::fractureAperture::read
(
    const dictionary& coeffs,
    const word& entryName,
    const dimensionSet& dimensions,
    const scalar lower,
    const scalar upper,
    const char* unit
)
{
    ITstream& is = coeffs.lookup(entryName, keyType::LITERAL);
    const token first(is);

    if (!first.isWord())
    {
        aperture_.primitiveFieldRef() =
            colloid::readInRange(coeffs, entryName, lower, upper, unit);
        return;
    }

    colloid::checkAllRead(coeffs, entryName, is);
    readField(coeffs, entryName, first.wordToken(), dimensions);

    const scalar least = gMin(aperture_.primitiveField());
    const scalar most = gMax(aperture_.primitiveField());

    if (least < lower || most > upper)
    {
        FatalIOErrorInFunction(coeffs)
            << "Impossible " << entryName << " in field "
            << first.wordToken() << ": from " << least << " to " << most << nl
            << "Valid: from " << lower << " to " << upper << ' ' << unit
            << "; a closed place is no cell of the mesh, or a small number"
            << exit(FatalIOError);
    }
}


Foam::fractureAperture::fractureAperture
(
    const fvMesh& mesh,
    const dictionary& coeffs,
    const scalar nuWater
)
:
    mesh_(mesh),
    thickness_(0),
    aperture_
    (
        IOobject("apertureOfFracture", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimLength, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    ratio_
    (
        IOobject("apertureRatio", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    )
{
    findThickness(coeffs);

    const bool byAperture = coeffs.found("aperture", keyType::LITERAL);

    if (byAperture == coeffs.found("transmissivity", keyType::LITERAL))
    {
        FatalIOErrorInFunction(coeffs)
            << (byAperture ? "Both" : "Neither") << " aperture [m] "
            << (byAperture ? "and" : "nor") << " transmissivity [m2/s] given"
            << nl << "One of them is needed, a number or the name of a field"
            << exit(FatalIOError);
    }

    if (byAperture)
    {
        read
        (
            coeffs,
            "aperture",
            dimLength,
            colloid::narrowestFracture,
            colloid::widestFracture,
            "m"
        );
    }
    else
    {
        read
        (
            coeffs,
            "transmissivity",
            dimViscosity,
            colloid::transmissivityOf(colloid::narrowestFracture, nuWater),
            colloid::transmissivityOf(colloid::widestFracture, nuWater),
            "m2/s"
        );

        for (scalar& b : aperture_.primitiveFieldRef())
        {
            b = colloid::apertureOf(b, nuWater);
        }
    }

    aperture_.correctBoundaryConditions();
    ratio_ = aperture_/dimensionedScalar("thickness", dimLength, thickness_);

    const scalarField& V = mesh_.V();

    Info<< "Aperture" << (byAperture ? "" : " of the transmissivity")
        << ": smallest " << gMin(aperture_.primitiveField())
        << ", mean " << gSum(V*aperture_.primitiveField())/gSum(V)
        << ", largest " << gMax(aperture_.primitiveField())
        << " m; the mesh is " << thickness_ << " m thick" << endl;
}
