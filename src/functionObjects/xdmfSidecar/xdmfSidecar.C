/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "xdmfSidecar.H"

#include "OSspecific.H"

#include <fstream>
#include <iomanip>
#include <stdexcept>

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- What all frames refer to
struct trajectory
{
    std::string h5;
    label frames;
    label rows;
};


//- The rows of a frame of a dataset; columns 0: has no columns
void writePart
(
    std::ostream& os,
    const trajectory& all,
    const std::string& field,
    const label frame,
    const label number,
    const label columns
)
{
    const std::string width(columns ? ' ' + std::to_string(columns) : "");
    const char* const zero = columns ? " 0" : "";
    const char* const one = columns ? " 1" : "";
    const char* const type =
        columns
      ? "NumberType=\"Float\" Precision=\"8\""
      : "NumberType=\"Int\" Precision=\"8\"";

    os  << "<DataItem ItemType=\"HyperSlab\" " << type << " Dimensions=\""
        << number << width << "\">\n"
        << "<DataItem NumberType=\"Int\" Format=\"XML\" Dimensions=\"3 "
        << (columns ? 3 : 2) << "\">"
        << frame << " 0" << zero << "  1 1" << one
        << "  1 " << number << width << "</DataItem>\n"
        << "<DataItem " << type << " Format=\"HDF\" Dimensions=\""
        << all.frames << ' ' << all.rows << width << "\">"
        << all.h5 << ":/particles/clay/" << field << "/value</DataItem>\n"
        << "</DataItem>\n";
}


void writeFrame
(
    std::ostream& os,
    const trajectory& all,
    const wordList& fields,
    const scalar time,
    const label frame,
    const label number
)
{
    os  << "<Grid GridType=\"Uniform\">\n"
        << "<Time Value=\"" << time << "\"/>\n"
        << "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\""
        << number << "\"/>\n"
        << "<Geometry GeometryType=\"XYZ\">\n";
    writePart(os, all, "position", frame, number, 3);
    os  << "</Geometry>\n"
        << "<Attribute Name=\"id\" AttributeType=\"Scalar\" Center=\"Node\">\n";
    writePart(os, all, "id", frame, number, 0);
    os  << "</Attribute>\n";

    for (const word& field : fields)
    {
        if (field != "position")
        {
            os  << "<Attribute Name=\"" << field
                << "\" AttributeType=\"Vector\" Center=\"Node\">\n";
            writePart(os, all, field, frame, number, 3);
            os  << "</Attribute>\n";
        }
    }
    os  << "</Grid>\n";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global functions  * * * * * * * * * * * * * //

Foam::fileName Foam::xdmfSidecar::path(const fileName& h5)
{
    return h5.lessExt() + ".xmf";
}


void Foam::xdmfSidecar::write
(
    const fileName& h5,
    const wordList& fields,
    const UList<scalar>& times,
    const UList<label>& rows
)
{
    const fileName target(path(h5));
    const fileName unfinished(target + ".new");

    trajectory all{h5.name(), rows.size(), 0};
    for (const label number : rows)
    {
        all.rows = max(all.rows, number);
    }
    if (all.rows == 0)
    {
        rm(target);
        return;
    }

    std::ofstream os(unfinished);
    os  << std::setprecision(17)
        << "<?xml version=\"1.0\"?>\n"
        << "<Xdmf Version=\"2.0\">\n<Domain>\n"
        << "<Grid Name=\"clay\" GridType=\"Collection\""
        << " CollectionType=\"Temporal\">\n";
    forAll(rows, frame)
    {
        if (rows[frame])
        {
            writeFrame(os, all, fields, times[frame], frame, rows[frame]);
        }
    }
    os  << "</Grid>\n</Domain>\n</Xdmf>\n";
    os.close();

    if (!os || !mv(unfinished, target))
    {
        rm(unfinished);
        throw std::runtime_error("to write " + target + " failed");
    }
}
