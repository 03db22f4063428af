/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "filterProperties.H"

#include "ITstream.H"
#include "checkWords.H"
#include "readInRange.H"
#include "wordList.H"

Foam::filterProperties::filterProperties(const dictionary& dict)
{
    colloid::checkWords(dict, wordList({"kernel", "length", "timeScale"}));

    dict.readIfPresent("kernel", kernel);
    colloid::checkChoice(dict, "kernel", kernel, wordList({"cubic"}));

    if (const entry* lengthEntry = dict.findEntry("length", keyType::LITERAL))
    {
        const token first(lengthEntry->stream());

        if (first.isWord())
        {
            colloid::checkChoice
            (
                dict,
                "length",
                first.wordToken(),
                wordList({"auto"})
            );
        }
        else
        {
            lengthIsAuto = false;
            length = colloid::readInRange(dict, "length", VSMALL, GREAT, "m");
        }
    }

    timeScale = colloid::readInRange(dict, "timeScale", 0, 0, GREAT, "s");
}
