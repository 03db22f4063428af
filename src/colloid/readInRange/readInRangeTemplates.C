/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readInRange.H"

template<class Type>
Foam::autoPtr<Foam::Function1<Type>> Foam::colloid::readFunction1
(
    const dictionary& dict,
    const word& keyword
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
            static_cast<void>(pTraits<Type>{is});
            checkAllRead(dict, keyword, is);
        }
    }

    return Function1<Type>::New(keyword, dict);
}
