/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rimProfiles.H"

#include "OFstream.H"
#include "error.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Begins a file with the names of its columns
void begin(OFstream& file, const char* columns)
{
    if (!file.good())
    {
        FatalErrorInFunction
            << "Cannot write " << file.name() << nl << exit(FatalError);
    }
    file.precision(10);
    file<< "# " << columns << nl;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rimProfiles::rimProfiles(const rimCase& place, const rimMatter& matter)
:
    freeDiffusivity_(matter.laws().clay.freeDiffusivity),
    unit_
    (
        2*std::sqrt(freeDiffusivity_*place.edge().length/place.edge().velocity)
    ),
    printed_
    (
        rimSimilarity::form::printed,
        matter.laws().clay,
        place.edgeFraction(matter)
    ),
    conservative_
    (
        rimSimilarity::form::conservative,
        matter.laws().clay,
        place.edgeFraction(matter)
    ),
    flocculated_
    (
        rimSimilarity::form::conservative,
        matter.laws().flocs,
        place.edgeFraction(matter)
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rimProfiles::write(const fileName& directory) const
{
    OFstream losses(directory/"edgeLoss.dat");
    begin
    (
        losses, "printed[-] conservative[-] flocculated[-] freeDiffusivity[m2/s]"
    );
    losses
        << printed_.edgeLoss() << ' ' << conservative_.edgeLoss() << ' '
        << flocculated_.edgeLoss() << ' ' << freeDiffusivity_ << nl;

    const auto profile = [&](const char* name, const rimSimilarity& rim)
    {
        OFstream file(directory/name);
        begin(file, "z[-] distance[m] solidFraction[-]");

        // From the edge, but for the fraction 0, which is infinitely far
        for (label i = rim.fractions().size() - 1; i > 0; --i)
        {
            const scalar z = rim.distances()[i];
            file<< z << ' ' << z*unit_ << ' ' << rim.fractions()[i] << nl;
        }
    };

    profile("rimPrinted.dat", printed_);
    profile("rimConservative.dat", conservative_);
    profile("rimFlocculated.dat", flocculated_);
}


// ************************************************************************* //
