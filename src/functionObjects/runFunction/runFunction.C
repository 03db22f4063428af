/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "runFunction.H"
#include "checkWords.H"
#include "fvMesh.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::functionObjects::runFunction::missing() const
{
    for (const word& object : needs_.objects)
    {
        // A rank may lack a file that the others have
        if
        (
            !returnReduce
            (
                mesh_.foundObject<regIOobject>(object), andOp<bool>()
            )
        )
        {
            return object;
        }
    }
    return word();
}


void Foam::functionObjects::runFunction::checkWords
(
    const dictionary& dict
) const
{
    // What OpenFOAM reads of any function object, and of one that writes files
    wordList words
    ({
        "type", "libs", "functionObjectLibs", "enabled", "log", "errors",
        "region", "useNamePrefix",
        "executeControl", "executeInterval", "writeControl", "writeInterval",
        "outputControl", "outputInterval", "timeStart", "timeEnd",
        "triggerStart", "triggerEnd", "controlMode", "deltaTCoeff",
        "nStepsToStartTimeChange", "writePrecision", "writeToFile",
        "useUserTime", "updateHeader", "subRegion"
    });
    words.append(needs_.words);
    colloid::checkWords(dict, words);

    const word control(dict.getOrDefault<word>("executeControl", "timeStep"));

    if
    (
        needs_.eachStep
     && (
            (control != "timeStep" && control != "always")
         || (control == "timeStep"
         && dict.getOrDefault<scalar>("executeInterval", 1) > 1)
        )
    )
    {
        FatalIOErrorInFunction(dict)
            << dict.get<word>("type") << ' ' << name() << " looks at each step:"
            << " executeControl " << control << " would leave some out." << nl
            << "    When it writes: writeControl and writeInterval"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::runFunction::runFunction
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const requirements& needs
)
:
    fvMeshFunctionObject(name, runTime, dict),
    needs_(needs)
{
    // Before members of it take for granted what is not there
    checkWords(dict);

    if (postProcess)
    {
        if (idle())
        {
            Info<< dict.get<word>("type") << ' ' << name
                << " is left out: " << needs_.ofRun.c_str() << nl << endl;
        }
        return;
    }

    const word lacking(missing());

    if (!lacking.empty())
    {
        FatalIOErrorInFunction(dict)
            << dict.get<word>("type") << ' ' << name << " is for runs of "
            << needs_.solver << ": it takes " << flatOutput(needs_.objects)
            << ',' << nl << "    and " << getEnv("FOAM_EXECUTABLE").c_str()
            << " has no " << lacking << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::runFunction::read(const dictionary& dict)
{
    checkWords(dict);
    return fvMeshFunctionObject::read(dict);
}


bool Foam::functionObjects::runFunction::ready() const
{
    if (idle())
    {
        return false;
    }

    const word lacking(postProcess ? missing() : word());

    if (!lacking.empty())
    {
        Info<< type() << ' ' << name() << ": time " << time_.timeName()
            << " has no " << lacking << ", left out" << endl;
        return false;
    }
    return true;
}
