/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "h5mdFile.H"
#include "h5mdLayout.H"

#include "OSspecific.H"
#include "foamVersion.H"

#include <limits>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Rows of a chunk: not less, since each one needs an entry in an index; nor
//  more than what fits into the 1 MB that readers keep of a dataset
constexpr hsize_t smallestChunk = 256;
constexpr hsize_t largestChunk = 32768;


h5Handle makeGroup(const hid_t where, const char* path)
{
    return h5Handle
    (
        H5Gcreate2(where, path, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Gclose,
        std::string("to make ") + path
    );
}


//- A new attribute: scalar (count 0) or of that many values
void setAttribute
(
    const hid_t where,
    const char* name,
    const hid_t type,
    const hsize_t count,
    const void* values
)
{
    const std::string attempted(std::string("to write attribute ") + name);
    const h5Handle space
    (
        count ? H5Screate_simple(1, &count, nullptr) : H5Screate(H5S_SCALAR),
        H5Sclose,
        attempted
    );
    const h5Handle attribute
    (
        H5Acreate2(where, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose,
        attempted
    );
    h5Checked(H5Awrite(attribute, type, values), attempted);
}


//- Texts of variable length: those that h5py, and so MDAnalysis, takes for texts
h5Handle textType()
{
    h5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "to make a type of text");
    h5Checked(H5Tset_size(type, H5T_VARIABLE), "to make a type of text");
    h5Checked(H5Tset_cset(type, H5T_CSET_UTF8), "to make a type of text");
    return type;
}


void setText(const hid_t where, const char* name, const std::string& text)
{
    const h5Handle type(textType());
    const char* const start = text.c_str();
    setAttribute(where, name, type, 0, &start);
}


void setVersion(const hid_t where, const int major, const int minor)
{
    const int version[] = {major, minor};
    setAttribute(where, "version", H5T_NATIVE_INT, 2, version);
}


//- An empty dataset of frames with that many rows, of that many columns
//  (0: it has none), the groups on its path included
h5Handle makeSeries
(
    const hid_t file,
    const std::string& path,
    const hid_t type,
    const void* absent,
    const hsize_t rowsOfChunk,
    const hsize_t columns,
    const label compression
)
{
    const std::string attempted("to make " + path);
    const int rank = 1 + (rowsOfChunk > 0) + (columns > 0);
    const hsize_t extent[] = {0, 0, columns};
    const hsize_t most[] = {H5S_UNLIMITED, H5S_UNLIMITED, columns};
    const hsize_t chunk[] =
        {rowsOfChunk ? 1 : h5mdLayout::framesOfChunk, rowsOfChunk, columns};

    const h5Handle space
    (
        H5Screate_simple(rank, extent, most), H5Sclose, attempted
    );
    const h5Handle groups(H5Pcreate(H5P_LINK_CREATE), H5Pclose, attempted);
    h5Checked(H5Pset_create_intermediate_group(groups, 1), attempted);

    const h5Handle form(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, attempted);
    h5Checked(H5Pset_chunk(form, rank, chunk), attempted);
    h5Checked(H5Pset_fill_value(form, type, absent), attempted);
    // Where ranks write parts of a compressed chunk it must be there before
    h5Checked(H5Pset_alloc_time(form, H5D_ALLOC_TIME_EARLY), attempted);
    if (compression && rowsOfChunk)
    {
        h5Checked(H5Pset_shuffle(form), attempted);
        h5Checked(H5Pset_deflate(form, unsigned(compression)), attempted);
    }

    return h5Handle
    (
        H5Dcreate2
        (
            file, path.c_str(), type, space, groups, form, H5P_DEFAULT
        ),
        H5Dclose,
        attempted
    );
}


void makeHead(const hid_t file)
{
    const h5Handle head(makeGroup(file, "/h5md"));
    setVersion(head, 1, 1);

    const h5Handle author(makeGroup(file, "/h5md/author"));
    const std::string user(userName());
    setText(author, "name", user.empty() ? "unknown" : user);

    const h5Handle creator(makeGroup(file, "/h5md/creator"));
    setText(creator, "name", h5mdLayout::creator);
    setText(creator, "version", "with OpenFOAM " + foamVersion::version);

    const h5Handle modules(makeGroup(file, "/h5md/modules"));
    const h5Handle units(makeGroup(file, "/h5md/modules/units"));
    setVersion(units, 1, 0);
    setText(units, "system", "SI");
}


//- The step and time of all frames, in the folder of a dataset
void linkTimes(const hid_t file, const std::string& values)
{
    const std::string folder(values.substr(0, values.rfind('/')));
    const auto link = [&](const char* from, const std::string& to)
    {
        h5Checked
        (
            H5Lcreate_hard
            (
                file, from, file, to.c_str(), H5P_DEFAULT, H5P_DEFAULT
            ),
            "to make " + to
        );
    };
    link(h5mdLayout::stepPath, folder + "/step");
    link(h5mdLayout::timePath, folder + "/time");
}


//- An empty dataset of boxes, one per frame
void makeEdges(const hid_t file)
{
    const std::string attempted("to make the box");
    const hsize_t extent[] = {0, 3, 3};
    const hsize_t most[] = {H5S_UNLIMITED, 3, 3};
    const hsize_t chunk[] = {h5mdLayout::boxesOfChunk, 3, 3};

    const h5Handle space
    (
        H5Screate_simple(3, extent, most), H5Sclose, attempted
    );
    const h5Handle groups(H5Pcreate(H5P_LINK_CREATE), H5Pclose, attempted);
    h5Checked(H5Pset_create_intermediate_group(groups, 1), attempted);
    const h5Handle form(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, attempted);
    h5Checked(H5Pset_chunk(form, 3, chunk), attempted);
    h5Checked(H5Pset_alloc_time(form, H5D_ALLOC_TIME_EARLY), attempted);

    const h5Handle edges
    (
        H5Dcreate2
        (
            file, h5mdLayout::edgesPath, H5T_IEEE_F64LE, space, groups, form,
            H5P_DEFAULT
        ),
        H5Dclose,
        attempted
    );
    linkTimes(file, h5mdLayout::edgesPath);
}


void makeBox(const hid_t file, const periodicAxes& axes)
{
    const h5Handle box(makeGroup(file, "/particles/clay/box"));
    const int dimension = 3;
    setAttribute(box, "dimension", H5T_NATIVE_INT, 0, &dimension);

    const char* boundary[3];
    double extent[3], origin[3];
    bool anyPeriodic = false;
    for (direction axis = 0; axis < 3; ++axis)
    {
        boundary[axis] = axes.periodic(axis) ? "periodic" : "none";
        extent[axis] = axes.upper(axis) - axes.lower(axis);
        origin[axis] = axes.lower(axis);
        anyPeriodic = anyPeriodic || axes.periodic(axis);
    }
    const h5Handle type(textType());
    setAttribute(box, "boundary", type, 3, boundary);

    // Readers that find edges take all of them for periods
    if (anyPeriodic)
    {
        makeEdges(file);
    }

    const hsize_t three = 3;
    const h5Handle space
    (
        H5Screate_simple(1, &three, nullptr), H5Sclose, "to make the box"
    );
    const auto makeVector = [&](const char* name, const double* values)
    {
        const h5Handle dataset
        (
            H5Dcreate2
            (
                box, name, H5T_NATIVE_DOUBLE, space,
                H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT
            ),
            H5Dclose,
            "to make the box"
        );
        h5Checked
        (
            H5Dwrite
            (
                dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                values
            ),
            "to write the box"
        );
    };

    // H5MD has boxes begin at 0; meshes may begin elsewhere
    makeVector("origin", origin);
    makeVector("extent", extent);
}


void makeAll
(
    const hid_t file,
    const wordList& fields,
    const periodicAxes& box,
    const hsize_t rows,
    const label compression
)
{
    using namespace h5mdLayout;

    const std::int64_t none = 0;
    const std::int64_t noId = -1;
    const double noValue = std::numeric_limits<double>::quiet_NaN();

    makeHead(file);
    makeSeries(file, numberPath, H5T_STD_I64LE, &none, 0, 0, 0);
    makeSeries(file, rowsPath, H5T_STD_I64LE, &none, 0, 0, 0);
    makeSeries(file, stepPath, H5T_STD_I64LE, &none, 0, 0, 0);
    setText
    (
        makeSeries(file, timePath, H5T_IEEE_F64LE, &noValue, 0, 0, 0),
        "unit",
        "s"
    );
    linkTimes(file, rowsPath);

    makeSeries(file, idPath, H5T_STD_I64LE, &noId, rows, 0, compression);
    linkTimes(file, idPath);
    for (const auto& [name, unit] : vectors)
    {
        if (fields.found(name))
        {
            const std::string path(vectorsPath(name));
            const h5Handle made
            (
                makeSeries
                (
                    file, path, H5T_IEEE_F64LE, &noValue, rows, 3, compression
                )
            );
            if (*unit)
            {
                setText(made, "unit", unit);
            }
            linkTimes(file, path);
        }
    }
    makeBox(file, box);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

void Foam::h5mdFile::create(const label number, const label compression) const
{
    // Made beside its place and moved there when it is whole
    const fileName unfinished(path_ + ".new");
    try
    {
        h5Handle file
        (
            H5Fcreate
            (
                unfinished.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT
            ),
            H5Fclose,
            "to make " + unfinished
        );
        makeAll
        (
            file,
            fields_,
            box_,
            std::min(std::max(hsize_t(number), smallestChunk), largestChunk),
            compression
        );
        file.close("to make " + unfinished);
    }
    catch (const h5Error&)
    {
        rm(unfinished);
        throw;
    }

    if (!mv(unfinished, path_))
    {
        throw std::runtime_error
        (
            "to move " + unfinished + " to " + path_ + " failed"
        );
    }
}
