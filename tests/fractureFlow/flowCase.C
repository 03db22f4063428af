/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowCase.H"
#include "clayProperties.H"
#include "fvcSurfaceIntegrate.H"
#include "IStringStream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "processorPolyPatch.H"
#include "surfaceFields.H"
#include "zeroGradientFvPatchFields.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

using namespace Foam;


dictionary dictionaryOf(const string& text)
{
    IStringStream is(text);
    return dictionary(is);
}


scalar fractionOfViscosity(const scalar relativeViscosity)
{
    const colloid::clayProperties properties
    (
        dictionaryOf("water { concentration 0.1; }")
    );
    const auto law = properties.viscosity(properties.waterAt(0));

    // Bisection in the logarithm
    scalar low = 1e-12;
    scalar high = 1;
    for (int i = 0; i < 100; ++i)
    {
        const scalar middle = std::sqrt(low*high);
        (law.uncappedViscosity(middle) < relativeViscosity ? low : high) =
            middle;
    }

    return relativeViscosity == 1 ? 0 : low;
}


string messageOf(const std::function<void()>& call)
{
    try
    {
        call();
    }
    catch (const IOerror& err)
    {
        return err.message() + err.ioFileName();
    }
    catch (const error& err)
    {
        return err.message();
    }
    return "";
}


bool mentions(const string& text, const std::vector<string>& parts)
{
    for (const string& part : parts)
    {
        if (text.find(part) == std::string::npos)
        {
            Info<< "'" << text << "' does not mention '" << part << "'" << endl;
            return false;
        }
    }
    return true;
}


scalar relativeDivergence(const fractureFlow& flow)
{
    const scalarField gain
    (
        flow.mesh().V()
       *fvc::surfaceIntegrate(flow.phi())().primitiveField()
    );

    return gMax(mag(gain)())/gMax(mag(flow.phi())().primitiveField());
}


void flowCase::writeFile(const fileName& name, const string& text) const
{
    if (!Pstream::master())
    {
        return;
    }

    mkDir((folder_/name).path());
    OFstream os(folder_/name);
    os  << "FoamFile { version 2.0; format ascii; class dictionary; object "
        << name.name().c_str() << "; }\n" << text.c_str() << endl;
}


namespace
{

//- A face of the whole box: its cells, -1 for outside, and patch
struct boxFace
{
    face points;
    label owner;
    label neighbour;
    label side;
};

//- Numbers of points, cells and faces of the whole box
struct boxNumbering
{
    std::array<label, 3> n;

    label cell(label i, label j, label k) const
    {
        return i + n[0]*(j + n[1]*k);
    }

    label point(label i, label j, label k) const
    {
        return i + (n[0] + 1)*(j + (n[1] + 1)*k);
    }

    //- The face of a cell towards the axis' positive side
    face upperFace(label axis, std::array<label, 3> at) const
    {
        ++at[axis];
        const label second = (axis + 1) % 3;
        const label third = (axis + 2) % 3;

        face result(4);
        for (label corner = 0; corner < 4; ++corner)
        {
            std::array<label, 3> p = at;
            p[second] += corner == 1 || corner == 2;
            p[third] += corner == 2 || corner == 3;
            result[corner] = point(p[0], p[1], p[2]);
        }
        return result;
    }
};

//- Internal faces in OpenFOAM's order, then those of each patch
std::vector<boxFace> facesOf(const boxSpec& spec)
{
    const boxNumbering box{spec.cells};
    const auto& n = spec.cells;
    std::vector<boxFace> faces;

    for (label k = 0; k < n[2]; ++k)
    for (label j = 0; j < n[1]; ++j)
    for (label i = 0; i < n[0]; ++i)
    {
        for (label axis = 0; axis < 3; ++axis)
        {
            std::array<label, 3> next{i, j, k};
            if (++next[axis] < n[axis])
            {
                faces.push_back
                ({
                    box.upperFace(axis, {i, j, k}),
                    box.cell(i, j, k),
                    box.cell(next[0], next[1], next[2]),
                    -1
                });
            }
        }
    }

    // Sides of one patch follow each other
    for (label first = 0; first < 6; ++first)
    for (label side = first; side < 6; ++side)
    {
        const auto earlier = spec.patches.begin() + first;
        if
        (
            spec.patches[side] != *earlier
         || std::find(spec.patches.begin(), earlier, *earlier) != earlier
        )
        {
            continue;
        }

        const label axis = side/2;
        const bool upper = side % 2;

        for (label k = 0; k < n[2]; ++k)
        for (label j = 0; j < n[1]; ++j)
        for (label i = 0; i < n[0]; ++i)
        {
            std::array<label, 3> at{i, j, k};
            if (at[axis] == (upper ? n[axis] - 1 : 0))
            {
                at[axis] -= upper ? 0 : 1;
                const face f(box.upperFace(axis, at));

                faces.push_back
                ({
                    upper ? f : f.reverseFace(),
                    box.cell(i, j, k),
                    -1,
                    side
                });
            }
        }
    }

    return faces;
}

//- The rank of each cell of the box: halves or quarters, but not across
//  cyclic patches
std::vector<label> ranksOf(const boxSpec& spec)
{
    const boxNumbering box{spec.cells};
    const auto& n = spec.cells;
    std::vector<label> ranks(n[0]*n[1]*n[2], 0);

    std::array<label, 3> parts{1, 1, 1};
    label left = Pstream::parRun() ? Pstream::nProcs() : 1;
    for (label axis = 1; left > 1; axis = (axis + 2) % 3)
    {
        if (spec.types[2*axis] != "cyclic" && n[axis] >= 2*parts[axis])
        {
            parts[axis] *= 2;
            left /= 2;
        }
    }

    for (label k = 0; k < n[2]; ++k)
    for (label j = 0; j < n[1]; ++j)
    for (label i = 0; i < n[0]; ++i)
    {
        ranks[box.cell(i, j, k)] =
            i*parts[0]/n[0]
          + parts[0]*(j*parts[1]/n[1] + parts[1]*(k*parts[2]/n[2]));
    }

    return ranks;
}

} // End namespace


