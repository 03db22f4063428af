/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseFile.H"
#include "errorAt.H"

#include "messageStream.H"
#include "OSspecific.H"

#include <set>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Of each `file` in the dictionary and what is in it
void replaceFiles(dictionary& dict)
{
    for (entry& e : dict)
    {
        if (e.isDict())
        {
            replaceFiles(e.dict());
        }
    }
    if (dict.found("file", keyType::LITERAL))
    {
        dict.set("file", colloid::caseFile(dict, "file"));
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::colloid::caseFile
(
    const fileName& written,
    const fileName& folder
)
{
    fileName path(written);

    // Which OpenFOAM takes for the folder that the program was started in
    while (path.size() > 1 && path[0] == '.' && path[1] == '/')
    {
        path.erase(0, 2);
    }
    path.expand();

    if (!path.isAbsolute())
    {
        const fileName root(getEnv("FOAM_CASE"));
        path = (root.empty() ? cwd() : root)/folder/path;
    }
    path.clean();

    return path;
}


Foam::fileName Foam::colloid::caseFile
(
    const dictionary& dict,
    const word& keyword
)
{
    const fileName written(dict.get<fileName>(keyword, keyType::LITERAL));
    const fileName path(caseFile(written));

    if (!isFile(path))
    {
        errorAt(dict, keyword)
            << keyword << " is " << written << nl
            << (isDir(path) ? "A folder, no file: " : "There is no file ")
            << path << nl
            << "A name that does not begin with / is relative to the case"
            << exit(FatalIOError);
    }

    // Dictionaries are read again and again
    static std::set<std::string> said;

    if (said.insert(path).second)
    {
        Info<< "Reading " << path << endl;
    }

    return path;
}


Foam::dictionary Foam::colloid::withCaseFiles
(
    const dictionary& dict,
    const word& keyword
)
{
    dictionary resolved(dict);

    for (const word& name : {keyword, word(keyword + "Coeffs")})
    {
        if (dictionary* found = resolved.findDict(name, keyType::LITERAL))
        {
            replaceFiles(*found);
        }
    }

    return resolved;
}


// ************************************************************************* //
