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
#include "physicalConstants.H"
#include "surfaceFields.H"

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

using Foam::colloid::physicalConstants::year;


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

Foam::functionObjects::runFunction::requirements
Foam::functionObjects::rimErosion::needs()
{
    return
    {
        {"source", "fractions", "bracket"},
        "erosionFoam",
        {"alpha.clay", "alphaPhi", "apertureRatio", "U"},
        "",
        true
    };
}


void Foam::functionObjects::rimErosion::readBracket(const dictionary& dict)
{
    edge_.clear();

    if (!dict.found("bracket"))
    {
        return;
    }
    const dictionary& bracket = dict.subDict("bracket");

    wordList words(erosionBracket::edge::words());
    words.append(fieldEntries::fractionWords());
    colloid::checkWords(bracket, words);

    edge_.reset
    (
        new erosionBracket::edge
        (
            erosionBracket::edge::of
            (
                bracket,
                colloid::clayProperties
                (
                    constantDictionary(mesh_, "clayProperties")
                ).waterAt(time_.value())
            )
        )
    );
    edgeFraction_ = fieldEntries::solidFraction(bracket);
}


Foam::scalar Foam::functionObjects::rimErosion::concentrationAtSource() const
{
    const auto& c = lookupObject<volScalarField>("c");

    scalar weighted = 0;
    scalar size = 0;

    if (sourcePatch_ >= 0)
    {
        const scalarField& area = mesh_.magSf().boundaryField()[sourcePatch_];
        weighted = sum(area*c.boundaryField()[sourcePatch_]);
        size = sum(area);
    }
    else
    {
        // Of a plug smaller than a cell that which is nearest
        const scalar within =
            max(gMin(distance_->primitiveField()), scalar(0));

        forAll(c, celli)
        {
            if (distance_()[celli] <= within)
            {
                weighted += mesh_.V()[celli]*c[celli];
                size += mesh_.V()[celli];
            }
        }
    }
    reduce(weighted, sumOp<scalar>());
    reduce(size, sumOp<scalar>());

    return weighted/size;
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


void Foam::functionObjects::rimErosion::keep() const
{
    if (time_.writeTime() && !steady())
    {
        HashTable<scalarList> lists;
        lists.set("masses", scalarList({eroded_, supplied_}));
        lists.set
        (
            "volumes",
            scalarList({volumeEroded_, volumeSupplied_, volumeAtStart_})
        );
        keptNumbers(time_, name(), lists, source_).save();
    }
}


bool Foam::functionObjects::rimErosion::restore()
{
    const keptNumbers kept(time_, name(), source_);
    const scalarList masses(kept.lists.lookup("masses", scalarList()));
    const scalarList volumes(kept.lists.lookup("volumes", scalarList()));

    if (masses.size() >= 2)
    {
        eroded_ = masses[0];
        supplied_ = masses[1];
    }
    if (volumes.size() == 3)
    {
        volumeEroded_ = volumes[0];
        volumeSupplied_ = volumes[1];
        volumeAtStart_ = volumes[2];
    }
    else if (masses.size() == 3)
    {
        // Older versions had the masses only
        volumeEroded_ = masses[0]/density_;
        volumeSupplied_ = masses[1]/density_;
        volumeAtStart_ = masses[2]/density_;
    }
    else
    {
        return false;
    }
    return true;
}


Foam::scalar Foam::functionObjects::rimErosion::waterSpeed() const
{
    const auto& alpha = lookupObject<volScalarField>("alpha.clay");
    const auto& aperture = lookupObject<volScalarField>("apertureRatio");
    const auto& U = lookupObject<volVectorField>("U");

    scalar flow = 0;
    scalar volume = 0;
    forAll(alpha, celli)
    {
        if (alpha[celli] < 0.01*edgeFraction_)
        {
            const scalar V = mesh_.V()[celli]*aperture[celli];
            flow += V*mag(U[celli]);
            volume += V;
        }
    }
    reduce(flow, sumOp<scalar>());
    reduce(volume, sumOp<scalar>());

    return volume > 0 ? flow/volume : -1;
}


void Foam::functionObjects::rimErosion::writeBracket() const
{
    const colloid::clayProperties matter
    (
        constantDictionary(mesh_, "clayProperties")
    );
    colloid::water solution(matter.waterAt(time_.value()));
    const bool salted = foundObject<volScalarField>("c");

    if (salted)
    {
        solution.concentration = concentrationAtSource();
    }
    Info<< nl << "At " << solution.concentration << " mol/m3, "
        << (salted ? "the mean at the source now" : "as in clayProperties")
        << endl;

    const auto model = fractionDiffusivity::New
    (
        constantDictionary(mesh_, "erosionProperties").subDict("diffusivity"),
        matter
    );
    const auto D = model->at(solution);

    const erosionBracket bracket
    (
        erosionBracket::matter::of
        (
            [&](const scalar alpha) { return D->value(alpha); },
            D->value(0),
            matter.viscosity(solution)
        ),
        edgeFraction_
    );
    bracket.write(Info, edge_(), density_);

    const scalar u0 = edge_().velocity;
    const scalar speed = waterSpeed();

    Info<< "This run: " << leaving(false)*year << " kg/a";
    if (speed >= 0)
    {
        Info<< ", water without clay flows at " << speed << " m/s in the mean";
    }
    Info<< nl << endl;

    if (speed >= 0 && (speed > 5*u0 || speed < u0/5))
    {
        WarningInFunction
            << "The bracket is not of the water of this run: its velocity is "
            << u0 << " m/s," << nl << "    that of the run "
            << speed << " m/s in the mean where there is no clay" << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::rimErosion::rimErosion
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    runFunction(name, runTime, dict, needs()),
    runTable(mesh_, name),
    sourcePatch_(-1),
    edgeFraction_(0),
    density_
    (
        colloid::clayProperties
        (
            constantDictionary(mesh_, "clayProperties")
        ).clay().density
    ),
    eroded_(0),
    supplied_(0),
    volumeEroded_(0),
    volumeSupplied_(0),
    volumeAtStart_(-1)
{
    read(dict);

    if (!postProcess)
    {
        if (!steady())
        {
            restore();
        }
        if (volumeAtStart_ < 0)
        {
            volumeAtStart_ = clayBeyond(-GREAT)/density_;
        }
    }
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::functionObjects::rimErosion::writeHeading(Ostream& os) const
{
    writeHeader(os, "Clay that is lost, and how far it has come");
    writeCommented(os, "Time");
    for
    (
        const char* column :
        {
            "erosion[kg/s]", "erosion[kg/a]", "erosion[mg/h]", "supply[kg/s]",
            "eroded[kg]", "extruded[kg]", "clay[kg]", "imbalance[-]"
        }
    )
    {
        writeTabbed(os, column);
    }
    for (const scalar fraction : fractions_)
    {
        const word at(Foam::name(fraction));
        writeTabbed(os, "farthest(" + at + ")[m]");
        writeTabbed(os, "mean(" + at + ")[m]");
    }
    os  << nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::rimErosion::read(const dictionary& dict)
{
    runFunction::read(dict);
    runTable::read(dict);

    readSource(dict);
    readBracket(dict);
    fractions_ = dict.getOrDefault<scalarList>("fractions", scalarList());

    return true;
}


bool Foam::functionObjects::rimErosion::execute()
{
    if (postProcess)
    {
        return true;
    }
    begin();

    const scalar deltaT = steady() ? 0 : time_.deltaTValue();

    const scalar eroded = deltaT*leaving(false);
    const scalar supplied = -deltaT*leaving(true);

    eroded_ += eroded;
    supplied_ += supplied;
    volumeEroded_ += eroded/density_;
    volumeSupplied_ += supplied/density_;
    keep();

    return true;
}


bool Foam::functionObjects::rimErosion::write()
{
    if (!ready())
    {
        return true;
    }

    // Of an old time, what the run had added up until then
    const bool known = !postProcess || steady() || restore();

    const scalar rate = leaving(false);
    const scalar supply = -leaving(true);
    const scalar clay = clayBeyond(-GREAT);
    const scalar imbalance =
        steady()
      ? (supply - rate)/max(max(mag(supply), mag(rate)), VSMALL)
      : (clay/density_ - volumeAtStart_ - volumeSupplied_ + volumeEroded_)
       /max(max(volumeAtStart_, mag(volumeSupplied_)), VSMALL);
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
        Ostream& os = rows();
        const auto orNan = [&os](const bool is, const scalar value)
        {
            os  << tab;
            is ? os << value : os << "nan";
        };

        writeTime(os);
        os  << tab << rate << tab << rate*year << tab << rate*1e6*3600
            << tab << supply;
        orNan(known, eroded_);
        os  << tab << extruded << tab << clay;
        orNan(known, imbalance);
        for (const scalar at : fronts)
        {
            orNan(at != noFront, at);
        }
        os  << nl;
    }
    endRows();
    return true;
}


bool Foam::functionObjects::rimErosion::end()
{
    if (!hasNow())
    {
        write();
    }
    if (edge_.valid() && ready())
    {
        writeBracket();
    }
    return true;
}
