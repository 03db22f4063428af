/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "KozenyCarmanFriction.H"
#include "StokesFriction.H"
#include "addToRunTimeSelectionTable.H"
#include "readInRange.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace colloid
{
    defineTypeNameAndDebug(KozenyCarmanFriction, 0);
    addToRunTimeSelectionTable
    (
        plateletFriction,
        KozenyCarmanFriction,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// `fraction local;` or a number
Foam::scalar readFixedFraction(const Foam::dictionary& dict)
{
    using namespace Foam;

    const entry* given = dict.findEntry("fraction", keyType::LITERAL);

    if (!given)
    {
        return -1;
    }

    const token first(given->stream());

    if (first.isWord() && first.wordToken() == "local")
    {
        return -1;
    }

    if (!first.isNumber())
    {
        FatalIOErrorInFunction(dict)
            << "fraction in " << dict.dictName()
            << " is neither the word 'local' nor a number from 0 to 0.999"
            << nl << exit(FatalIOError);
    }

    return colloid::readInRange(dict, "fraction", 0, 0.999, "(-)");
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::colloid::KozenyCarmanFriction::KozenyCarmanFriction
(
    const platelet& clay,
    const water& solution,
    const scalar Kozeny
)
:
    Stokes_(StokesFriction(clay, solution).value(0)),
    bed_
    (
        clay.volume()*Kozeny*clay.specificSurface()*clay.specificSurface()
       *solution.viscosity
    ),
    fixedFraction_(-1)
{}


Foam::colloid::KozenyCarmanFriction::KozenyCarmanFriction
(
    const dictionary& dict,
    const platelet& clay,
    const water& solution
)
:
    KozenyCarmanFriction
    (
        clay,
        solution,
        readInRange(dict, "Kozeny", 0, 1000, "(-)")
    )
{
    fixedFraction_ = readFixedFraction(dict);
}


Foam::autoPtr<Foam::colloid::plateletFriction>
Foam::colloid::KozenyCarmanFriction::clone() const
{
    return autoPtr<plateletFriction>(new KozenyCarmanFriction(*this));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::colloid::KozenyCarmanFriction::value
(
    const scalar fraction
) const
{
    const scalar phi = fixedFraction_ < 0 ? fraction : fixedFraction_;

    return Stokes_ + bed_*phi/((1 - phi)*(1 - phi));
}


bool Foam::colloid::KozenyCarmanFriction::varies() const
{
    return fixedFraction_ < 0;
}


// ************************************************************************* //
