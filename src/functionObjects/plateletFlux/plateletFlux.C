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


Foam::functionObjects::runFunction::requirements
Foam::functionObjects::plateletFlux::needs()
{
    return
    {
        {"surface"},
        "clayFoam",
        {"clay"},
        "platelets are counted as they pass, in each step of the run",
        true
    };
}


Foam::functionObjects::plateletFlux::plateletFlux
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    runFunction(name, runTime, dict, needs()),
    runTable(mesh_, name),
    lastTime_(runTime.value()),
    last_{0, 0, 0}
{
    read(dict);
}


bool Foam::functionObjects::plateletFlux::read(const dictionary& dict)
{
    runFunction::read(dict);
    runTable::read(dict);

    if (idle())
    {
        return true;
    }

    clayCloud& clay = mesh_.lookupObjectRef<clayCloud>("clay");
    const bool first = !surface_.valid();
    const amount before(first ? amount{0, 0, 0} : net());
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

    // What passed through another surface is not since the line before
    const amount now(net());
    if (first || now.number != before.number)
    {
        last_ = now;
    }
    return true;
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


Foam::functionObjects::plateletFlux::amount
Foam::functionObjects::plateletFlux::net() const
{
    const clayCloud& clay = mesh_.lookupObject<clayCloud>("clay");
    const FixedList<scalar, 2> number(passed());
    const word& patch = surface_->openPatch();

    amount result{number[0] - number[1], 0, 0};

    if (patch.empty())
    {
        const scalarList& counted = clay.passages(name());
        result.volume = counted[2] - counted[3];
        result.mass = counted[4] - counted[5];
    }
    else if (clay.state().amountLeft.found(patch))
    {
        const scalarList& left = clay.state().amountLeft[patch];
        result.volume = left[0];
        result.mass = left[1];
    }
    return result;
}


void Foam::functionObjects::plateletFlux::writeHeading(Ostream& os) const
{
    const clayCloud& clay = mesh_.lookupObject<clayCloud>("clay");

    writeHeader
    (
        os, "Clay through " + surface_->description() + ", since the start"
    );
    writeHeader
    (
        os, "Rates are means since the line before (or a restart)"
    );
    writeHeaderValue
    (
        os, "Platelets of a parcel", clay.parcelNumber()
    );
    writeCommented(os, "time[s]");
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
        writeTabbed(os, column);
    }
    os  << nl;
}


bool Foam::functionObjects::plateletFlux::execute()
{
    if (!idle())
    {
        begin();
    }
    return true;
}


bool Foam::functionObjects::plateletFlux::write()
{
    if (idle())
    {
        return true;
    }

    const clayCloud& clay = mesh_.lookupObject<clayCloud>("clay");
    const FixedList<scalar, 2> now(passed());

    const amount all(net());
    const scalar since = (all.number - last_.number)*clay.parcelNumber();
    const scalar duration = time_.value() - lastTime_;
    const auto rate = [&](const scalar change)
    {
        return duration > 0 ? change/duration : 0;
    };

    Log << type() << ' ' << name() << ": " << since
        << " platelets since " << lastTime_ << " s, "
        << all.number*clay.parcelNumber() << " in all" << endl;

    if (Pstream::master())
    {
        Ostream& os = rows();

        writeTime(os);
        for (const scalar count : {now[0], now[1], all.number})
        {
            // All digits
            os  << tab << std::to_string(std::int64_t(count)).c_str();
        }
        os  << tab << all.number*clay.parcelNumber()
            << tab << all.volume
            << tab << all.mass
            << tab << since
            << tab << rate(since)
            << tab << rate(all.volume - last_.volume)
            << tab << rate(all.mass - last_.mass)
            << nl;
    }
    endRows();
    lastTime_ = time_.value();
    last_ = all;
    return true;
}


bool Foam::functionObjects::plateletFlux::end()
{
    return hasNow() || write();
}
