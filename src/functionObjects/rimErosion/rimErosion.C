/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimErosion.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "erosionBracket.H"
#include "fieldEntries.H"
#include "fractionDiffusivity.H"
#include "keptNumbers.H"
#include "readInRange.H"
#include "surfaceFields.H"
#include "wallDist.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(rimErosion, 0);
    addToRunTimeSelectionTable(functionObject, rimErosion, dictionary);
}
}

namespace
{

constexpr Foam::scalar year = 31557600;


//- A dictionary in constant/
Foam::IOdictionary constantDictionary
(
    const Foam::fvMesh& mesh,
    const Foam::word& name
)
{
    return Foam::IOdictionary
    (
        Foam::IOobject
        (
            name,
            mesh.time().constant(),
            mesh.time(),
            Foam::IOobject::MUST_READ,
            Foam::IOobject::NO_WRITE,
            false
        )
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::rimErosion::readSource(const dictionary& dict)
{
    const dictionary& source = dict.subDict("source");
    colloid::checkWords(source, wordList({"patch", "centre", "radius"}));

    sourcePatch_ = -1;

    if (source.found("patch") == source.found("centre"))
    {
        FatalIOErrorInFunction(source)
            << "The source is a patch { patch <name>; } or a plug"
            << " { centre <point>; radius <length>; }" << exit(FatalIOError);
    }

    if (source.found("centre"))
    {
        const vector centre(source.get<vector>("centre"));
        const scalar radius = colloid::readInRange
        (
            source, "radius", 0, GREAT, "m"
        );

        distance_.reset
        (
            new volScalarField
            (
                IOobject("distance", time_.timeName(), mesh_),
                mesh_,
                dimensionedScalar(dimLength, Zero)
            )
        );
        const auto fromEdge = [&](vector offset)
        {
            for (direction axis = 0; axis < 3; ++axis)
            {
                if (mesh_.solutionD()[axis] < 0)
                {
                    offset[axis] = 0;
                }
            }
            return mag(offset) - radius;
        };
        forAll(mesh_.C(), celli)
        {
            distance_()[celli] = fromEdge(mesh_.C()[celli] - centre);
        }
        distance_->correctBoundaryConditions();
        return;
    }

    const word patch(source.get<word>("patch"));
    sourcePatch_ = mesh_.boundaryMesh().findPatchID(patch);

    if (sourcePatch_ < 0)
    {
        colloid::checkChoice
        (
            source, "patch", patch, mesh_.boundaryMesh().names()
        );
    }
    const wallDist fromPatch
    (
        mesh_, "meshWave", labelHashSet({sourcePatch_}), "source"
    );
    distance_.reset(new volScalarField("distance", fromPatch.y()));
}


void Foam::functionObjects::rimErosion::readBracket(const dictionary& dict)
{
    bracket_ = dict.subOrEmptyDict("bracket");

    if (bracket_.empty())
    {
        return;
    }

    wordList words({"velocity", "length", "radius"});
    words.append(fieldEntries::fractionWords());
    words.append(fieldEntries::apertureWords());
    colloid::checkWords(bracket_, words);

    if (bracket_.found("length") == bracket_.found("radius"))
    {
        FatalIOErrorInFunction(bracket_)
            << "The edge is straight, with a length, or round, with a radius"
            << exit(FatalIOError);
    }
}


bool Foam::functionObjects::rimErosion::steady() const
{
    return word(mesh_.ddtScheme("ddt(alpha.clay)")) == "steadyState";
}


Foam::scalar Foam::functionObjects::rimErosion::clayBeyond
(
    const scalar distance
) const
{
    const auto& alpha = lookupObject<volScalarField>("alpha.clay");
    const auto& aperture = lookupObject<volScalarField>("apertureRatio");

    scalar sum = 0;
    forAll(alpha, celli)
    {
        if (distance_()[celli] >= distance)
        {
            sum += mesh_.V()[celli]*aperture[celli]*alpha[celli];
        }
    }
    return density_*returnReduce(sum, sumOp<scalar>());
}


Foam::scalar Foam::functionObjects::rimErosion::leaving
(
    const bool source
) const
{
    const auto& alphaPhi = lookupObject<surfaceScalarField>("alphaPhi");

    scalar rate = 0;
    forAll(alphaPhi.boundaryField(), patchi)
    {
        if
        (
            !mesh_.boundary()[patchi].coupled()
         && (patchi == sourcePatch_) == source
        )
        {
            rate += sum(alphaPhi.boundaryField()[patchi]);
        }
    }
    return density_*returnReduce(rate, sumOp<scalar>());
}


Foam::Tuple2<Foam::scalar, Foam::scalar>
Foam::functionObjects::rimErosion::front(const scalar fraction) const
{
    const auto& alpha = lookupObject<volScalarField>("alpha.clay");
    const volScalarField& distance = distance_();

    scalar farthest = 0;
    scalar weighted = 0;
    scalar area = 0;

    const auto add =
    [&](
        const scalar alphaHere,
        const scalar alphaThere,
        const scalar here,
        const scalar there,
        const scalar faceArea
    )
    {
        if ((alphaHere > fraction) != (alphaThere > fraction))
        {
            const scalar at =
                here
              + (there - here)*(alphaHere - fraction)/(alphaHere - alphaThere);

            farthest = max(farthest, at);
            weighted += faceArea*at;
            area += faceArea;
        }
    };

    forAll(mesh_.owner(), facei)
    {
        const label o = mesh_.owner()[facei];
        const label n = mesh_.neighbour()[facei];

        add
        (
            alpha[o], alpha[n], distance[o], distance[n],
            mesh_.magSf()[facei]
        );
    }
    forAll(alpha.boundaryField(), patchi)
    {
        const auto& patch = alpha.boundaryField()[patchi];

        if (!patch.coupled())
        {
            continue;
        }
        // Seen from both sides
        const scalarField here(patch.patchInternalField());
        const scalarField there(patch.patchNeighbourField());
        const auto& patchDistance = distance.boundaryField()[patchi];
        const scalarField from(patchDistance.patchInternalField());
        const scalarField to(patchDistance.patchNeighbourField());

        forAll(here, i)
        {
            add
            (
                here[i], there[i], from[i], to[i],
                0.5*mesh_.magSf().boundaryField()[patchi][i]
            );
        }
    }

    reduce(farthest, maxOp<scalar>());
    reduce(weighted, sumOp<scalar>());
    reduce(area, sumOp<scalar>());

    return {farthest, area > 0 ? weighted/area : 0};
}


void Foam::functionObjects::rimErosion::keep() const
{
    if (time_.writeTime() && !steady())
    {
        HashTable<scalarList> lists;
        lists.set
        (
            "masses", scalarList({eroded_, supplied_, clayAtStart_})
        );
        keptNumbers(time_, name(), lists).save();
    }
}


void Foam::functionObjects::rimErosion::restore()
{
    const keptNumbers kept(time_, name());
    const auto found = kept.lists.cfind("masses");

    if (found.found() && (*found).size() == 3)
    {
        eroded_ = (*found)[0];
        supplied_ = (*found)[1];
        clayAtStart_ = (*found)[2];
    }
}


void Foam::functionObjects::rimErosion::writeBracket() const
{
    const colloid::clayProperties matter
    (
        constantDictionary(mesh_, "clayProperties")
    );
    const colloid::water solution(matter.waterAt(time_.value()));
    const auto model = fractionDiffusivity::New
    (
        constantDictionary(mesh_, "erosionProperties").subDict("diffusivity"),
        matter
    );
    const auto D = model->at(solution);

    const scalar aperture = fieldEntries::aperture(bracket_, solution);
    const scalar velocity = colloid::readInRange
    (
        bracket_, "velocity", 1e-12, 1, "m/s"
    );
    const auto lengthOf = [&](const word& keyword)
    {
        return colloid::readInRange(bracket_, keyword, 1e-9, 1e6, "m");
    };
    const erosionBracket::edge edge
    (
        bracket_.found("radius")
      ? erosionBracket::edge::around(lengthOf("radius"), aperture, velocity)
      : erosionBracket::edge::straight(lengthOf("length"), aperture, velocity)
    );

    const erosionBracket bracket
    (
        erosionBracket::matter::of
        (
            [&](const scalar alpha) { return D->value(alpha); },
            D->value(0),
            matter.viscosity(solution)
        ),
        fieldEntries::solidFraction(bracket_)
    );
    bracket.write(Info, edge, density_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::rimErosion::rimErosion
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, name, dict),
    sourcePatch_(-1),
    density_
    (
        colloid::clayProperties
        (
            constantDictionary(mesh_, "clayProperties")
        ).clay().density
    ),
    eroded_(0),
    supplied_(0),
    clayAtStart_(-1)
{
    read(dict);
    restore();

    if (clayAtStart_ < 0 && foundObject<volScalarField>("alpha.clay"))
    {
        clayAtStart_ = clayBeyond(-GREAT);
    }

    writeHeader(file(), "Clay that is lost, and how far it has come");
    writeCommented(file(), "Time");
    for
    (
        const char* column :
        {
            "erosion[kg/s]", "erosion[kg/a]", "erosion[mg/h]", "supply[kg/s]",
            "eroded[kg]", "extruded[kg]", "clay[kg]", "imbalance[-]"
        }
    )
    {
        writeTabbed(file(), column);
    }
    for (const scalar fraction : fractions_)
    {
        const word at(Foam::name(fraction));
        writeTabbed(file(), "farthest(" + at + ")[m]");
        writeTabbed(file(), "mean(" + at + ")[m]");
    }
    file() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::rimErosion::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    readSource(dict);
    readBracket(dict);
    fractions_ = dict.getOrDefault<scalarList>("fractions", scalarList());

    return true;
}


bool Foam::functionObjects::rimErosion::execute()
{
    const scalar deltaT = steady() ? 0 : time_.deltaTValue();

    eroded_ += deltaT*leaving(false);
    supplied_ -= deltaT*leaving(true);
    keep();

    return true;
}


bool Foam::functionObjects::rimErosion::write()
{
    const scalar rate = leaving(false);
    const scalar supply = -leaving(true);
    const scalar clay = clayBeyond(-GREAT);
    const scalar imbalance =
        steady()
      ? (supply - rate)/max(mag(supply), VSMALL)
      : (clay - clayAtStart_ - supplied_ + eroded_)
       /max(max(clayAtStart_, mag(supplied_)), VSMALL);
    const scalar extruded = clayBeyond(0);

    DynamicList<scalar> fronts;
    for (const scalar fraction : fractions_)
    {
        const auto at = front(fraction);
        fronts.append(at.first());
        fronts.append(at.second());
    }

    Log << type() << ' ' << name() << ": erosion " << rate << " kg/s, "
        << rate*year << " kg/a; imbalance " << imbalance << endl;

    if (Pstream::master())
    {
        OFstream& os = file();
        os  << time_.value()
            << tab << rate << tab << rate*year << tab << rate*1e6*3600
            << tab << supply << tab << eroded_ << tab << extruded
            << tab << clay << tab << imbalance;
        for (const scalar at : fronts)
        {
            os  << tab << at;
        }
        os  << endl;
    }
    return true;
}


bool Foam::functionObjects::rimErosion::end()
{
    if (!bracket_.empty())
    {
        writeBracket();
    }
    return true;
}
