/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "h5Trajectory.H"

#include "OSspecific.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "clayCloud.H"
#include "periodicAxes.H"
#include "readInRange.H"
#include "timeControl.H"
#include "xdmfSidecar.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(h5Trajectory, 0);
    addToRunTimeSelectionTable(functionObject, h5Trajectory, dictionary);
}
}

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

wordList readFields(const dictionary& dict)
{
    const wordList& valid = h5mdFile::validFields();
    const wordList asked(dict.getOrDefault<wordList>("fields", valid));

    for (const word& field : asked)
    {
        colloid::checkChoice(dict, "fields", field, valid);
    }
    if (!asked.found("position"))
    {
        FatalIOErrorInFunction(dict)
            << "fields are " << flatOutput(asked) << "; position must be one"
            << " of them" << exit(FatalIOError);
    }

    // Each one once, in one order
    wordList fields;
    for (const word& field : valid)
    {
        if (asked.found(field))
        {
            fields.append(field);
        }
    }
    return fields;
}


const vector& valueOf(const clayPlatelet& platelet, const word& field)
{
    const clayPlatelet::properties& state = platelet.state();

    return
        field == "position" ? state.x
      : field == "velocity" ? state.U
      : state.F;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

Foam::rowsById Foam::functionObjects::h5Trajectory::rows() const
{
    const auto& cloud = lookupObject<Cloud<clayPlatelet>>("clay");

    labelList ids(cloud.size());
    List<vectorField> columns(fields_.size(), vectorField(cloud.size()));

    // Those in the layers of inlets are outside the mesh
    label row = 0;
    for (const clayPlatelet& platelet : cloud)
    {
        if (!platelet.inWater())
        {
            continue;
        }
        ids[row] = platelet.state().id;
        forAll(fields_, i)
        {
            columns[i][row] = valueOf(platelet, fields_[i]);
        }
        ++row;
    }
    ids.setSize(row);
    for (vectorField& column : columns)
    {
        column.setSize(row);
    }
    return rowsById(ids, columns);
}


Foam::string Foam::functionObjects::h5Trajectory::problemOfMaster
(
    const std::function<void()>& action
) const
{
    string problem;
    if (Pstream::master())
    {
        try
        {
            action();
        }
        catch (const std::exception& error)
        {
            problem = error.what();
        }
    }
    Pstream::scatter(problem);
    return problem;
}


void Foam::functionObjects::h5Trajectory::begin
(
    const dictionary& dict,
    const label compression
)
{
    const label number = returnReduce
    (
        lookupObject<Cloud<clayPlatelet>>("clay").size(), sumOp<label>()
    );
    const string problem = problemOfMaster
    (
        [&]{ beginAlone(number, compression); }
    );
    if (!problem.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The trajectory can't go into " << file_->path() << ": "
            << problem.c_str() << nl
            << "    Remove it, move it away, or choose another name (file)"
            << exit(FatalIOError);
    }
    frames_ = written_.times.size();
    Pstream::scatter(frames_);
}


void Foam::functionObjects::h5Trajectory::beginAlone
(
    const label number,
    const label compression
)
{
    const fileName& path = file_->path();
    const bool isThere = exists(path);

    // Also where it is to be made anew: it may be someone else's
    written_ = isThere ? file_->read() : h5mdFile::contents();

    if (!isThere || time_.timeIndex() == 0)
    {
        file_->create(number, compression);
        written_ = h5mdFile::contents();
    }
    else
    {
        if (written_.fields != fields_)
        {
            OStringStream reason;
            reason
                << "it has the fields " << flatOutput(written_.fields)
                << ", this run would write " << flatOutput(fields_);
            throw std::runtime_error(reason.str());
        }

        const scalar last = time_.value() + 0.1*time_.deltaTValue();
        label frames = 0;
        while
        (
            frames < written_.times.size() && written_.times[frames] <= last
        )
        {
            ++frames;
        }

        file_->cut(written_, frames);
        written_.times.setSize(frames);
        written_.rows.setSize(frames);
    }

    xdmfSidecar::write(path, fields_, written_.times, written_.rows);
}


bool Foam::functionObjects::h5Trajectory::isMissing
(
    const dictionary& dict
) const
{
    using control = Foam::timeControl;

    scalar last = -GREAT;
    if (frames_ && Pstream::master())
    {
        last = written_.times.last();
    }
    reduce(last, maxOp<scalar>());

    const scalar halfStep = 0.5*time_.deltaTValue();
    if (last > time_.value() - halfStep || time_.timeIndex() == 0)
    {
        return false;
    }

    control due(time_, dict, "write");
    switch (due.control())
    {
        case control::ocAlways:
        case control::ocTimeStep:
            return due.execute();

        case control::ocWriteTime:
            // Time starts from times that were written
            return due.interval() <= 1;

        case control::ocRunTime:
        case control::ocAdjustableRunTime:
            return frames_ && last + due.interval() < time_.value() + halfStep;

        default:
            return false;
    }
}


void Foam::functionObjects::h5Trajectory::refuse(const string& problem) const
{
    // Not FatalError, which OpenFOAM takes for a warning in constructors
    FatalIOErrorInFunction(time_.controlDict())
        << "The trajectory " << file_->path()
        << " could not be written at time " << time_.timeName() << ": " << problem.c_str() << nl
        << "Is the disk full, or a quota or file-size limit reached?" << nl
        << "It keeps the " << frames_ << " frames that it had; a restart goes"
        << " on from the last complete time directory." << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

Foam::functionObjects::h5Trajectory::h5Trajectory
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    runFunction
    (
        name,
        runTime,
        dict,
        {
            {"file", "fields", "compression"},
            "clayFoam",
            {"clay"},
            "the trajectory is that of the run's steps",
            false
        }
    )
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::h5Trajectory::read(const dictionary& dict)
{
    runFunction::read(dict);

    if (idle())
    {
        return true;
    }

    fileName path(dict.getOrDefault<fileName>("file", "clay.h5"));
    if (!path.hasExt("h5") || path.nameLessExt().empty())
    {
        FatalIOErrorInFunction(dict)
            << "file is " << path << "; its name should end with .h5"
            << exit(FatalIOError);
    }
    if (!path.isAbsolute())
    {
        path = time_.globalPath()/path;
    }

    fields_ = readFields(dict);
    file_ = std::make_unique<h5mdFile>(path, fields_, periodicAxes(mesh_));
    begin
    (
        dict,
        label(colloid::readInRange(dict, "compression", 1, 0, 9, "(-)"))
    );
    if (isMissing(dict))
    {
        write();
    }
    return true;
}


bool Foam::functionObjects::h5Trajectory::write()
{
    if (idle())
    {
        return true;
    }

    const rowsById now(rows());

    const string noRoom = problemOfMaster([&]{ file_->reserve(now.total); });
    if (!noRoom.empty())
    {
        refuse(noRoom);
    }

    // What fails here fails on one rank or on all: each one ends the run
    try
    {
        file_->append(frames_, time_.timeIndex(), time_.value(), now);
    }
    catch (const std::runtime_error& error)
    {
        refuse(error.what());
    }
    ++frames_;

    const string noSidecar = problemOfMaster
    (
        [&]
        {
            written_.times.append(time_.value());
            written_.rows.append(now.total);
            xdmfSidecar::write
            (
                file_->path(), fields_, written_.times, written_.rows
            );
        }
    );
    if (!noSidecar.empty())
    {
        refuse(noSidecar);
    }
    return true;
}
