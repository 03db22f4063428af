/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "plateletFlux.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(plateletFlux, 0);
    addToRunTimeSelectionTable(functionObject, plateletFlux, dictionary);
}
}


Foam::functionObjects::plateletFlux::plateletFlux
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, name, dict),
    lastTime_(runTime.value()),
    lastNet_(0)
{
    read(dict);
    const FixedList<scalar, 2> before(passed());
    lastNet_ = before[0] - before[1];
    writeHeading();
}


bool Foam::functionObjects::plateletFlux::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    clayCloud& clay = cloud(dict);
    surface_.reset
    (
        new fluxSurface
        (
            mesh_, dict.subDict("surface"), clay.inletPatches()
        )
    );

    if (surface_->openPatch().empty())
    {
        clay.countThrough(name(), surface_->triangles());
    }
    return true;
}


Foam::clayCloud& Foam::functionObjects::plateletFlux::cloud
(
    const dictionary& dict
) const
{
    if (!mesh_.foundObject<clayCloud>("clay"))
    {
        FatalIOErrorInFunction(dict)
            << "There is no cloud clay: " << type() << ' ' << name()
            << " counts platelets, in a run of clayFoam" << exit(FatalIOError);
    }
    return mesh_.lookupObjectRef<clayCloud>("clay");
}


Foam::FixedList<Foam::scalar, 2>
Foam::functionObjects::plateletFlux::passed() const
{
    const clayCloud& clay = mesh_.lookupObject<clayCloud>("clay");
    const word& patch = surface_->openPatch();

    if (patch.empty())
    {
        const scalarList& counted = clay.passages(name());
        return {counted[0], counted[1]};
    }

    // Through such patches platelets leave; none enters
    return {scalar(clay.state().left.lookup(patch, 0)), scalar(0)};
}


void Foam::functionObjects::plateletFlux::writeHeading()
{
    const clayCloud& clay = mesh_.lookupObject<clayCloud>("clay");

    writeHeader
    (
        file(), "Clay through " + surface_->description() + ", since the start"
    );
    writeHeader
    (
        file(), "Rates are means since the line before (or a restart)"
    );
    writeHeaderValue
    (
        file(), "Platelets of a parcel", clay.parcelNumber()
    );
    writeCommented(file(), "time[s]");
    for
    (
        const char* column
      : {
            "forward[parcels]", "backward[parcels]", "net[parcels]",
            "platelets[-]", "volume[m3]", "mass[kg]",
            "newPlatelets[-]",
            "plateletRate[1/s]", "volumeRate[m3/s]", "massRate[kg/s]"
        }
    )
    {
        writeTabbed(file(), column);
    }
    file() << endl;
}


bool Foam::functionObjects::plateletFlux::write()
{
    const clayCloud& clay = mesh_.lookupObject<clayCloud>("clay");
    const FixedList<scalar, 2> now(passed());

    const scalar net = now[0] - now[1];
    const scalar since = net - lastNet_;
    const scalar duration = time_.value() - lastTime_;
    const scalar rate = duration > 0 ? since/duration : 0;

    Log << type() << ' ' << name() << ": " << since*clay.parcelNumber()
        << " platelets since " << lastTime_ << " s, "
        << net*clay.parcelNumber() << " in all" << endl;

    if (Pstream::master())
    {
        OFstream& os = file();

        os  << time_.value();
        for (const scalar count : {now[0], now[1], net})
        {
            // All digits
            os  << tab << std::to_string(std::int64_t(count)).c_str();
        }
        os  << tab << net*clay.parcelNumber()
            << tab << net*clay.parcelVolume()
            << tab << net*clay.parcelMass()
            << tab << since*clay.parcelNumber()
            << tab << rate*clay.parcelNumber()
            << tab << rate*clay.parcelVolume()
            << tab << rate*clay.parcelMass()
            << endl;
    }
    lastTime_ = time_.value();
    lastNet_ = net;
    return true;
}
