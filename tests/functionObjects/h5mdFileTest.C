/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What h5mdFile writes is read back with the HDF5 library alone.
\*---------------------------------------------------------------------------*/

#include "h5mdFile.H"

#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "boxMesh.H"
#include "periodicAxes.H"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace Foam;

namespace
{

//- Value of a platelet in a frame; another one for each
vector valueOf(const label frame, const label id)
{
    return vector(id + 0.25, 1e-9*id, frame);
}


//- A frame of platelets with the ids 0, 2, 4 ..., dealt to the ranks: of those
//  with odd ids nothing is there
rowsById rowsOf(const label frame, const label number)
{
    labelList ids;
    vectorField values;
    for (label i = 0; i < number; ++i)
    {
        if (i % Pstream::nProcs() == Pstream::myProcNo())
        {
            ids.append(2*i);
            values.append(valueOf(frame, 2*i));
        }
    }
    List<vectorField> columns(2, values);
    return rowsById(ids, columns);
}


//- A file in a folder of its own, removed in the end
class h5mdFileTest
:
    public testing::Test
{
    fileName folder_;

protected:

    fileName path;
    std::unique_ptr<h5mdFile> file;

    //- A file for a box that is periodic along x and z, or not at all
    void newFile(const bool periodic = true)
    {
        boxSettings settings;
        settings.n = {{4, 2, 2}};
        settings.size = vector(4e-7, 2e-7, 3e-7);
        settings.periodic = {{periodic, false, periodic}};
        const boxMesh made(settings);
        file = std::make_unique<h5mdFile>
        (
            path, wordList({"position", "force"}), periodicAxes(made.mesh())
        );
    }

    void SetUp() override
    {
        std::string name(Foam::getEnv("TMPDIR"));
        name = (name.empty() ? "/var/tmp" : name) + "/bentoFoamH5.XXXXXX";
        if (Pstream::master() && !mkdtemp(&name[0]))
        {
            name.clear();
        }
        folder_ = name;
        Pstream::scatter(folder_);
        ASSERT_FALSE(folder_.empty());
        path = folder_/"clay.h5";
        newFile();
    }

    void TearDown() override
    {
        barrier();
        if (Pstream::master())
        {
            rmDir(folder_);
        }
    }

    static void barrier()
    {
        returnReduce(label(0), sumOp<label>());
    }

    void create(const label number, const label compression)
    {
        if (Pstream::master())
        {
            file->create(number, compression);
        }
        barrier();
    }

    void append(const label frame, const label number)
    {
        const rowsById rows(rowsOf(frame, number));
        if (Pstream::master())
        {
            file->reserve(rows.total);
        }
        barrier();
        file->append(frame, 10*frame, 0.5*frame, rows);
        barrier();
    }

    //- What the master finds in a dataset, and its extents
    template<class Value>
    std::vector<Value> readAll
    (
        const std::string& name,
        const hid_t type,
        std::vector<hsize_t>& extents
    ) const
    {
        const h5Handle opened
        (
            H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, ""
        );
        const h5Handle dataset
        (
            H5Dopen2(opened, name.c_str(), H5P_DEFAULT), H5Dclose, ""
        );
        const h5Handle space(H5Dget_space(dataset), H5Sclose, "");
        extents.resize(H5Sget_simple_extent_ndims(space));
        H5Sget_simple_extent_dims(space, extents.data(), nullptr);

        std::vector<Value> values(H5Sget_simple_extent_npoints(space));
        h5Checked
        (
            H5Dread
            (
                dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()
            ),
            "to read"
        );
        return values;
    }

    //- The file has frames of these numbers of platelets, and nothing else
    void expectFrames(const labelList& numbers) const
    {
        if (!Pstream::master())
        {
            return;
        }
        const hsize_t frames = numbers.size();
        hsize_t rows = 0;
        for (const label number : numbers)
        {
            rows = std::max(rows, hsize_t(number ? 2*number - 1 : 0));
        }

        using counts = std::vector<hsize_t>;
        counts extents;
        const auto number = readAll<std::int64_t>
        (
            "observables/number/value", H5T_NATIVE_INT64, extents
        );
        ASSERT_EQ(extents, counts({frames}));
        const auto step = readAll<std::int64_t>
        (
            "particles/clay/force/step", H5T_NATIVE_INT64, extents
        );
        ASSERT_EQ(extents, counts({frames}));
        const auto time = readAll<double>
        (
            "particles/clay/position/time", H5T_NATIVE_DOUBLE, extents
        );
        ASSERT_EQ(extents, counts({frames}));
        const auto id = readAll<std::int64_t>
        (
            "particles/clay/id/value", H5T_NATIVE_INT64, extents
        );
        ASSERT_EQ(extents, counts({frames, rows}));
        const auto force = readAll<double>
        (
            "particles/clay/force/value", H5T_NATIVE_DOUBLE, extents
        );
        ASSERT_EQ(extents, counts({frames, rows, 3}));

        label wrong = 0;
        for (hsize_t frame = 0; frame < frames; ++frame)
        {
            EXPECT_EQ(number[frame], numbers[frame]);
            EXPECT_EQ(step[frame], std::int64_t(10*frame));
            EXPECT_EQ(time[frame], 0.5*frame);

            for (hsize_t row = 0; row < rows; ++row)
            {
                const hsize_t at = frame*rows + row;
                const bool counts =
                    row % 2 == 0 && row < hsize_t(2*numbers[frame]);
                const vector expected(valueOf(frame, row));

                wrong += id[at] != (counts ? std::int64_t(row) : -1);
                for (direction i = 0; i < 3; ++i)
                {
                    wrong +=
                        counts
                      ? force[3*at + i] != expected[i]
                      : !std::isnan(force[3*at + i]);
                }
            }
        }
        EXPECT_EQ(wrong, 0);
    }

    //- What read() says, on the master
    std::string refusal() const
    {
        try
        {
            file->read();
        }
        catch (const std::runtime_error& error)
        {
            return error.what();
        }
        return "";
    }
};

} // End anonymous namespace