void flowCase::makeMesh(const boxSpec& spec)
{
    const boxNumbering box{spec.cells};
    const auto& n = spec.cells;
    const std::vector<boxFace> boxFaces(facesOf(spec));
    const std::vector<label> ranks(ranksOf(spec));
    const label me = Pstream::parRun() ? Pstream::myProcNo() : 0;

    labelList localCell(ranks.size(), -1);
    label nCells = 0;
    forAll(localCell, celli)
    {
        if (ranks[celli] == me)
        {
            localCell[celli] = nCells++;
        }
    }

    // Points that a rank has no cell at stay in its list; nobody minds
    pointField points(box.point(n[0], n[1], n[2]) + 1);
    for (label k = 0; k <= n[2]; ++k)
    for (label j = 0; j <= n[1]; ++j)
    for (label i = 0; i <= n[0]; ++i)
    {
        const vector unit
        (
            scalar(i)/n[0],
            scalar(j)/n[1],
            scalar(k)/n[2]
        );
        points[box.point(i, j, k)] = cmptMultiply(spec.size, spec.map(unit));
    }

    DynamicList<face> faces;
    DynamicList<label> owner;
    DynamicList<label> neighbour;

    for (const boxFace& f : boxFaces)
    {
        if
        (
            f.neighbour != -1
         && localCell[f.owner] != -1
         && localCell[f.neighbour] != -1
        )
        {
            faces.append(f.points);
            owner.append(localCell[f.owner]);
            neighbour.append(localCell[f.neighbour]);
        }
    }

    DynamicList<dictionary> patchDicts;
    const auto addPatch = [&](const word& name, dictionary dict, label start)
    {
        dict.add("name", name);
        dict.add("nFaces", faces.size() - start);
        dict.add("startFace", start);
        patchDicts.append(dict);
    };

    const auto nameOf = [&](const boxFace& f) -> const word&
    {
        const bool later =
            f.side == 2 && spec.laterBottom.size()
         && f.owner % n[0] >= spec.laterColumn;

        return later ? spec.laterBottom : spec.patches[f.side];
    };

    const label names = spec.laterBottom.empty() ? 6 : 7;
    for (label number = 0; number < names; ++number)
    {
        const label first = number < 6 ? number : 2;
        const word& name =
            number < 6 ? spec.patches[number] : spec.laterBottom;
        const auto begin = spec.patches.begin();
        if
        (
            number < 6
         && std::find(begin, begin + number, name) != begin + number
        )
        {
            continue;
        }

        const label start = faces.size();
        for (const boxFace& f : boxFaces)
        {
            if
            (
                f.side != -1
             && nameOf(f) == name
             && localCell[f.owner] != -1
            )
            {
                faces.append(f.points);
                owner.append(localCell[f.owner]);
            }
        }

        dictionary dict;
        dict.add("type", spec.types[first]);
        if (spec.types[first] == "cyclic")
        {
            dict.add("neighbourPatch", spec.patches[first ^ 1]);
        }
        addPatch(name, dict, start);
    }

    const label nRanks = Pstream::parRun() ? Pstream::nProcs() : 1;
    for (label other = 0; other < nRanks; ++other)
    {
        const label start = faces.size();
        for (const boxFace& f : boxFaces)
        {
            if (f.neighbour == -1)
            {
                continue;
            }
            if (ranks[f.owner] == me && ranks[f.neighbour] == other)
            {
                if (other != me)
                {
                    faces.append(f.points);
                    owner.append(localCell[f.owner]);
                }
            }
            else if (ranks[f.owner] == other && ranks[f.neighbour] == me)
            {
                faces.append(f.points.reverseFace());
                owner.append(localCell[f.neighbour]);
            }
        }

        if (faces.size() > start)
        {
            dictionary dict;
            dict.add("type", "processor");
            dict.add("myProcNo", me);
            dict.add("neighbProcNo", other);
            addPatch(processorPolyPatch::newName(me, other), dict, start);
        }
    }

    faceList allFaces(faces);
    labelList allOwner(owner);
    labelList allNeighbour(neighbour);

    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                polyMesh::defaultRegion,
                time_->timeName(),
                time_(),
                IOobject::READ_IF_PRESENT
            ),
            std::move(points),
            std::move(allFaces),
            std::move(allOwner),
            std::move(allNeighbour),
            false
        )
    );

    List<polyPatch*> patches(patchDicts.size());
    forAll(patches, i)
    {
        patches[i] = polyPatch::New
        (
            patchDicts[i].get<word>("name"),
            patchDicts[i],
            i,
            mesh_->boundaryMesh()
        ).ptr();
    }
    mesh_->addFvPatches(patches);
}


