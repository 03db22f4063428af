/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayState.H"
#include "clayProperties.H"
#include "polyMesh.H"
#include "Time.H"

namespace
{

Foam::IOobject stateObject
(
    const Foam::polyMesh& mesh,
    const Foam::IOobject::readOption read
)
{
    const Foam::fileName file(Foam::clayState::file());

    return Foam::IOobject
    (
        file.name(),
        mesh.time().timeName(),
        file.path(),
        mesh.time(),
        read,
        Foam::IOobject::AUTO_WRITE
    );
}

//- As text in files of any format, like other entries
void writeNumbers
(
    Foam::Ostream& os,
    const Foam::word& keyword,
    const Foam::scalarList& numbers
)
{
    os.writeKeyword(keyword) << Foam::token::BEGIN_LIST;
    for (const Foam::scalar number : numbers)
    {
        os << Foam::token::SPACE << number;
    }
    os << Foam::token::SPACE << Foam::token::END_LIST;
    os.endEntry();
}

//- A dictionary of lists, each under its name; nothing where there are none
void writeLists
(
    Foam::Ostream& os,
    const Foam::word& keyword,
    const Foam::HashTable<Foam::scalarList>& lists
)
{
    if (lists.empty())
    {
        return;
    }
    os.beginBlock(keyword);
    for (const Foam::word& name : lists.sortedToc())
    {
        writeNumbers(os, name, lists[name]);
    }
    os.endBlock();
}


void readLists
(
    const Foam::dictionary& dict,
    const Foam::word& keyword,
    Foam::HashTable<Foam::scalarList>& lists
)
{
    for (const Foam::entry& list : dict.subOrEmptyDict(keyword))
    {
        lists.set(list.keyword(), Foam::scalarList(list.stream()));
    }
}

} // End anonymous namespace


Foam::fileName Foam::clayState::file()
{
    return "uniform"/cloud::prefix/"clay"/"clayState";
}


Foam::clayState::clayState
(
    const polyMesh& mesh,
    const colloid::clayProperties& matter
)
:
    IOdictionary(stateObject(mesh, IOobject::READ_IF_PRESENT))
{
    if (!headerOk())
    {
        FatalErrorInFunction
            << "No clay at time " << mesh.time().timeName() << " (no file "
            << objectPath() << ")." << nl
            << "    Place it with setClay (and decompose the case after that),"
            << " or start from a time that was written";

        // In parallel, times of the undecomposed case, and the other way round
        const fileName otherPath
        (
            mesh.time().processorCase()
          ? mesh.time().globalPath()
          : mesh.time().path()/"processor0"
        );
        const instantList others(Time::findTimes(otherPath));

        if (others.size() && others.last().value() > mesh.time().value())
        {
            FatalError<< nl
                << "    (" << otherPath << " has results up to "
                << others.last().name() << ": "
                << (
                       mesh.time().processorCase()
                     ? "decomposePar -latestTime -force"
                     : "reconstructPar, or run in parallel,"
                   )
                << " to go on from there)";
        }
        FatalError<< exit(FatalError);
    }

    readEntry("coarseGraining", coarseGraining);
    readEntry("placedAt", placedAt);
    readEntry("spacing", spacing);
    readEntry("entered", entered);
    readEntry("left", left);
    readEntry("placedFraction", placedFraction);
    readEntry("decidedAt", decidedAt);
    readEntry("decidedSpacing", decidedSpacing);
    readEntry("decidedSpeed", decidedSpeed);
    readIfPresent("integrator", integrator);
    readIfPresent("skinUse", skinUse);
    readIfPresent("integratorMemory", integratorMemory);
    readIfPresent("timeUnit", timeUnit);
    readEntry("through", through);
    readLists(*this, "inlets", inlets);
    readLists(*this, "amountLeft", amountLeft);
    readLists(*this, "passages", passages);
    readLists(*this, "surfaces", surfaces);

    if (found("identity"))
    {
        identity_.reset(new clayIdentity(objectPath(), subDict("identity")));
        identity_->checkMatter(matter);
        identity_->checkMesh(mesh);
        identity_->checkPlacing(mesh.time());
    }
    else
    {
        Info<< "Not checked whether clay and mesh are those that were placed: "
            << objectPath() << " is of a version that did not keep what they"
            << " were" << nl << endl;
    }

    completeAmounts
    (
        pow3(coarseGraining)*matter.clay().volume(), matter.clay().density
    );
}


