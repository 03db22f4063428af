/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayContent.H"
#include "meshIdentity.H"
#include "Time.H"
#include "volFields.H"

namespace
{

//- Of the weight, through the mesh along each axis [rad]: no symmetry, and no
//  exchange of axes, leaves it as it is
const Foam::vector waves(7.1, 13.3, 23.7);

} // End anonymous namespace


Foam::clayContent::clayContent(const volScalarField& alpha)
:
    IOdictionary
    (
        IOobject
        (
            "clayContent",
            alpha.mesh().time().timeName(),
            "uniform",
            alpha.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    alpha_(alpha)
{
    // None: a start, or a time of an older version
    if (!returnReduce(found("mesh"), andOp<bool>()))
    {
        return;
    }
    const polyMesh& mesh = alpha.mesh();
    const meshIdentity before(subDict("mesh"));
    const string otherMesh(before.difference(meshIdentity(mesh)));

    if (!otherMesh.empty())
    {
        FatalErrorInFunction
            << "The mesh is not that of time " << mesh.time().timeName() << " ("
            << objectPath() << "):" << nl
            << "    " << otherMesh.c_str() << "." << nl
            << "    Make that mesh again, or bring the time into this one with"
            << " mapFields" << exit(FatalError);
    }

    const Pair<scalar> was(get<scalar>("clay"), get<scalar>("weighted"));
    const Pair<scalar> is(now());

    // A wave through the mesh, and digits of places as a part of it
    const vector off(before.roundOffOfPlaces());
    const vector extent(mesh.bounds().span());
    scalar tolerance = 2*meshIdentity::roundOff();
    for (direction axis = 0; axis < 3; ++axis)
    {
        tolerance += 2*waves[axis]*off[axis]/max(extent[axis], VSMALL);
    }

    if
    (
        mag(is.first() - was.first()) > tolerance*mag(was.first())
     || mag(is.second() - was.second()) > tolerance*mag(was.first())
    )
    {
        FatalErrorInFunction
            << "alpha.clay of time " << mesh.time().timeName() << " is not what"
            << " was written with " << objectPath() << ":" << nl
            << "    in this mesh it is " << is.first() << " m3 of clay, then "
            << was.first() << " m3"
            << (
                   mag(is.first() - was.first()) > tolerance*mag(was.first())
                 ? "" : ", in other places"
               )
            << "." << nl
            << "    Was the mesh renumbered (renumberMesh) or changed, or is the"
            << " field of another run?" << nl
            << "    Bring back the mesh or the field; if the field was changed on"
            << " purpose, remove " << name() << exit(FatalError);
    }
}


Foam::Pair<Foam::scalar> Foam::clayContent::now() const
{
    const fvMesh& mesh = alpha_.mesh();
    const volVectorField& C = mesh.C();
    const point& lower = mesh.bounds().min();
    const vector extent(mesh.bounds().span());

    Pair<scalar> sum(0, 0);
    forAll(alpha_, celli)
    {
        const vector from(C[celli] - lower);
        scalar phase = 1;
        for (direction axis = 0; axis < 3; ++axis)
        {
            phase += waves[axis]*from[axis]/max(extent[axis], VSMALL);
        }
        const scalar clay = mesh.V()[celli]*alpha_[celli];
        sum.first() += clay;
        sum.second() += clay*Foam::sin(phase);
    }
    reduce(sum.first(), sumOp<scalar>());
    reduce(sum.second(), sumOp<scalar>());
    return sum;
}


bool Foam::clayContent::writeData(Ostream& os) const
{
    const int precision = os.precision(17);
    const Pair<scalar> all(now());
    const polyMesh& mesh = alpha_.mesh();

    os.beginBlock("mesh");
    meshIdentity(mesh).write(os);
    os.endBlock();
    os.writeEntry("clay", all.first());
    os.writeEntry("weighted", all.second());

    os.precision(precision);
    return os.good();
}