flowCase::flowCase(const boxSpec& spec)
{
    if (Pstream::master())
    {
        std::string name
        (
            std::filesystem::temp_directory_path()/"flowCaseXXXXXX"
        );
        folder_ = mkdtemp(name.data());
    }
    Pstream::scatter(folder_);

    if (Pstream::parRun())
    {
        processor_ = "processor" + Foam::name(Pstream::myProcNo());
        mkDir(folder_/processor_);
    }

    writeFile
    (
        "system/controlDict",
        "startFrom startTime; startTime 0; stopAt endTime; endTime 10;"
        "deltaT 1; writeControl timeStep; writeInterval 1; writePrecision 16;"
    );
    writeFile
    (
        "system/fvSchemes",
        "gradSchemes { default Gauss linear; } divSchemes { default none;"
        "div(phi,U) Gauss linear; }"
        "ddtSchemes { default backward; }"
        "laplacianSchemes { default none;"
        "\"laplacian\\((nu,U|rAU,p)\\)\" Gauss linear corrected; }"
        "interpolationSchemes { default linear; }"
        "snGradSchemes { default corrected; }"
    );
    writeFile("system/fvSolution", spec.solution);
    writeClayProperties
    (
        "water { concentration 0.1; } viscosity { gelStop off; }"
    );

    // Files of one rank that others read are there
    label written = 1;
    reduce(written, sumOp<label>());

    time_.reset
    (
        new Time
        (
            word(Time::controlDictName),
            folder_.path(),
            folder_.name()/processor_,
            word("system"),
            word("constant")    // left out, v2306 takes another constructor
        )
    );
    makeMesh(spec);

    alpha_.reset
    (
        new volScalarField
        (
            IOobject("alpha.clay", time_->timeName(), mesh_()),
            mesh_(),
            dimensionedScalar(dimless, Zero),
            zeroGradientFvPatchScalarField::typeName
        )
    );
}


flowCase::~flowCase()
{
    alpha_.clear();
    mesh_.clear();
    time_.clear();

    // Other ranks may still read
    label done = 1;
    reduce(done, sumOp<label>());

    if (Pstream::master())
    {
        rmDir(folder_);
    }
}


void flowCase::setViscosity
(
    const std::function<scalar(const vector&)>& ratio
)
{
    forAll(alpha_(), celli)
    {
        alpha_()[celli] = fractionOfViscosity(ratio(mesh_->C()[celli]));
    }
    alpha_->correctBoundaryConditions();
}


void flowCase::writeClayProperties(const string& body) const
{
    writeFile("constant/clayProperties", body);
}


void flowCase::writeField
(
    const word& name,
    const word& fieldClass,
    const word& dimensions,
    const string& internal,
    const std::map<word, string>& patches,
    const word& timeName
) const
{
    const fileName folder(folder_/processor_/timeName);
    mkDir(folder);
    OFstream os(folder/name);
    os  << "FoamFile { version 2.0; format ascii; class "
        << fieldClass << "; object " << name << "; }" << nl
        << "dimensions " << dimensions.c_str() << ";" << nl
        << "internalField " << internal.c_str() << ";" << nl
        << "boundaryField {" << nl;

    for (const polyPatch& pp : mesh_->boundaryMesh())
    {
        const auto found = patches.find(pp.name());

        os  << pp.name() << " { "
            << (
                found == patches.end()
              ? string("type " + pp.type() + "; value " + internal + ";")
              : found->second
               ).c_str()
            << " }" << nl;
    }
    os  << "}" << endl;
}


void flowCase::writeU(const std::map<word, string>& patches) const
{
    writeField
    (
        "U", "volVectorField", "[0 1 -1 0 0 0 0]", "uniform (0 0 0)", patches
    );
}


void flowCase::writeP(const std::map<word, string>& patches) const
{
    writeField
    (
        "p", "volScalarField", "[0 2 -2 0 0 0 0]", "uniform 0", patches
    );
}


dictionary& flowCase::controls(const word& model)
{
    return
        const_cast<dictionary&>(mesh_->solutionDict()).subDictOrAdd(model);
}


autoPtr<fractureFlow> flowCase::newFlow(const string& properties)
{
    return fractureFlow::New(mesh_(), alpha_(), dictionaryOf(properties));
}
