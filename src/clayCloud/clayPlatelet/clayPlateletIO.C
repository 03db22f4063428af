/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayPlatelet.H"
#include "Cloud.H"
#include "IOField.H"
#include "completeTimes.H"

namespace
{

using Foam::Cloud;
using Foam::IOField;
using Foam::IOobject;
using Foam::clayPlatelet;

template<class Type>
void readField
(
    Cloud<clayPlatelet>& cloud,
    const char* name,
    Type clayPlatelet::properties::*member
)
{
    IOField<Type> field
    (
        cloud.fieldIOobject(name, IOobject::MUST_READ),
        cloud.size() > 0
    );
    cloud.checkFieldIOobject(cloud, field);

    Foam::label i = 0;
    for (clayPlatelet& p : cloud)
    {
        p.state().*member = field[i++];
    }
}


template<class Type>
void writeField
(
    const Cloud<clayPlatelet>& cloud,
    const char* name,
    const Type clayPlatelet::properties::*member
)
{
    IOField<Type> field
    (
        cloud.fieldIOobject(name, IOobject::NO_READ),
        cloud.size()
    );

    Foam::label i = 0;
    for (const clayPlatelet& p : cloud)
    {
        field[i++] = p.state().*member;
    }
    field.write(cloud.size() > 0);
}


//- The fields that a cloud is stored in: one list for reading and writing
template<class Action>
void forEachField(Action action)
{
    using properties = clayPlatelet::properties;

    action("x", &properties::x);
    action("U", &properties::U);
    action("F", &properties::F);
    action("previousVelocity", &properties::previousVelocity);
    action("previousStep", &properties::previousStep);
    action("id", &properties::id);
    action("fixed", &properties::fixed);
    action("inlet", &properties::inlet);
}


//- FatalError if a rank has platelets without one of their fields: OpenFOAM's
//  own would end it with a stack
void checkWhole(const Cloud<clayPlatelet>& cloud)
{
    if (!cloud.size())
    {
        return;
    }

    const auto check = [&](const char* name, const auto&...)
    {
        const Foam::fileName file
        (
            cloud.fieldIOobject(name, IOobject::NO_READ).objectPath()
        );

        if (!Foam::completeTimes::holds(file.path(), file.name()))
        {
            FatalErrorInFunction
                << "Time " << cloud.time().timeName() << " is not whole: "
                << file << " is missing." << Foam::nl
                << "    Start from an earlier one, or make it anew: setClay for"
                << " a first time (then decomposePar)," << Foam::nl
                << "    reconstructPar -time " << cloud.time().timeName()
                << " for one that is whole in the processor directories"
                << Foam::exit(Foam::FatalError);
        }
    };

    check("origProcId");
    check("origId");
    forEachField(check);
}

} // End anonymous namespace


Foam::clayPlatelet::clayPlatelet
(
    const polyMesh& mesh,
    Istream& is,
    bool readFields,
    bool newFormat
)
:
    particle(mesh, is, readFields, newFormat)
{
    // Only transfers between processors read the properties here; files hold
    // them as fields
    if (readFields)
    {
        is.read(reinterpret_cast<char*>(&properties_), sizeof(properties));
    }

    is.check(FUNCTION_NAME);
}


void Foam::clayPlatelet::readFields(Cloud<clayPlatelet>& cloud)
{
    checkWhole(cloud);
    particle::readFields(cloud);

    forEachField
    (
        [&](const char* name, auto member)
        {
            readField(cloud, name, member);
        }
    );
}


void Foam::clayPlatelet::writeFields(const Cloud<clayPlatelet>& cloud)
{
    particle::writeFields(cloud);

    forEachField
    (
        [&](const char* name, auto member)
        {
            writeField(cloud, name, member);
        }
    );
}


Foam::Ostream& Foam::operator<<(Ostream& os, const clayPlatelet& p)
{
    os  << static_cast<const particle&>(p);
    os.write
    (
        reinterpret_cast<const char*>(&p.properties_),
        sizeof(clayPlatelet::properties)
    );

    os.check(FUNCTION_NAME);
    return os;
}