TEST_F(h5mdFileTest, holdsFramesOfManyChunksAndOfNone)
{
    // Chunks of 300 rows, of which ranks share some
    for (const label compression : {0, 1})
    {
        create(300, compression);
        append(0, 300);
        append(1, 1000);
        append(2, 0);
        append(3, 3);
        append(4, 500);
        expectFrames({300, 1000, 0, 3, 500});
    }
}


TEST_F(h5mdFileTest, growsFromNothing)
{
    create(0, 4);
    append(0, 0);
    append(1, 1);
    append(2, 700);
    expectFrames({0, 1, 700});
}


TEST_F(h5mdFileTest, framesAreCutAndAppendedAgain)
{
    create(500, 4);
    append(0, 300);
    append(1, 200);
    append(2, 500);
    append(3, 100);
    const off_t whole = fileSize(path);

    for (int restart = 0; restart < 5; ++restart)
    {
        if (Pstream::master())
        {
            const h5mdFile::contents found(file->read());
            EXPECT_EQ(found.fields, wordList({"position", "force"}));
            EXPECT_EQ(found.times, scalarList({0, 0.5, 1, 1.5}));
            EXPECT_EQ(found.rows, labelList({599, 399, 999, 199}));
            file->cut(found, 2);
        }
        barrier();
        expectFrames({300, 200});

        append(2, 500);
        append(3, 100);
        expectFrames({300, 200, 500, 100});
    }

    // Not the 3.5 times of a file that gives no room back
    EXPECT_LT(fileSize(path), 2*whole);
}


TEST_F(h5mdFileTest, anInterruptedFrameDoesNotCount)
{
    create(100, 4);
    append(0, 100);
    append(1, 100);

    if (Pstream::master())
    {
        // As if the run had ended before time, the last to be written, had it
        {
            const h5Handle opened
            (
                H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, ""
            );
            const h5Handle time
            (
                H5Dopen2(opened, "particles/clay/id/time", H5P_DEFAULT),
                H5Dclose,
                ""
            );
            const hsize_t one = 1;
            h5Checked(H5Dset_extent(time, &one), "to shorten");
        }
        const h5mdFile::contents found(file->read());
        EXPECT_EQ(found.times, scalarList({0}));
        file->cut(found, 1);
    }
    barrier();
    expectFrames({100});
}


TEST_F(h5mdFileTest, boxIsThatOfTheMesh)
{
    create(1, 0);
    append(0, 1);
    append(1, 1);
    if (Pstream::master())
    {
        std::vector<hsize_t> extents;
        const auto edges = readAll<double>
        (
            "particles/clay/box/edges/value", H5T_NATIVE_DOUBLE, extents
        );
        ASSERT_EQ(extents, std::vector<hsize_t>({2, 3, 3}));

        // Of the second frame
        const double expected[] = {4e-7, 0, 0, 0, 2e-7, 0, 0, 0, 3e-7};
        for (int i = 0; i < 9; ++i)
        {
            EXPECT_NEAR(edges[9 + i], expected[i], 1e-20);
        }
    }
}


// Readers would take edges for periods
TEST_F(h5mdFileTest, boxWithoutPeriodsHasNoEdges)
{
    newFile(false);
    create(1, 0);
    append(0, 1);
    if (Pstream::master())
    {
        const h5Handle opened
        (
            H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, ""
        );
        EXPECT_GT(H5Lexists(opened, "particles/clay/box", H5P_DEFAULT), 0);
        EXPECT_EQ
        (
            H5Lexists(opened, "particles/clay/box/edges", H5P_DEFAULT), 0
        );
    }
}


TEST_F(h5mdFileTest, refusesWhatItDidNotMake)
{
    if (!Pstream::master())
    {
        return;
    }
    EXPECT_NE(refusal().find("No such file"), std::string::npos) << refusal();

    std::ofstream(path) << "something else";
    EXPECT_NE(refusal().find("to open it"), std::string::npos) << refusal();

    rm(path);
    {
        const h5Handle other
        (
            H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
            H5Fclose,
            ""
        );
    }
    EXPECT_NE(refusal().find("not a trajectory"), std::string::npos)
        << refusal();

    // Without what this version adds
    file->create(1, 0);
    {
        const h5Handle earlier
        (
            H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, ""
        );
        H5Ldelete(earlier, "observables/rows", H5P_DEFAULT);
    }
    EXPECT_NE(refusal().find("earlier version"), std::string::npos)
        << refusal();
}


TEST_F(h5mdFileTest, framesOfAnotherAreNoticed)
{
    // The error leaves files open, which only the end of a run may do: alone
    if (Pstream::parRun())
    {
        return;
    }
    create(1, 0);
    append(0, 1);
    const rowsById rows(rowsOf(0, 1));
    EXPECT_THROW(file->append(0, 0, 0, rows), std::runtime_error);
}