Foam::clayState::clayState
(
    const polyMesh& mesh,
    const scalar scale,
    const scalar meanSpacing,
    const label number
)
:
    IOdictionary(stateObject(mesh, IOobject::NO_READ)),
    coarseGraining(scale),
    placedAt(mesh.time().value()),
    spacing(meanSpacing),
    decidedAt(placedAt),
    decidedSpacing(meanSpacing),
    entered(number)
{}


void Foam::clayState::identifyPlaced
(
    const Cloud<clayPlatelet>& cloud,
    const colloid::platelet& matter
)
{
    // As it will be read, whatever digits files have
    const int digits =
        time().writeFormat() == IOstream::ASCII
      ? int(IOstream::defaultPrecision()) : 0;

    cloud_ = &cloud;
    identity_.reset
    (
        new clayIdentity
        (
            cloud.pMesh(), matter, cloudSum(cloud, digits)
        )
    );
    identity_->placedNow(time().timeName());
}


void Foam::clayState::identify
(
    const Cloud<clayPlatelet>& cloud,
    const colloid::platelet& matter
)
{
    const cloudSum now(cloud);

    if (identity_.valid())
    {
        identity_->checkPlatelets(time(), now);
    }
    else
    {
        identity_.reset(new clayIdentity(cloud.pMesh(), matter, now));
    }
    cloud_ = &cloud;
}


void Foam::clayState::completeAmounts
(
    const scalar volume,
    const scalar density
)
{
    forAllConstIters(left, iter)
    {
        if (!amountLeft.found(iter.key()))
        {
            const scalar all = iter.val()*volume;
            amountLeft.set(iter.key(), scalarList({all, all*density}));
        }
    }
    forAllIters(passages, iter)
    {
        scalarList& passed = iter.val();
        if (passed.size() == 2)
        {
            const scalar forward = passed[0]*volume;
            const scalar backward = passed[1]*volume;
            passed.append
            (
                scalarList
                ({
                    forward, backward, forward*density, backward*density
                })
            );
        }
    }
}


Foam::label Foam::clayState::allLeft() const
{
    label sum = 0;
    forAllConstIters(left, iter)
    {
        sum += iter.val();
    }
    return sum;
}


bool Foam::clayState::writeData(Ostream& os) const
{
    // 17 digits bring a double back bit for bit
    const int precision = os.precision(17);

    os.writeEntry("coarseGraining", coarseGraining);
    os.writeEntry("placedAt", placedAt);
    os.writeEntry("spacing", spacing);
    os.writeEntry("placedFraction", placedFraction);
    os.writeEntry("decidedAt", decidedAt);
    os.writeEntry("decidedSpacing", decidedSpacing);
    os.writeEntry("decidedSpeed", decidedSpeed);
    os.writeEntry("entered", entered);
    os.writeEntry("left", left);
    os.writeEntry("skinUse", skinUse);
    if (integrator.size())
    {
        os.writeEntry("integrator", integrator);
    }
    if (integratorMemory.size())
    {
        writeNumbers(os, "integratorMemory", integratorMemory);
    }
    os.writeEntry("timeUnit", timeUnit);
    os.writeEntry("through", through);
    writeLists(os, "inlets", inlets);
    writeLists(os, "amountLeft", amountLeft);
    writeLists(os, "passages", passages);
    writeLists(os, "surfaces", surfaces);

    if (cloud_)
    {
        // Of the places as they are when the time is written, whoever asks for
        // that, and as they will be read
        clayIdentity now(*identity_);
        now.goOn
        (
            cloudSum
            (
                *cloud_, os.format() == IOstream::ASCII ? precision : 0
            )
        );
        now.write(os);
    }

    os.precision(precision);
    return os.good();
}
