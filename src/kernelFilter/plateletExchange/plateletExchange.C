/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "plateletExchange.H"

#include "PstreamBuffers.H"

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

Ostream& operator<<(Ostream& os, const plateletExchange::guests& g)
{
    return os << g.positions << g.velocities;
}


Istream& operator>>(Istream& is, plateletExchange::guests& g)
{
    return is >> g.positions >> g.velocities;
}


bool isEmpty(const plateletExchange::guests& g)
{
    return g.positions.empty();
}


bool isEmpty(const scalarField& values)
{
    return values.empty();
}

} // End anonymous namespace

} // End namespace Foam


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

void Foam::plateletExchange::mirrored
(
    const point& p,
    DynamicList<point>& places
) const
{
    places.clear();
    places.append(p);

    for (const plane& mirror : mirrors_)
    {
        // Where two mirrors meet, images in the first have theirs in the second
        const label before = places.size();
        for (label i = 0; i < before; ++i)
        {
            if (mirror.distance(places[i]) < reach_)
            {
                const point image(mirror.mirror(places[i]));
                places.append(image);
            }
        }
    }
}


void Foam::plateletExchange::images
(
    const direction axis,
    const scalar coordinate,
    const boundBox& region,
    DynamicList<scalar>& shifts
) const
{
    const scalar period = axes_.period(axis);
    const label most = axes_.periodic(axis) ? label(reach_/period) + 1 : 0;

    shifts.clear();
    for (label image = -most; image <= most; ++image)
    {
        const scalar shift = image*period;

        if
        (
            coordinate + shift > region.min()[axis] - reach_
         && coordinate + shift < region.max()[axis] + reach_
        )
        {
            shifts.append(shift);
        }
    }
}


bool Foam::plateletExchange::isNear
(
    const point& p,
    const boundBox& region
) const
{
    const point nearest(min(max(p, region.min()), region.max()));
    return magSqr(p - nearest) < sqr(reach_);
}


template<class Type>
Foam::List<Type> Foam::plateletExchange::swap(const List<Type>& toRanks)
{
    List<Type> fromRanks(toRanks.size());
    fromRanks[Pstream::myProcNo()] = toRanks[Pstream::myProcNo()];

    if (!Pstream::parRun())
    {
        return fromRanks;
    }

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);

    forAll(toRanks, proci)
    {
        if (proci != Pstream::myProcNo() && !isEmpty(toRanks[proci]))
        {
            UOPstream toRank(proci, buffers);
            toRank << toRanks[proci];
        }
    }

    labelList received;
    buffers.finishedSends(received);

    forAll(fromRanks, proci)
    {
        if (proci != Pstream::myProcNo() && received[proci])
        {
            UIPstream fromRank(proci, buffers);
            fromRank >> fromRanks[proci];
        }
    }
    return fromRanks;
}


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

Foam::plateletExchange::plateletExchange
(
    const periodicAxes& axes,
    const boundBox& region,
    const scalar reach
)
:
    axes_(axes),
    reach_(reach),
    regions_(Pstream::nProcs()),
    sent_(Pstream::nProcs())
{
    regions_[Pstream::myProcNo()] = region;
    Pstream::gatherList(regions_);
    Pstream::scatterList(regions_);
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

Foam::List<Foam::plateletExchange::guests> Foam::plateletExchange::send
(
    const UList<point>& positions,
    const UList<vector>& velocities
)
{
    List<guests> toRanks(Pstream::nProcs());
    onlyHere_.setSize(positions.size());
    onlyHere_ = true;

    FixedList<DynamicList<scalar>, 3> shifts;
    DynamicList<label> sent;
    DynamicList<point> places;
    DynamicList<point> originals;

    forAll(regions_, proci)
    {
        const boundBox& region = regions_[proci];
        sent.clear();
        places.clear();

        forAll(positions, k)
        {
            mirrored(positions[k], originals);

            for (const point& p : originals)
            {
                for (direction axis = 0; axis < 3; ++axis)
                {
                    images(axis, p[axis], region, shifts[axis]);
                }
                for (const scalar x : shifts[0])
                {
                    for (const scalar y : shifts[1])
                    {
                        for (const scalar z : shifts[2])
                        {
                            const point image(p + vector(x, y, z));

                            if (isNear(image, region))
                            {
                                sent.append(k);
                                places.append(image);
                                onlyHere_[k] =
                                    onlyHere_[k]
                                 && proci == Pstream::myProcNo();
                            }
                        }
                    }
                }
            }
        }

        sent_[proci] = sent;
        toRanks[proci].positions = places;
        toRanks[proci].velocities = vectorField(velocities, sent);
    }

    return swap(toRanks);
}


Foam::scalarField Foam::plateletExchange::sumBack
(
    const List<scalarField>& perGuest
) const
{
    const List<scalarField> found(swap(perGuest));
    scalarField sum(onlyHere_.size(), Zero);

    forAll(found, proci)
    {
        forAll(found[proci], i)
        {
            sum[sent_[proci][i]] += found[proci][i];
        }
    }
    return sum;
}


Foam::List<Foam::scalarField> Foam::plateletExchange::tell
(
    const UList<scalar>& perPlatelet
) const
{
    List<scalarField> toRanks(Pstream::nProcs());
    forAll(toRanks, proci)
    {
        toRanks[proci] = scalarField(perPlatelet, sent_[proci]);
    }
    return swap(toRanks);
}
