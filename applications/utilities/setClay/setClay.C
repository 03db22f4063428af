/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    setClay

Description
    Places clay platelets in the mesh as system/setClayDict says: each of its
    sub-dictionaries is a group with an arrangement in a region.

    Writes the cloud `clay`, its state (coarse graining, spacing, number) and
    the cell field clayWeights that decomposePar can balance with. An earlier
    cloud of the same time is replaced. A case with times that a run has written
    is refused; with -overwrite these are removed, once all is placed.
\*---------------------------------------------------------------------------*/

#include "arrangement.H"
#include "caseLock.H"
#include "checkControls.H"
#include "checkWords.H"
#include "clayPlatelet.H"
#include "clayProperties.H"
#include "clayState.H"
#include "clayWeights.H"
#include "Cloud.H"
#include "cloudProperties.H"
#include "completeTimes.H"
#include "countOf.H"
#include "dictionaryText.H"
#include "fvCFD.H"
#include "logDigits.H"
#include "OSspecific.H"
#include "ownFolders.H"
#include "parcelScale.H"
#include "waterLimits.H"
#include "writtenTimes.H"

int main(int argc, char *argv[])
{
    argList::addNote("Place clay platelets as system/setClayDict says");
    argList::noParallel();

    argList::addBoolOption
    (
        "overwrite", "Remove the times that a run has written, and place anew"
    );

    #include "setRootCase.H"
    colloid::dictionaryText::checkCase();
    const caseLock lock(args);
    checkControls(args);

    const writtenTimes ofRuns(args.path());
    if (args.found("overwrite"))
    {
        ofRuns.checkRemovable();
    }
    else
    {
        ofRuns.refuse();
    }

    #include "createTime.H"
    setLogDigits();
    #include "setStart.H"
    #include "createMesh.H"

    const colloid::clayProperties matter(runTime);
    const cloudProperties properties(runTime);
    const periodicAxes axes(waterLimits::withCells(mesh));

    const IOdictionary setClayDict
    (
        IOobject
        (
            "setClayDict",
            runTime.system(),
            runTime,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    );
    const scalar coarseGraining =
        parcelScale(mesh, axes, matter, properties, setClayDict);

    const arrangement::scene scene
    {
        mesh, axes, pow3(coarseGraining)*matter.clay().volume()
    };
    Random random(setClayDict.getOrDefault<label>("seed", 1));

    Cloud<clayPlatelet> cloud(mesh, "clay", IDLList<clayPlatelet>());
    scalar smallestSpacing = GREAT;
    bool anyGroup = false;
    const word counted(coarseGraining == 1 ? "platelets" : "parcels");

    Info<< nl;
    if (coarseGraining == 1)
    {
        Info<< "Platelets";
    }
    else
    {
        Info<< "Parcels of " << pow3(coarseGraining) << " platelets";
    }
    Info<< ", " << scene.parcelVolume << " m3 of clay each" << nl;

    for (const entry& group : setClayDict)
    {
        if (group.keyword() == colloid::variablesWord)
        {
            continue;
        }
        if (!group.isDict())
        {
            colloid::checkChoice
            (
                setClayDict,
                group.keyword(),
                group.keyword(),
                wordList({"seed", "featureSize"})
            );
            continue;
        }

        anyGroup = true;

        autoPtr<arrangement> way(arrangement::New(group.dict(), scene));
        const pointField places(way->place(random));
        const bool fixed = group.dict().getOrDefault("fixed", false);

        for (const point& x : places)
        {
            clayPlatelet::properties what;
            what.x = x;
            what.id = cloud.size();
            what.fixed = fixed;
            cloud.addParticle
            (
                new clayPlatelet(mesh, x, mesh.findCell(x), what)
            );
        }

        Info<< "    " << group.keyword() << ": " << places.size()
            << (fixed ? " fixed " : " ") << counted << ", spacing "
            << way->spacing() << " m, solid fraction "
            << scene.parcelVolume/pow3(way->spacing()) << nl;

        if (places.size())
        {
            smallestSpacing = min(smallestSpacing, way->spacing());
        }
        else
        {
            WarningInFunction
                << "The group " << group.keyword() << " placed nothing: none of"
                << " its places is in its region of the mesh" << nl << endl;
        }
    }

    const scalar filled =
        cloud.size()*scene.parcelVolume/sum(mesh.V()).value();
    if (filled >= 1)
    {
        FatalIOErrorInFunction(setClayDict)
            << "All groups together, " << cloud.size() << ' ' << counted
            << " of " << scene.parcelVolume << " m3, would fill " << filled
            << " of the mesh." << nl
            << "    A solid fraction lies between 0 and 1. Is the mesh in metres?"
            << exit(FatalIOError);
    }

    const scalar inletFraction = properties.largestInletFraction();
    if (inletFraction > 0)
    {
        smallestSpacing =
            min(smallestSpacing, Foam::cbrt(scene.parcelVolume/inletFraction));
    }
    else if (cloud.size() == 0)
    {
        smallestSpacing = Foam::cbrt(sum(mesh.V()).value());
    }

    if (cloud.size() == 0)
    {
        OStringStream reason;
        reason
            << (anyGroup ? "No place" : "No group") << " in "
            << runTime.relativePath(setClayDict.objectPath())
            << ": the water stays empty";

        if (inletFraction > 0)
        {
            Info<< reason.str().c_str() << " until clay enters through inlets"
                << nl;
        }
        else
        {
            WarningInFunction
                << reason.str().c_str() << ", and no inlet"
                << " (constant/clayCloudProperties) brings clay" << nl << endl;
        }
    }

    // Only now that nothing is refused any more
    ofRuns.remove();

    // A 0 that is a link to another case's
    if (!ownFolders::make(runTime.timePath()))
    {
        FatalErrorInFunction
            << runTime.timePath() << " has a folder that is a link, and it could"
            << " not be made a folder of this case" << exit(FatalError);
    }

    // An empty cloud writes no files: those of an earlier one would stay
    const fileName cloudPath(runTime.timePath()/cloud::prefix/cloud.name());
    if (isDir(cloudPath))
    {
        rmDir(cloudPath);
    }

    clayState state(mesh, coarseGraining, smallestSpacing, cloud.size());
    state.identifyPlaced(cloud, matter.clay());

    if
    (
        !cloud.write()
     || !state.regIOobject::write()
     || !writeClayWeights(mesh, cloud)
    )
    {
        FatalErrorInFunction
            << "Cannot write to " << runTime.timePath() << exit(FatalError);
    }

    Info<< "\nWrote " << cloud.size() << ' ' << counted;
    if (coarseGraining != 1)
    {
        Info<< ", "
            << colloid::inDigits
               (
                   std::round(pow3(coarseGraining)*cloud.size())
               ).c_str()
            << " platelets,";
    }
    Info<< " to "
        << runTime.timeName()/cloud::prefix/cloud.name() << nl << "\nEnd\n" << endl;

    return 0;
}
