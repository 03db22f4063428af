/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clayDiffusivity.H"
#include "addToRunTimeSelectionTable.H"
#include "checkWords.H"
#include "readInRange.H"
#include "volFields.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(clayDiffusivity, 0);
    addToRunTimeSelectionTable(functionObject, clayDiffusivity, dictionary);
}
}

namespace
{

using namespace Foam;

const wordList methodNames({"pointwise", "leastSquares", "equilibrium"});

//- The table with the first three columns of the first method
const word commonTable("diffusivity");

//- Change of the salt's concentration from which on another equilibrium counts
constexpr scalar otherWater = 0.01;

} // End anonymous namespace


Foam::functionObjects::runFunction::requirements
Foam::functionObjects::clayDiffusivity::needs()
{
    return
    {
        {
            "methods", "fractions", "bins", "spacing", "margin", "pieces",
            "equilibrium"
        },
        "clayFoam",
        {"clay", "alpha.clay", "U.clay", "U"},
        "the law of force and friction is that of the run's platelets",
        false
    };
}


Foam::functionObjects::clayDiffusivity::clayDiffusivity
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    runFunction(name, runTime, dict, needs()),
    runTable(mesh_, name),
    margin_(-1),
    wantedPieces_(label(0)),
    axes_(mesh_),
    gradient_(mesh_, axes_),
    concentration_(0)
{
    read(dict);

    if (!idle() && (has("pointwise") || has("leastSquares")))
    {
        kept_.reset(new keptNumbers(runTime, name, water()));
    }
}


const Foam::clayCloud& Foam::functionObjects::clayDiffusivity::cloud() const
{
    return mesh_.lookupObject<clayCloud>("clay");
}


Foam::dictionary Foam::functionObjects::clayDiffusivity::water() const
{
    dictionary made;
    if (mesh_.foundObject<clayCloud>("clay"))
    {
        made.add
        (
            "concentration",
            cloud().matter().waterAt(time_.value()).concentration
        );
    }
    return made;
}


bool Foam::functionObjects::clayDiffusivity::has(const word& method) const
{
    return methods_.found(method);
}


bool Foam::functionObjects::clayDiffusivity::read(const dictionary& dict)
{
    runFunction::read(dict);
    runTable::read(dict);

    methods_ = dict.get<wordList>("methods");
    for (const word& method : methods_)
    {
        colloid::checkChoice(dict, "methods", method, methodNames);
    }
    if (methods_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No methods; there are " << flatOutput(methodNames)
            << exit(FatalIOError);
    }

    const FixedList<scalar, 2> fractions
    (
        dict.get<FixedList<scalar, 2>>("fractions")
    );
    const scalar most = fractions[1];

    if (!(fractions[0] > 0 && fractions[0] < most && most <= 0.5))
    {
        FatalIOErrorInFunction(dict)
            << "fractions are " << flatOutput(fractions) << "; they should be"
            << " two between 0 and 0.5, the lower one first"
            << exit(FatalIOError);
    }

    const word spacing(dict.getOrDefault<word>("spacing", "logarithmic"));
    colloid::checkChoice
    (
        dict, "spacing", spacing, wordList({"logarithmic", "linear"})
    );
    bins_.reset
    (
        new fractionBins
        (
            fractions[0],
            fractions[1],
            dict.getCheck<label>
            (
                "bins", [](label n) { return n > 0 && n <= 1000; }
            ),
            spacing == "logarithmic"
        )
    );

    margin_ =
        colloid::numberOrWord(dict, "margin", "auto", 0, 1e3, "m").value_or(-1);

    wantedPieces_ = label(0);
    if (dict.found("pieces") && dict.lookup("pieces").first().isWord())
    {
        colloid::checkChoice
        (
            dict, "pieces", dict.get<word>("pieces"), wordList({"auto"})
        );
    }
    else if (dict.found("pieces"))
    {
        wantedPieces_ = dict.get<FixedList<label, 3>>("pieces");
        if (min(min(wantedPieces_[0], wantedPieces_[1]), wantedPieces_[2]) < 1)
        {
            FatalIOErrorInFunction(dict)
                << "pieces are " << flatOutput(wantedPieces_)
                << "; along each axis there is at least one, such as (4 4 1)"
                << exit(FatalIOError);
        }
    }

    equilibrium_.reset
    (
        new osmoticDiffusivity(dict.subOrEmptyDict("equilibrium"))
    );

    fits_.clear();
    concentration_ = 0;
    return true;
}


void Foam::functionObjects::clayDiffusivity::begin()
{
    const scalar filterLength = cloud().interactions().filterLength();

    pieces_.reset
    (
        new meshPieces
        (
            mesh_,
            axes_,
            wantedPieces_,
            2*filterLength,
            margin_ < 0 ? filterLength : margin_
        )
    );

    for (const word& method : methods_)
    {
        if (method != "equilibrium")
        {
            fits_.set
            (
                method,
                new fluxFit
                (
                    *bins_,
                    pieces_->size(),
                    method == "pointwise"
                  ? fluxFit::weighting::pointwise
                  : fluxFit::weighting::leastSquares
                )
            );
        }
    }

    if (kept_.valid())
    {
        forAllIters(fits_, iter)
        {
            const auto numbers = kept_->lists.cfind(iter.key());
            if (numbers.found() && !(*iter)->restore(*numbers))
            {
                WarningInFunction
                    << "The sums of " << iter.key() << " in "
                    << kept_->objectPath() << " are of other fractions, bins"
                    << " or pieces than those of " << name()
                    << " now: they begin anew" << nl << endl;
            }
        }
        kept_.clear();
    }
}


