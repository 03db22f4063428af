/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "h5mdFile.H"
#include "h5Access.H"
#include "h5mdLayout.H"

#include "Pstream.H"
#include "diskRoom.H"

#include <algorithm>
#include <limits>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace h5Access;
using namespace h5mdLayout;

template<class Value>
std::vector<Value> readFirst
(
    const hid_t file,
    const char* path,
    const hid_t type,
    const label frames
)
{
    const std::string attempted(std::string("to read ") + path);
    const h5Handle dataset(openDataset(file, path));
    const h5Handle space(H5Dget_space(dataset), H5Sclose, attempted);

    const hsize_t start = 0;
    const hsize_t count = frames;
    std::vector<Value> values(frames);
    if (frames)
    {
        const h5Handle memory
        (
            H5Screate_simple(1, &count, nullptr), H5Sclose, attempted
        );
        h5Checked
        (
            H5Sselect_hyperslab
            (
                space, H5S_SELECT_SET, &start, nullptr, &count, nullptr
            ),
            attempted
        );
        h5Checked
        (
            H5Dread(dataset, type, memory, space, H5P_DEFAULT, values.data()),
            attempted
        );
    }
    return values;
}


//- Bytes that a frame of this number of platelets may need
std::size_t mostBytes
(
    const fileName& path,
    const label fields,
    const hsize_t needed
)
{
    const std::string attempted("to get the size of chunks");
    const h5Handle file(openFile(path, H5F_ACC_RDONLY, by::one));
    const h5Handle ids(openDataset(file, idPath));
    const h5Handle form(H5Dget_create_plist(ids), H5Pclose, attempted);

    std::array<hsize_t, 2> chunk{};
    h5Checked(H5Pget_chunk(form, 2, chunk.data()), attempted);
    const auto [frames, rows, one] = extents(ids);

    // All as without compression. Where there are more rows than ever, the
    // earlier frames get chunks too, which have only what stands for nothing:
    // compressed, about a thousandth
    const auto chunks = [&](const hsize_t n)
    {
        return (n + chunk[1] - 1)/chunk[1];
    };
    const bool compressed = H5Pget_nfilters(form) > 0;
    const hsize_t added = chunks(std::max(needed, rows)) - chunks(rows);
    const hsize_t bytesOfChunk =
        chunk[1]*(sizeof(std::int64_t) + 3*sizeof(double)*fields);

    // What a frame needs in the library's indices, and chunks of numbers
    constexpr hsize_t own =
        65536
      + (series.size()*framesOfChunk + 9*boxesOfChunk)*sizeof(double);

    return
        own + chunks(needed)*bytesOfChunk
      + frames*added*bytesOfChunk/(compressed ? 100 : 1);
}


//- Write this rank's rows of a frame; without columns: an id per row.
//  Collective
void writeRows
(
    const hid_t dataset,
    const std::string& path,
    const hid_t type,
    const hsize_t frame,
    const hsize_t first,
    const hsize_t count,
    const hsize_t columns,
    const void* values
)
{
    const std::string attempted("to write " + path);
    const int rank = 2 + (columns > 0);
    const hsize_t start[] = {frame, first, 0};
    const hsize_t counts[] = {1, count, columns};

    const h5Handle space(H5Dget_space(dataset), H5Sclose, attempted);
    const h5Handle memory
    (
        H5Screate_simple(rank, counts, nullptr), H5Sclose, attempted
    );

    // A rank without rows takes part nevertheless
    if (count)
    {
        h5Checked
        (
            H5Sselect_hyperslab
            (
                space, H5S_SELECT_SET, start, nullptr, counts, nullptr
            ),
            attempted
        );
    }
    else
    {
        h5Checked(H5Sselect_none(space), attempted);
        h5Checked(H5Sselect_none(memory), attempted);
    }

    const h5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose, attempted);
    if (Pstream::parRun())
    {
        h5Checked
        (
            H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE), attempted
        );
    }
    h5Checked
    (
        H5Dwrite(dataset, type, memory, space, transfer, values), attempted
    );
}


