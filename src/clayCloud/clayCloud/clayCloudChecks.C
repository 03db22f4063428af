/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What a cloud refuses, or warns of, in a case and in its own doings.
\*---------------------------------------------------------------------------*/

#include "clayCloud.H"

#include "fvMesh.H"
#include "meshIdentity.H"
#include "Pstream.H"

#include <algorithm>

namespace
{

using namespace Foam;

//- Ids that are listed in a message
constexpr label mostListed = 20;


void list(OSstream& os, const char* which, const labelUList& ids)
{
    if (ids.size())
    {
        os  << nl << "    " << which << " ids: "
            << flatOutput
               (
                   labelList
                   (
                       SubList<label>(ids, min(ids.size(), mostListed))
                   )
               );
        if (ids.size() > mostListed)
        {
            os  << " and " << ids.size() - mostListed << " more";
        }
    }
}


//- At a start: FatalError unless each id below state.entered is there once, or has
//  left. Collective
void checkIds(const clayCloud& cloud, const clayState& state)
{
    labelList own(cloud.size());
    label i = 0;
    for (const clayPlatelet& platelet : cloud)
    {
        own[i++] = platelet.state().id;
    }
    List<labelList> ofRanks(Pstream::nProcs());
    ofRanks[Pstream::myProcNo()] = std::move(own);
    Pstream::gatherList(ofRanks);
    if (!Pstream::master())
    {
        return;
    }

    DynamicList<label> ids;
    for (const labelList& some : ofRanks)
    {
        ids.append(some);
    }
    std::sort(ids.begin(), ids.end());

    DynamicList<label> doubled;
    DynamicList<label> unknown;
    DynamicList<label> absent;
    label next = 0;
    bool onEveryRank = Pstream::parRun() && ids.size();
    for (auto id = ids.begin(); id != ids.end(); )
    {
        const auto after = std::upper_bound(id, ids.end(), *id);
        if (after - id > 1)
        {
            doubled.append(*id);
        }
        onEveryRank = onEveryRank && after - id == Pstream::nProcs();
        if (*id < 0 || *id >= state.entered)
        {
            unknown.append(*id);
        }
        else
        {
            for (; next < *id; ++next)
            {
                absent.append(next);
            }
            next = *id + 1;
        }
        id = after;
    }
    for (; next < state.entered; ++next)
    {
        absent.append(next);
    }

    if
    (
        doubled.empty()
     && unknown.empty()
     && absent.size() == state.allLeft()
    )
    {
        return;
    }

    const word time(cloud.pMesh().time().timeName());
    FatalErrorInFunction
        << "Platelets do not add up: " << state.entered << " entered, "
        << ids.size() << " are inside and " << state.allLeft() << " left.";
    if (onEveryRank)
    {
        FatalError
            << nl << "    Each is on every one of the " << Pstream::nProcs()
            << " processors: time " << time << " was copied to processor*," << nl
            << "    not decomposed. Remove it there, and say   decomposePar -time "
            << time << " -force" << exit(FatalError);
    }
    list(FatalError, "Doubled", doubled);
    list(FatalError, "Unknown", unknown);
    list
    (
        FatalError,
        state.allLeft() ? "Missing (or those that left:)" : "Missing",
        absent
    );
    FatalError
        << nl << "    A file of " << time << "/lagrangian/clay is missing, or of"
        << " another run: start from an earlier time, or place" << nl
        << "    the clay anew with setClay (and decompose the case after that)"
        << exit(FatalError);
}


//- Whether the cell, its face and that one's point, which give a particle's place,
//  belong together in this mesh
bool hasPlace(const polyMesh& mesh, const particle& p)
{
    const label facei = p.tetFace();

    return
        p.cell() >= 0 && p.cell() < mesh.nCells()
     && facei >= 0 && facei < mesh.nFaces()
     && p.tetPt() > 0 && p.tetPt() < mesh.faces()[facei].size() - 1
     && (
            mesh.faceOwner()[facei] == p.cell()
         || (
                mesh.isInternalFace(facei)
             && mesh.faceNeighbour()[facei] == p.cell()
            )
        );
}

} // End anonymous namespace


void Foam::clayCloud::checkState() const
{
    const scalar asked = properties_.coarseGraining();

    if (asked > 0 && mag(asked - state_.coarseGraining) > SMALL*asked)
    {
        FatalIOErrorInFunction(properties_.dict())
            << "coarseGraining is " << asked << " here, but setClay placed"
            << " the clay with " << state_.coarseGraining << " ("
            << state_.objectPath() << ")." << nl
            << "    Run setClay again or put " << state_.coarseGraining
            << " here" << exit(FatalIOError);
    }
}


