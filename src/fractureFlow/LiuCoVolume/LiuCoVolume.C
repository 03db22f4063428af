/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "LiuCoVolume.H"
#include "calculatedFvPatchFields.H"
#include "errorAt.H"
#include "IOdictionary.H"
#include "surfaceFields.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace viscosityModels
{
    defineTypeNameAndDebug(LiuCoVolume, 0);
    addToRunTimeSelectionTable(viscosityModel, LiuCoVolume, dictionary);
}
}

static const Foam::word alphaName("alpha.clay");
static const Foam::word concentrationName("c");


// A calculated value is left to whoever made the field, who need not
static bool isFixed(const Foam::fvPatchScalarField& patch)
{
    return
        patch.fixesValue()
     && !Foam::isA<Foam::calculatedFvPatchScalarField>(patch);
}


static Foam::scalarField fixedOrInternal(const Foam::fvPatchScalarField& patch)
{
    return
        isFixed(patch)
      ? Foam::scalarField(patch)
      : Foam::scalarField(patch.patchInternalField());
}


void Foam::viscosityModels::LiuCoVolume::refuseCoeffs
(
    const dictionary& viscosityProperties
)
{
    const dictionary& coeffs =
        viscosityProperties.subOrEmptyDict(typeName + "Coeffs");

    if (!coeffs.empty())
    {
        FatalIOErrorInFunction(viscosityProperties)
            << typeName << "Coeffs has entries " << flatOutput(coeffs.toc())
            << nl << "The coefficients of " << typeName << " are those of"
            << " constant/clayProperties (platelet, water, viscosity,"
            << " flocculation), so that each number is in one place;"
            << " leave " << typeName << "Coeffs out"
            << exit(FatalIOError);
    }
}


const Foam::volScalarField& Foam::viscosityModels::LiuCoVolume::alpha()
{
    const Time& time = U_.time();

    if (!alpha_ && !ownAlpha_.valid())
    {
        alpha_ = U_.db().findObject<volScalarField>(alphaName);
    }

    if (alpha_)
    {
        return *alpha_;
    }

    const auto io = [&](const bool registered)
    {
        return IOobject
        (
            alphaName,
            time.timeName(),
            U_.db(),
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE,
            registered
        );
    };

    if (!ownAlpha_.valid())
    {
        ownAlpha_.reset(new volScalarField(io(true), U_.mesh()));
    }
    else if (alphaTimeIndex_ != time.timeIndex())
    {
        IOobject later(io(false));

        if (later.typeHeaderOk<volScalarField>(true))
        {
            *ownAlpha_ == volScalarField(later, U_.mesh());
        }
    }
    alphaTimeIndex_ = time.timeIndex();

    return *ownAlpha_;
}


void Foam::viscosityModels::LiuCoVolume::updateLaw()
{
    const Time& time = U_.time();

    if
    (
        !law_.valid()
     || (properties_->concentrationVaries() && lawTime_ != time.value())
    )
    {
        lawTime_ = time.value();
        law_ = autoPtr<colloid::coVolumeViscosity>::New
        (
            properties_->viscosity(properties_->waterAt(lawTime_))
        );
    }
}


void Foam::viscosityModels::LiuCoVolume::evaluate
(
    scalarField& nu,
    const scalarField& alpha
) const
{
    const scalar nuWater = this->nuWater().value();

    forAll(nu, i)
    {
        nu[i] = nuWater*law_->relativeViscosity(alpha[i]);
    }
}


void Foam::viscosityModels::LiuCoVolume::evaluate
(
    scalarField& nu,
    const scalarField& alpha,
    const scalarField& c
) const
{
    const scalar nuWater = this->nuWater().value();

    forAll(nu, i)
    {
        // Also of not a number
        if (!(c[i] > 0))
        {
            FatalErrorInFunction
                << "The concentration of salt is " << c[i] << " mol/m3 in "
                << "field " << concentrationName << " at time "
                << U_.time().timeName() << nl
                << "Without salt the platelets' double layers have no end;"
                << " it has to be above zero everywhere"
                << exit(FatalError);
        }
        nu[i] = nuWater*law_->at(c[i]).relativeViscosity(alpha[i]);
    }
}


