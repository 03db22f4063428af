/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayIdentity.H"
#include "clayProperties.H"
#include "clayState.H"
#include "IFstream.H"
#include "ofAllRanks.H"
#include "OSspecific.H"
#include "polyMesh.H"
#include "Time.H"

namespace
{

using namespace Foam;

//- Other decimal digits of the same number differ by less
constexpr scalar sameNumber = 1e-9;

const char* const placeAnew = "place the clay anew with setClay";

//- How a decomposed case gets the clay of the undecomposed one, or back
const char* bringHere(const bool decomposed)
{
    return decomposed ? "decomposePar -force" : "reconstructPar";
}

} // End anonymous namespace


Foam::clayIdentity::clayIdentity
(
    const polyMesh& mesh,
    const colloid::platelet& matter,
    const cloudSum& platelets
)
:
    matter_(matter),
    mesh_(mesh),
    platelets_(platelets)
{}


Foam::clayIdentity::clayIdentity(const fileName& path, const dictionary& dict)
:
    path_(path),
    mesh_(dict.subDict("mesh")),
    platelets_(dict.subDict("platelets")),
    placedIn_(dict.get<string>("placedIn")),
    placed_(dict.get<string>("placed"))
{
    const dictionary& platelet = dict.subDict("platelet");
    platelet.readEntry("diameter", matter_.diameter);
    platelet.readEntry("thickness", matter_.thickness);
    platelet.readEntry("density", matter_.density);
}


void Foam::clayIdentity::placedNow(const word& timeName)
{
    placedIn_ = timeName;
    placed_ = platelets_.checksum();
}


void Foam::clayIdentity::checkMatter
(
    const colloid::clayProperties& properties
) const
{
    const colloid::platelet& now = properties.clay();

    const auto check =
    [&](
        const char* name,
        const scalar here,
        const scalar was,
        const char* unit
    )
    {
        if (mag(here - was) > sameNumber*was)
        {
            FatalIOErrorInFunction(properties.dict().subDict("platelet"))
                << name << " is " << here << ' ' << unit << " here, but " << was
                << ' ' << unit << " of the clay there is (" << path_ << "):"
                << nl << "    a platelet's volume would be "
                << now.volume()/matter_.volume() << ", its mass "
                << now.mass()/matter_.mass() << " times what it was." << nl
                << "    Put " << was << " back here, or " << placeAnew
                << exit(FatalIOError);
        }
    };
    check("diameter", now.diameter, matter_.diameter, "m");
    check("thickness", now.thickness, matter_.thickness, "m");
    check("density", now.density, matter_.density, "kg/m3");
}


void Foam::clayIdentity::checkMesh(const polyMesh& mesh) const
{
    const string other(mesh_.difference(meshIdentity(mesh)));

    if (!other.empty())
    {
        FatalErrorInFunction
            << "The mesh is not that of the clay (" << path_ << "):" << nl
            << "    " << other.c_str() << "." << nl
            << "    Make that mesh again, or " << placeAnew << " in this one"
            << exit(FatalError);
    }
}


void Foam::clayIdentity::checkPlatelets
(
    const Time& time,
    const cloudSum& platelets
) const
{
    const cloudSum::match match = platelets_.compare(platelets);

    if (match == cloudSum::match::fewerDigits)
    {
        Info<< "The platelets of time " << time.timeName()
            << " have other digits than when they were first written, as by"
            << " another writePrecision;" << nl
            << "    they are the same to " << meshIdentity::roundOff() << nl
            << endl;
    }
    else if (match == cloudSum::match::none)
    {
        const bool decomposed = Pstream::parRun();

        FatalErrorInFunction
            << "The platelets of time " << time.timeName() << " are not those"
            << " that its clayState (" << path_ << ") is of:" << nl
            << "    their ids and places are others, left from before "
            << (decomposed ? "setClay or decomposePar" : "setClay")
            << " was last used, or changed since." << nl
            << "    " << bringHere(decomposed)
            << " brings those of the "
            << (decomposed ? "undecomposed" : "decomposed") << " case, or "
            << placeAnew << exit(FatalError);
    }
}


void Foam::clayIdentity::checkPlacing(const Time& time) const
{
    // One rank looks: others may not see the undecomposed case
    string placed;
    const fileName path
    (
        time.globalPath()/fileName(placedIn_)/clayState::file()
    );
    if (Pstream::master() && !placed_.empty() && isFile(path))
    {
        IFstream file(path);
        const dictionary state(file);
        const dictionary* identity = state.findDict("identity");

        if (identity)
        {
            identity->readIfPresent("placed", placed);
        }
    }
    placed = ofAllRanks<string>(placed)[0];

    if (!placed.empty() && placed != placed_)
    {
        const bool decomposed = Pstream::parRun();

        FatalErrorInFunction
            << "The clay of time " << time.timeName() << " (" << path_ << ")"
            << nl << "    was placed by another setClay than that of "
            << path << "." << nl << "    To start from the latter: "
            << (
                   decomposed
                 ? "remove processor*, and decomposePar"
                 : "remove the times after it"
               )
            << ". To go on with the former: remove the latter"
            << exit(FatalError);
    }
}


void Foam::clayIdentity::write(Ostream& os) const
{
    os.beginBlock("identity");
    os.beginBlock("platelet");
    os.writeEntry("diameter", matter_.diameter);
    os.writeEntry("thickness", matter_.thickness);
    os.writeEntry("density", matter_.density);
    os.endBlock();
    os.beginBlock("mesh");
    mesh_.write(os);
    os.endBlock();
    os.beginBlock("platelets");
    platelets_.write(os);
    os.endBlock();
    os.writeEntry("placedIn", placedIn_);
    os.writeEntry("placed", placed_);
    os.endBlock();
}