//- Write the frame's value of a series of numbers, or of matrices of that many
//  columns, by the master. Collective
void appendValue
(
    const hid_t file,
    const char* path,
    const hid_t type,
    const hsize_t frame,
    const void* value,
    const hsize_t columns = 0
)
{
    const std::string attempted(std::string("to write ") + path);
    const h5Handle dataset(openDataset(file, path));
    setExtents(dataset, {frame + 1, columns, columns});

    if (Pstream::master())
    {
        const hsize_t start[] = {frame, 0, 0};
        const hsize_t counts[] = {1, columns, columns};
        const h5Handle space(H5Dget_space(dataset), H5Sclose, attempted);
        const h5Handle memory
        (
            H5Screate_simple(columns ? 3 : 1, counts, nullptr), H5Sclose,
            attempted
        );
        h5Checked
        (
            H5Sselect_hyperslab
            (
                space, H5S_SELECT_SET, start, nullptr, counts, nullptr
            ),
            attempted
        );
        h5Checked
        (
            H5Dwrite(dataset, type, memory, space, H5P_DEFAULT, value),
            attempted
        );
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

const Foam::wordList& Foam::h5mdFile::validFields()
{
    static const wordList names
    ({
        vectors[0][0], vectors[1][0], vectors[2][0]
    });
    return names;
}


Foam::h5mdFile::h5mdFile
(
    const fileName& path,
    const wordList& fields,
    const periodicAxes& box
)
:
    path_(path),
    fields_(fields),
    box_(box)
{
    prepareHDF5();
}


Foam::h5mdFile::contents Foam::h5mdFile::read() const
{
    const h5Handle file(openFile(path_, H5F_ACC_RDONLY, by::one));

    if (textOf(file, "/h5md/creator", "name") != creator)
    {
        throw std::runtime_error
        (
            std::string("it is not a trajectory that ") + creator + " made"
        );
    }
    if (!h5Access::exists(file, rowsPath))
    {
        throw std::runtime_error
        (
            std::string("it is of an earlier version of ") + creator
          + ", whose rows were not the same platelet's in all frames"
        );
    }

    contents found;
    for (const word& field : validFields())
    {
        if (h5Access::exists(file, vectorsPath(field)))
        {
            found.fields.append(field);
        }
    }

    hsize_t frames = std::numeric_limits<label>::max();
    for (const char* path : series)
    {
        frames = std::min(frames, extents(openDataset(file, path))[0]);
    }
    for (const std::string& path : tables(found.fields))
    {
        frames = std::min(frames, extents(openDataset(file, path))[0]);
    }

    const auto times =
        readFirst<double>(file, timePath, H5T_NATIVE_DOUBLE, label(frames));
    const auto rows =
        readFirst<std::int64_t>
        (
            file, rowsPath, H5T_NATIVE_INT64, label(frames)
        );

    found.times.setSize(label(frames));
    found.rows.setSize(label(frames));
    std::copy(times.begin(), times.end(), found.times.begin());
    std::copy(rows.begin(), rows.end(), found.rows.begin());

    return found;
}


void Foam::h5mdFile::cut(const contents& before, const label frames) const
{
    hsize_t rows = 0;
    for (label frame = 0; frame < frames; ++frame)
    {
        rows = std::max(rows, hsize_t(before.rows[frame]));
    }

    h5Handle file(openFile(path_, H5F_ACC_RDWR, by::one));

    // As in append: what makes frames count on the disk before the rest
    for (const char* path : series)
    {
        setExtents(openDataset(file, path), {hsize_t(frames)});
    }
    h5Checked(H5Fflush(file, H5F_SCOPE_LOCAL), "to cut frames");

    for (const std::string& path : tables(fields_))
    {
        setExtents(openDataset(file, path), {hsize_t(frames), rows, 3});
    }
    if (h5Access::exists(file, edgesPath))
    {
        setExtents(openDataset(file, edgesPath), {hsize_t(frames), 3, 3});
    }
    file.close("to cut frames");
}


void Foam::h5mdFile::reserve(const label rows) const
{
    diskRoom::reserve(path_, mostBytes(path_, fields_.size(), rows));
}


void Foam::h5mdFile::append
(
    const label frames,
    const label step,
    const scalar time,
    const rowsById& rows
) const
{
    appendRows(frames, rows);

    // Opened anew: only when it is closed does the library note how long the
    // file is, without which nobody can read what is at its end
    h5Handle file(openFile(path_, H5F_ACC_RDWR, by::all));

    const std::int64_t numberNow = rows.number;
    const std::int64_t rowsNow = rows.total;
    const std::int64_t stepNow = step;
    const double timeNow = time;
    appendValue(file, numberPath, H5T_NATIVE_INT64, frames, &numberNow);
    appendValue(file, rowsPath, H5T_NATIVE_INT64, frames, &rowsNow);
    appendValue(file, stepPath, H5T_NATIVE_INT64, frames, &stepNow);
    appendValue(file, timePath, H5T_NATIVE_DOUBLE, frames, &timeNow);

    file.close("to write a frame");
}


void Foam::h5mdFile::appendRows(const label frames, const rowsById& rows) const
{
    h5Handle file(openFile(path_, H5F_ACC_RDWR, by::all));

    const hsize_t found = extents(openDataset(file, timePath))[0];
    if (found != hsize_t(frames))
    {
        throw std::runtime_error
        (
            "it has " + std::to_string(found) + " frames, this run left "
          + std::to_string(frames) + ". Does something else write it?"
        );
    }

    const hsize_t frame = frames;
    const auto appendTo =
    [&]
    (
        const std::string& path,
        const hid_t type,
        const hsize_t columns,
        const void* values
    )
    {
        const h5Handle dataset(openDataset(file, path));
        const hsize_t most =
            std::max(extents(dataset)[1], hsize_t(rows.total));

        setExtents(dataset, {frame + 1, most, columns});
        if (rows.total)
        {
            writeRows
            (
                dataset, path, type, frame, rows.first, rows.ids.size(),
                columns, values
            );
        }
    };

    const std::vector<std::int64_t> ids(rows.ids.begin(), rows.ids.end());
    appendTo(idPath, H5T_NATIVE_INT64, 0, ids.data());
    forAll(fields_, i)
    {
        appendTo
        (
            vectorsPath(fields_[i]),
            sizeof(scalar) == sizeof(double)
              ? H5T_NATIVE_DOUBLE : H5T_NATIVE_FLOAT,
            3,
            rows.columns[i].cdata()
        );
    }
    if (h5Access::exists(file, edgesPath))
    {
        double edges[3][3] = {};
        for (direction axis = 0; axis < 3; ++axis)
        {
            edges[axis][axis] = box_.upper(axis) - box_.lower(axis);
        }
        appendValue(file, edgesPath, H5T_NATIVE_DOUBLE, frame, edges, 3);
    }
    file.close("to write a frame");
}