const Foam::volScalarField*
Foam::viscosityModels::LiuCoVolume::localConcentration() const
{
    const auto* c = U_.db().findObject<volScalarField>(concentrationName);

    if (c && c->dimensions() != dimMoles/dimVolume)
    {
        colloid::errorAt(c->objectPath(), wordList({"dimensions"}))
            << c->objectPath() << " has dimensions " << c->dimensions() << nl
            << "A field of this name is taken for the concentration of salt,"
            << " mol/m3, [0 -3 0 0 1 0 0]"
            << exit(FatalIOError);
    }

    return c;
}


Foam::viscosityModels::LiuCoVolume::LiuCoVolume
(
    const word& name,
    const dictionary& viscosityProperties,
    const volVectorField& U,
    const surfaceScalarField& phi,
    const volScalarField* alpha,
    colloid::clayProperties* properties
)
:
    viscosityModel(name, viscosityProperties, U, phi),
    alpha_(alpha),
    alphaTimeIndex_(-1),
    properties_(properties),
    lawTime_(0),
    nu_
    (
        IOobject
        (
            name,
            U.time().timeName(),
            U.db(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        U.mesh(),
        dimensionedScalar(dimViscosity, Zero),
        calculatedFvPatchScalarField::typeName
    )
{
    refuseCoeffs(viscosityProperties);
    correct();
}


Foam::viscosityModels::LiuCoVolume::LiuCoVolume
(
    const word& name,
    const dictionary& viscosityProperties,
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    LiuCoVolume
    (
        name,
        viscosityProperties,
        U,
        phi,
        nullptr,
        new colloid::clayProperties(U.time())
    )
{}


Foam::viscosityModels::LiuCoVolume::LiuCoVolume
(
    const word& name,
    const volVectorField& U,
    const surfaceScalarField& phi,
    const volScalarField& alpha
)
:
    LiuCoVolume
    (
        name,
        dictionary(),
        U,
        phi,
        &alpha,
        new colloid::clayProperties
        (
            IOdictionary
            (
                IOobject
                (
                    "clayProperties",
                    U.time().constant(),
                    U.time(),
                    IOobject::MUST_READ,
                    IOobject::NO_WRITE,
                    false
                )
            )
        )
    )
{}


Foam::dimensionedScalar
Foam::viscosityModels::LiuCoVolume::nuWater() const
{
    return dimensionedScalar
    (
        "nuWater",
        dimViscosity,
        water().viscosity/water().density
    );
}


void Foam::viscosityModels::LiuCoVolume::correct()
{
    const volScalarField& alpha = this->alpha();
    updateLaw();

    const volScalarField* c = localConcentration();

    if (c)
    {
        evaluate
        (
            nu_.primitiveFieldRef(),
            alpha.primitiveField(),
            c->primitiveField()
        );
    }
    else
    {
        evaluate(nu_.primitiveFieldRef(), alpha.primitiveField());
    }
    nu_.correctBoundaryConditions();

    volScalarField::Boundary& nuBoundary = nu_.boundaryFieldRef();

    forAll(nuBoundary, patchi)
    {
        const fvPatchScalarField& alphaPatch = alpha.boundaryField()[patchi];

        if (alphaPatch.coupled())
        {
            continue;
        }

        if
        (
            c
         && (isFixed(alphaPatch) || isFixed(c->boundaryField()[patchi]))
        )
        {
            evaluate
            (
                nuBoundary[patchi],
                fixedOrInternal(alphaPatch),
                fixedOrInternal(c->boundaryField()[patchi])
            );
        }
        else if (isFixed(alphaPatch))
        {
            evaluate(nuBoundary[patchi], alphaPatch);
        }
        else
        {
            nuBoundary[patchi] = nuBoundary[patchi].patchInternalField();
        }
    }
}


bool Foam::viscosityModels::LiuCoVolume::read
(
    const dictionary& viscosityProperties
)
{
    viscosityModel::read(viscosityProperties);
    refuseCoeffs(viscosityProperties);

    return true;
}