void Foam::functionObjects::clayDiffusivity::keep() const
{
    if (!time_.writeTime() || fits_.empty())
    {
        return;
    }

    // In the same order on all ranks
    HashTable<scalarList> lists;
    for (const word& method : fits_.sortedToc())
    {
        lists.set(method, fits_[method]->numbers());
    }
    keptNumbers(time_, name(), lists, water()).save();
}


Foam::vectorField Foam::functionObjects::clayDiffusivity::flux
(
    const vectorField& gradient
) const
{
    const clayInteractions& interactions = cloud().interactions();
    const scalarField& alpha = lookupObject<volScalarField>("alpha.clay");
    const vectorField& Uclay = lookupObject<volVectorField>("U.clay");
    const vectorField& U = lookupObject<volVectorField>("U");

    vectorField result(alpha.size());
    forAll(result, celli)
    {
        const scalar friction =
            interactions.friction(min(alpha[celli], scalar(0.99)));

        vector velocity(Uclay[celli] - interactions.weight()/friction);
        if (interactions.drag())
        {
            velocity -= U[celli];
        }

        result[celli] =
            alpha[celli]*velocity
          - interactions.diffusivity()*interactions.friction(0)/friction
           *gradient[celli];
    }
    return result;
}


bool Foam::functionObjects::clayDiffusivity::execute()
{
    if (idle())
    {
        return true;
    }
    beginTables();

    if (!has("pointwise") && !has("leastSquares"))
    {
        return true;
    }
    if (fits_.empty())
    {
        begin();
    }

    const labelList& pieceOf = pieces_->pieceOf();
    const scalarField& alpha = lookupObject<volScalarField>("alpha.clay");
    const vectorField gradient(gradient_.gradient(alpha));
    const vectorField q(flux(gradient));

    forAllIters(fits_, iter)
    {
        fluxFit& fit = **iter;
        fit.nextSample();

        forAll(pieceOf, celli)
        {
            if (pieceOf[celli] >= 0)
            {
                fit.add
                (
                    pieceOf[celli],
                    mesh_.V()[celli],
                    alpha[celli],
                    q[celli],
                    gradient[celli]
                );
            }
        }
    }

    if (has("pointwise"))
    {
        gradientNow_ = gradient;
        pointwise_ = -(q & gradient)/max(magSqr(gradient), VSMALL);
    }
    keep();
    return true;
}


Foam::diffusivityTable Foam::functionObjects::clayDiffusivity::tableOf
(
    const word& method
)
{
    if (method != "equilibrium")
    {
        return
            fits_.found(method) ? fits_[method]->table() : diffusivityTable();
    }

    const scalar time = time_.value();
    const scalar concentration = cloud().matter().waterAt(time).concentration;

    if (mag(concentration - concentration_) > otherWater*concentration)
    {
        atEquilibrium_ =
            equilibrium_->table(cloud().interactions(), time, *bins_, log);
        concentration_ = concentration;
    }
    return atEquilibrium_;
}


template<class Type>
void Foam::functionObjects::clayDiffusivity::writeField
(
    const word& name,
    const dimensionSet& dimensions,
    const Field<Type>& values
) const
{
    GeometricField<Type, fvPatchField, volMesh> field
    (
        IOobject
        (
            name,
            time_.timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensioned<Type>(dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );
    field.primitiveFieldRef() = values;
    field.correctBoundaryConditions();
    field.write();
}


void Foam::functionObjects::clayDiffusivity::beginTables()
{
    wordList files(methodNames);
    files.append(commonTable);
    runTable::begin(files);
}


void Foam::functionObjects::clayDiffusivity::writeTables(const bool field)
{
    beginTables();

    if (kept_.valid())
    {
        begin();
    }
    const scalarField& alpha = lookupObject<volScalarField>("alpha.clay");
    const scalar concentration =
        cloud().matter().waterAt(time_.value()).concentration;

    forAll(methods_, i)
    {
        const word& method = methods_[i];
        const diffusivityTable table(tableOf(method));

        if (table.rows().empty())
        {
            WarningInFunction
                << "No " << method << " in the table of " << name()
                << ": too little clay between the fractions, or too few pieces"
                << " and times for an error" << nl << endl;
            continue;
        }
        if (Pstream::master() && writeToFile())
        {
            const string title("Diffusivity of clay by " + method);
            table.write
            (
                timeFolder()/method + ".dat", title, concentration, false
            );
            if (i == 0)
            {
                table.write
                (
                    timeFolder()/commonTable + ".dat",
                    title,
                    concentration,
                    true
                );
            }
        }
        if (i == 0 && field)
        {
            scalarField D(alpha.size());
            forAll(D, celli)
            {
                D[celli] = table.at(alpha[celli]);
            }
            writeField("D.clay", sqr(dimLength)/dimTime, D);
        }
    }

    setNow();
}


bool Foam::functionObjects::clayDiffusivity::end()
{
    if (!hasNow() && !idle())
    {
        writeTables(false);
    }
    return true;
}


bool Foam::functionObjects::clayDiffusivity::write()
{
    if (idle())
    {
        return true;
    }
    writeTables(true);

    if (pointwise_.size() == mesh_.nCells() && has("pointwise"))
    {
        writeField("D.clay.pointwise", sqr(dimLength)/dimTime, pointwise_);
        writeField("alpha.clay.gradient", dimless/dimLength, gradientNow_);
    }
    keep();
    return true;
}
