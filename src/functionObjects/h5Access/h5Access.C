/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "h5Access.H"

#include "Pstream.H"

Foam::h5Handle Foam::h5Access::openFile
(
    const std::string& path,
    const unsigned flags,
    const by whom
)
{
    const std::string attempted("to choose a way of access");
    const h5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, attempted);

    if (whom == by::all && Pstream::parRun())
    {
        h5Checked
        (
            H5Pset_fapl_mpio(access, MPI_COMM_WORLD, MPI_INFO_NULL), attempted
        );
    }
    #if H5_VERSION_GE(1, 10, 7)
    h5Checked(H5Pset_file_locking(access, false, true), attempted);
    #endif

    return h5Handle
    (
        H5Fopen(path.c_str(), flags, access), H5Fclose, "to open it"
    );
}


Foam::h5Handle Foam::h5Access::openDataset
(
    const hid_t file,
    const std::string& path
)
{
    const h5Handle access
    (
        H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, "to choose a cache"
    );
    h5Checked(H5Pset_chunk_cache(access, 0, 0, 1), "to choose a cache");

    return h5Handle
    (
        H5Dopen2(file, path.c_str(), access), H5Dclose, "to open " + path
    );
}


bool Foam::h5Access::exists(const hid_t file, const std::string& path)
{
    // Each group on the way must be there for H5Lexists to look further
    std::size_t end = 0;
    do
    {
        end = path.find('/', end + 1);
        if (H5Lexists(file, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0)
        {
            return false;
        }
    }
    while (end != std::string::npos);

    return true;
}


std::string Foam::h5Access::textOf
(
    const hid_t file,
    const std::string& path,
    const char* name
)
{
    if
    (
        !exists(file, path)
     || H5Aexists_by_name(file, path.c_str(), name, H5P_DEFAULT) <= 0
    )
    {
        return std::string();
    }

    const std::string attempted("to read " + path + ' ' + name);
    const h5Handle attribute
    (
        H5Aopen_by_name(file, path.c_str(), name, H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose,
        attempted
    );
    const h5Handle type(H5Aget_type(attribute), H5Tclose, attempted);
    if (H5Tget_class(type) != H5T_STRING)
    {
        return std::string();
    }
    if (H5Tis_variable_str(type) > 0)
    {
        char* found = nullptr;
        h5Checked(H5Aread(attribute, type, &found), attempted);
        const std::string text(found ? found : "");
        H5free_memory(found);
        return text;
    }
    std::string text(H5Tget_size(type) + 1, '\0');
    h5Checked(H5Aread(attribute, type, &text[0]), attempted);

    return std::string(text.c_str());
}


std::array<hsize_t, 3> Foam::h5Access::extents(const hid_t dataset)
{
    const std::string attempted("to get the extents of a dataset");
    const h5Handle space(H5Dget_space(dataset), H5Sclose, attempted);

    std::array<hsize_t, 3> found{1, 1, 1};
    if (h5Checked(H5Sget_simple_extent_ndims(space), attempted) > 3)
    {
        throw h5Error(attempted + ": it has more than three");
    }
    h5Checked
    (
        H5Sget_simple_extent_dims(space, found.data(), nullptr), attempted
    );
    return found;
}


void Foam::h5Access::setExtents
(
    const hid_t dataset,
    const std::array<hsize_t, 3>& extents
)
{
    h5Checked(H5Dset_extent(dataset, extents.data()), "to resize a dataset");
}
