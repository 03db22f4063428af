/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "errorAt.H"
#include "dictionaryText.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::OSstream& Foam::colloid::errorAt
(
    const dictionary& dict,
    const word& keyword
)
{
    const entry* given = dict.findEntry(keyword, keyType::LITERAL);

    if (given)
    {
        return errorAt(dict, *given);
    }
    return FatalIOError
    (
        FUNCTION_NAME,
        __FILE__,
        __LINE__,
        dict.name(),
        dict.startLineNumber(),
        dict.endLineNumber()
    );
}


Foam::OSstream& Foam::colloid::errorAt
(
    const dictionary& dict,
    const entry& wrong
)
{
    return FatalIOError
    (
        FUNCTION_NAME,
        __FILE__,
        __LINE__,
        dict.name(),
        wrong.startLineNumber(),
        wrong.endLineNumber()
    );
}


Foam::OSstream& Foam::colloid::errorAt
(
    const fileName& path,
    const wordList& words
)
{
    const label line = dictionaryText(path).lineOf(words);

    return FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, path, line, line);
}


// ************************************************************************* //
