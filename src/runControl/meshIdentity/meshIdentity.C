/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshIdentity.H"
#include "dictionary.H"
#include "PstreamReduceOps.H"
#include "polyMesh.H"
#include "StringStream.H"

#include <cmath>

Foam::meshIdentity::meshIdentity(const polyMesh& mesh)
:
    bounds_(mesh.points(), true),
    volume_(gSum(mesh.cellVolumes()))
{}


Foam::meshIdentity::meshIdentity(const dictionary& dict)
:
    bounds_(dict.get<point>("lower"), dict.get<point>("upper")),
    volume_(dict.get<scalar>("volume"))
{}


Foam::scalar Foam::meshIdentity::roundOff()
{
    const label digits = min(label(6), label(IOstream::defaultPrecision()));
    return 0.5*std::pow(scalar(10), 1 - digits);
}


Foam::vector Foam::meshIdentity::roundOffOfPlaces() const
{
    vector off;
    for (direction axis = 0; axis < 3; ++axis)
    {
        off[axis] =
            roundOff()*max(mag(bounds_.min()[axis]), mag(bounds_.max()[axis]));
    }
    return off;
}


Foam::string Foam::meshIdentity::difference(const meshIdentity& now) const
{
    const vector off(roundOffOfPlaces());
    const vector extent(bounds_.span());

    bool other = false;
    // Each side may be off, so may the cells between
    scalar ofVolume = roundOff();
    for (direction axis = 0; axis < 3; ++axis)
    {
        other =
            other
         || mag(bounds_.min()[axis] - now.bounds_.min()[axis]) > 2*off[axis]
         || mag(bounds_.max()[axis] - now.bounds_.max()[axis]) > 2*off[axis];
        ofVolume += 4*off[axis]/max(extent[axis], VSMALL);
    }

    // More digits than those that tell, whatever writePrecision is
    OStringStream text;
    text.precision(8);
    if (other)
    {
        text<< "it spans " << now.bounds_.min() << ' ' << now.bounds_.max()
            << " m, and did " << bounds_.min() << ' ' << bounds_.max() << " m";
    }
    else if (mag(now.volume_ - volume_) > ofVolume*volume_)
    {
        text<< "its volume is " << now.volume_ << " m3, and was " << volume_
            << " m3";
    }
    return text.str();
}


void Foam::meshIdentity::write(Ostream& os) const
{
    os.writeEntry("lower", bounds_.min());
    os.writeEntry("upper", bounds_.max());
    os.writeEntry("volume", volume_);
}
