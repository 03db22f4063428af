/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readInRange.H"
#include "caseFile.H"
#include "unitWords.H"

#include "Constant.H"
#include "StringStream.H"

template<class Type>
Type Foam::colloid::readWithUnit
(
    const dictionary& dict,
    const word& keyword,
    ITstream& is,
    const char* SIunit
)
{
    const Type value = pTraits<Type>{is};
    const unitWord unit(readUnit(dict, keyword, is, SIunit));
    const Type converted = value*unit.factor;

    OStringStream shown, shownConverted;
    shown << value;
    shownConverted << converted;
    echoUnit(dict, keyword, shown.str(), unit, shownConverted.str(), SIunit);

    return converted;
}


template<class Type>
Foam::autoPtr<Foam::Function1<Type>> Foam::colloid::readFunction1
(
    const dictionary& dict,
    const word& keyword,
    const char* unit
)
{
    const entry* given = dict.findEntry(keyword, keyType::LITERAL);

    if (given && given->isStream())
    {
        ITstream& is = given->stream();
        const token first(is);
        const bool isConstant =
            first.isWord() && first.wordToken() == "constant";

        if (isConstant || !first.isWord())
        {
            if (!isConstant)
            {
                is.putBack(first);
            }
            return autoPtr<Function1<Type>>
            (
                new Function1Types::Constant<Type>
                (
                    keyword, readWithUnit<Type>(dict, keyword, is, unit)
                )
            );
        }
    }

    return Function1<Type>::New(keyword, withCaseFiles(dict, keyword));
}
