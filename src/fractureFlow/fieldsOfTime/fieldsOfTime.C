/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldsOfTime.H"
#include "incompleteMarker.H"
#include "IOobjectList.H"
#include "PstreamReduceOps.H"
#include "surfaceFields.H"
#include "Time.H"
#include "volFields.H"


template<class FieldType>
void Foam::fieldsOfTime::read
(
    const fvMesh& mesh,
    const IOobjectList& objects
)
{
    for (const word& name : objects.sortedNames())
    {
        if
        (
            objects[name]->headerClassName() == FieldType::typeName
         && !mesh.foundObject<regIOobject>(name)
        )
        {
            fields_.append
            (
                new FieldType
                (
                    IOobject
                    (
                        name,
                        mesh.time().timeName(),
                        mesh,
                        IOobject::MUST_READ,
                        IOobject::NO_WRITE
                    ),
                    mesh
                )
            );
        }
    }
}


Foam::fieldsOfTime::fieldsOfTime(const fvMesh& mesh)
{
    const IOobjectList objects(mesh, mesh.time().timeName());

    read<volScalarField>(mesh, objects);
    read<volVectorField>(mesh, objects);
    read<volSphericalTensorField>(mesh, objects);
    read<volSymmTensorField>(mesh, objects);
    read<volTensorField>(mesh, objects);
    read<surfaceScalarField>(mesh, objects);
    read<surfaceVectorField>(mesh, objects);
}


bool Foam::fieldsOfTime::isInterrupted(const fvMesh& mesh)
{
    const bool marked = returnReduce
    (
        incompleteMarker::found(mesh.time().timePath()), orOp<bool>()
    );
    if (marked)
    {
        Info<< "Left out: the run was interrupted while it wrote this time"
            << nl << endl;
    }
    return marked;
}
