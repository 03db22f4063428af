/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactTimeState.H"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace
{

//- All bits of the number as text; a string, since OpenFOAM's own reader of
//  numbers takes decimal ones only
Foam::string exactly(const Foam::scalar number)
{
    char text[64];
    std::snprintf(text, sizeof(text), "%a", double(number));
    return text;
}


Foam::scalar exactNumber(const Foam::dictionary& dict, const Foam::word& name)
{
    const Foam::string text(dict.get<Foam::string>(name));
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);

    if (end == text.c_str() || *end != '\0' || !std::isfinite(number))
    {
        FatalIOErrorInFunction(dict)
            << name << " \"" << text << "\" is not a number: the restart data"
            << " are damaged. Start from another time, or remove this file to"
            << " go on from OpenFOAM's uniform/time in fewer digits"
            << Foam::exit(Foam::FatalIOError);
    }
    return number;
}

} // End anonymous namespace


void Foam::exactTimeState::write(dictionary& dict) const
{
    dict.add("name", string(name));
    dict.add("value", exactly(value));
    dict.add("deltaT", exactly(deltaT));
    dict.add("deltaT0", exactly(deltaT0));
    dict.add("scheduleStart", exactly(scheduleStart));
    dict.add("writeTimeIndex", writeTimeIndex);
    dict.add("writeControl", writeControl);
    dict.add("writeInterval", exactly(writeInterval));
    dict.add("files", files);
}


Foam::exactTimeState Foam::exactTimeState::read(const dictionary& dict)
{
    exactTimeState state;

    state.name = word(dict.get<string>("name"), false);
    state.value = exactNumber(dict, "value");
    state.deltaT = exactNumber(dict, "deltaT");
    state.deltaT0 = exactNumber(dict, "deltaT0");
    state.scheduleStart = exactNumber(dict, "scheduleStart");
    state.writeTimeIndex = dict.get<label>("writeTimeIndex");
    state.writeControl = dict.get<word>("writeControl");
    state.writeInterval = exactNumber(dict, "writeInterval");
    state.files = filesOf(dict);

    return state;
}


Foam::fileNameList Foam::exactTimeState::filesOf(const dictionary& dict)
{
    return dict.getOrDefault("files", fileNameList());
}