void Foam::clayCloud::checkPlaces() const
{
    const polyMesh& mesh = mesh_;

    // Digits of x, of the mesh's points and of the weights between these
    const vector off
    (
        4*meshIdentity(mesh).roundOffOfPlaces()
      + lagAtWalls*state_.spacing*vector::one
    );

    label elsewhere = 0;
    for (const clayPlatelet& platelet : *this)
    {
        if (!hasPlace(mesh, platelet))
        {
            ++elsewhere;
            continue;
        }
        const vector lag
        (
            axes_.nearestImage
            (
                tracked(platelet.state()) - platelet.position()
            )
        );
        elsewhere +=
            mag(lag.x()) > off.x() || mag(lag.y()) > off.y()
         || mag(lag.z()) > off.z();
    }
    reduce(elsewhere, sumOp<label>());

    if (elsewhere)
    {
        FatalErrorInFunction
            << "The mesh is not that of the clay: " << elsewhere << " of "
            << number() << " platelets of time " << mesh_.time().timeName()
            << " are not in the cells that they are said to be in." << nl
            << "    Was it renumbered (renumberMesh) or changed after setClay,"
            << " or after this time was written?" << nl
            << "    Place the clay anew with setClay in this mesh, or bring back"
            << " the mesh of before"
            << (Pstream::parRun() ? "; then decomposePar -force" : "")
            << exit(FatalError);
    }
}


void Foam::clayCloud::checkFilterLength() const
{
    const scalar length = interactions_.filterLength();
    const bool given = properties_.filterLength() > 0;

    // How far a kernel sees nothing twice, along the widest and the narrowest
    // axis of the mesh
    scalar widest = 0;
    scalar narrowest = GREAT;
    for (direction axis = 0; axis < 3; ++axis)
    {
        const scalar extent =
            axes_.periodic(axis)
          ? 0.5*axes_.period(axis) : axes_.upper(axis) - axes_.lower(axis);
        widest = max(widest, extent);
        narrowest = min(narrowest, extent);
    }

    // Without clay there is no spacing. What setClay wrote has fewer digits
    const bool anyClay = state_.entered > 0 || inlets_.size();

    if (given && anyClay && length < (1 - 1e-6)*state_.spacing)
    {
        FatalIOErrorInFunction(properties_.dict().subDict("filter"))
            << "The filter length of " << length << " m is less than the mean"
            << " spacing of " << state_.spacing << " m:" << nl
            << "    alpha.clay would show single platelets. Take auto, "
            << 3*state_.spacing << " m, or at least the spacing"
            << exit(FatalIOError);
    }
    if (given && length > widest)
    {
        FatalIOErrorInFunction(properties_.dict().subDict("filter"))
            << "The filter length of " << length << " m is larger than the mesh"
            << " (or half of a period of it), " << widest << " m along its"
            << " longest axis:" << nl
            << "    alpha.clay would be the same everywhere. Take at most "
            << widest << " m, or auto, " << 3*state_.spacing << " m"
            << exit(FatalIOError);
    }
    if (length > widest || (given && length > narrowest))
    {
        WarningInFunction
            << "The filter length of " << length << " m is larger than the mesh"
            << " (or half of a period of it), " << narrowest << " m along its"
            << " shortest axis:" << nl
            << "    alpha.clay is a mean across it" << nl << endl;
    }

    const scalar widestCell = Foam::cbrt(gMax(mesh_.V().field()));

    if (length < widestCell)
    {
        WarningInFunction
            << "The filter length of " << length
            << " m is less than the width of the largest cells, " << widestCell
            << " m:" << nl << "    there each platelet counts in its own cell"
            << " alone, and alpha.clay is coarse." << nl
            << "    Smaller cells, or a larger filter length"
            << " (clayCloudProperties)" << nl << endl;
    }
}


void Foam::clayCloud::checkFraction()
{
    const scalar most = gMax(alpha_.primitiveField());

    if (most > 1 && !crowded_)
    {
        crowded_ = true;
        WarningInFunction
            << "alpha.clay reaches " << most << ", more clay than room; where"
            << " friction follows it, it counts as 0.99 there." << nl
            << "    Larger cells, a larger filter length (clayCloudProperties)"
            << " or fewer platelets (setClayDict)" << nl << endl;
    }
}


void Foam::clayCloud::checkCount(const labelUList& idsBefore) const
{
    // Before the first step there is no engine yet
    if (!engine_)
    {
        checkIds(*this, state_);
        return;
    }

    const label inside = number();

    if (inside + state_.allLeft() == state_.entered)
    {
        return;
    }

    // All ids before the step, less those that left and those that are inside
    List<labelList> before(Pstream::nProcs());
    List<labelList> after(Pstream::nProcs());
    before[Pstream::myProcNo()] = idsBefore;

    DynamicList<label> accounted(size());
    for (const clayPlatelet& platelet : *this)
    {
        accounted.append(platelet.state().id);
    }
    for (const plateletDynamics::departure& gone : engine_->departures())
    {
        accounted.append(gone.id);
    }
    after[Pstream::myProcNo()] = accounted;
    Pstream::gatherList(before);
    Pstream::gatherList(after);

    labelHashSet missing;
    for (const labelList& ids : before)
    {
        missing.insert(ids);
    }
    for (const labelList& ids : after)
    {
        missing.unset(ids);
    }

    FatalErrorInFunction
        << "Platelets do not add up: " << state_.entered << " entered, "
        << inside << " are inside and " << state_.allLeft() << " left." << nl
        << "    Missing ids: " << missing.sortedToc() << exit(FatalError);
}
