/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fracturePlane.H"
#include "OStringStream.H"

using namespace Foam;

boxSpec fracturePlane::spec(const label n)
{
    boxSpec result;
    result.size = vector(2, 1, 0.01);
    result.cells = {2*n, n, 1};
    result.types = {"patch", "patch", "wall", "wall", "empty", "empty"};
    return result;
}


fracturePlane::fracturePlane(const boxSpec& spec)
:
    flowCase(spec)
{
    writeInlet("type zeroGradient;", "type fixedValue; value uniform 1;");
}


void fracturePlane::writeInlet
(
    const string& U,
    const string& p,
    const string& edges
)
{
    writeU
    ({
        {"bottom", edges},
        {"top", edges},
        {"inlet", U},
        {"outlet", "type zeroGradient;"}
    });
    writeP
    ({
        {"bottom", "type zeroGradient;"},
        {"top", "type zeroGradient;"},
        {"inlet", p},
        {"outlet", "type fixedValue; value uniform 0;"}
    });
}


void fracturePlane::writePlaneField
(
    const word& name,
    const word& dimensions,
    const std::function<scalar(const vector&)>& value,
    const word& folder
)
{
    OStringStream values;
    values.precision(17);
    values << "nonuniform List<scalar> " << mesh().nCells() << " ( ";
    for (const vector& x : mesh().C().primitiveField())
    {
        values << value(x) << ' ';
    }
    values << ")";

    // Also between ranks, where the value is made when it is needed
    std::map<word, string> patches;
    for (const polyPatch& pp : mesh().boundaryMesh())
    {
        patches[pp.name()] =
            pp.coupled() || pp.type() == "empty"
          ? "type " + pp.type() + "; value uniform 0;"
          : "type zeroGradient;";
    }

    writeField
    (
        name,
        "volScalarField",
        dimensions,
        values.str(),
        patches,
        folder
    );
}
