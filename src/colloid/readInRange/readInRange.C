/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readInRange.H"
#include "checkWords.H"
#include "errorAt.H"

#include <cmath>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::readInRange
(
    const dictionary& dict,
    const word& keyword,
    const scalar lower,
    const scalar upper,
    const char* unit
)
{
    const entry* given = dict.findEntry(keyword, keyType::LITERAL);

    if (!given)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << keyword << "' is missing in " << dict.dictName()
            << nl << "It is a number from " << lower << " to " << upper
            << ' ' << unit << nl
            << exit(FatalIOError);
    }

    ITstream& is = given->stream();
    const token first(is);

    if (!first.isNumber())
    {
        errorAt(dict, *given)
            << "Entry '" << keyword << "' in " << dict.dictName()
            << " is not a number" << nl
            << "Valid: from " << lower << " to " << upper << ' ' << unit << nl
            << exit(FatalIOError);
    }

    is.putBack(first);
    const scalar value = readWithUnit<scalar>(dict, keyword, is, unit);

    // nan first: comparing it would trap
    if (!std::isfinite(value) || value < lower || value > upper)
    {
        errorAt(dict, *given)
            << "Impossible " << keyword << ' ' << value << " in "
            << dict.dictName() << nl
            << "Valid: from " << lower << " to " << upper << ' ' << unit << nl
            << exit(FatalIOError);
    }

    return value;
}


Foam::scalar Foam::colloid::readInRange
(
    const dictionary& dict,
    const word& keyword,
    const scalar defaultValue,
    const scalar lower,
    const scalar upper,
    const char* unit
)
{
    return
        dict.found(keyword, keyType::LITERAL)
      ? readInRange(dict, keyword, lower, upper, unit)
      : defaultValue;
}


std::optional<Foam::scalar> Foam::colloid::numberOrWord
(
    const dictionary& dict,
    const word& keyword,
    const word& instead,
    const scalar lower,
    const scalar upper,
    const char* unit
)
{
    const entry* given = dict.findEntry(keyword, keyType::LITERAL);

    if (!given)
    {
        return std::nullopt;
    }

    ITstream& is = given->stream();
    const token first(is);

    if (first.isNumber())
    {
        return readInRange(dict, keyword, lower, upper, unit);
    }
    if (!first.isWord())
    {
        errorAt(dict, *given)
            << "Entry '" << keyword << "' is neither a number nor the word "
            << instead << exit(FatalIOError);
    }
    checkChoice(dict, keyword, first.wordToken(), wordList({instead}));
    checkAllRead(dict, keyword, is);

    return std::nullopt;
}


void Foam::colloid::checkAllRead
(
    const dictionary& dict,
    const word& keyword,
    const ITstream& is
)
{
    if (is.nRemainingTokens())
    {
        auto& message = FatalIOError
        (
            FUNCTION_NAME,
            __FILE__,
            __LINE__,
            dict.name(),
            is.lineNumber(),
            is.lineNumber()
        );

        message << "Too much in entry '" << keyword << "': ";
        is.writeList(message, 0);
        message << nl << "Numbers are in SI units, with nothing after them"
            << nl << exit(FatalIOError);
    }
}
