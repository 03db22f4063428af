/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "kernelFilter.H"

#include "cubicKernel.H"

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace
{

//- A kernel that touches the nearest centre by less than this part of its
//  length doesn't reach it: there K is nothing but round-off
constexpr Foam::scalar touch = 1e-12;


//- Aggregates are made of it before anything else is
Foam::scalar checked(const Foam::scalar length, const Foam::scalar timeScale)
{
    if (!(length > 0) || !(timeScale >= 0))
    {
        FatalErrorInFunction
            << "Filter of length " << length << " m and time scale "
            << timeScale << " s: the length must be positive, the time scale"
            << " not negative" << Foam::exit(Foam::FatalError);
    }
    return length;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

void Foam::kernelFilter::addPlatelets
(
    const UList<point>& positions,
    const UList<vector>& velocities,
    const labelUList& cells
)
{
    const label me = Pstream::myProcNo();

    // By bins, so that neighbours find the same sums still in the cache
    pointField places(positions.size());
    forAll(places, k)
    {
        places[k] = aggregates_.counting(positions[k]);
    }
    const labelList order(pointBins(places, length_/2).order());

    const List<plateletExchange::guests> guests
    (
        exchange_.send
        (
            pointField(places, order),
            vectorField(velocities, order)
        )
    );
    sums_.clear();

    // The sums of the kernels. A platelet all of whose images reach only this
    // rank is added at once
    List<scalarField> ownSums(guests.size());
    forAll(guests, proci)
    {
        const plateletExchange::guests& from = guests[proci];
        const labelList& sent = exchange_.sentTo(me);
        ownSums[proci].setSize(from.positions.size());

        scalar sum = 0;
        forAll(from.positions, i)
        {
            const bool firstImage =
                proci != me || i == 0 || sent[i] != sent[i - 1];

            if (firstImage)
            {
                sums_.next();
                sum = 0;
            }
            ownSums[proci][i] = sums_.reach(from.positions[i]);
            sum += ownSums[proci][i];

            const bool lastImage =
                proci != me || i + 1 == sent.size() || sent[i + 1] != sent[i];

            if
            (
                proci == me
             && lastImage
             && exchange_.onlyHere(sent[i])
             && sum > leastSum_
            )
            {
                sums_.add(from.velocities[i], sum);
            }
        }
    }

    const scalarField sumOf(exchange_.sumBack(ownSums));
    const List<scalarField> guestSums(exchange_.tell(sumOf));

    forAll(guests, proci)
    {
        const plateletExchange::guests& from = guests[proci];

        forAll(from.positions, i)
        {
            const bool done =
                proci == me && exchange_.onlyHere(exchange_.sentTo(me)[i]);

            if (!done && guestSums[proci][i] > leastSum_)
            {
                sums_.next();
                sums_.reach(from.positions[i]);
                sums_.add(from.velocities[i], guestSums[proci][i]);
            }
        }
    }

    toCells();

    const scalarField& V = mesh_.cellVolumes();
    forAll(sumOf, i)
    {
        if (sumOf[i] <= leastSum_)
        {
            const label celli = cells[order[i]];
            weight_[celli] += 1/V[celli];
            momentum_[celli] += velocities[order[i]]/V[celli];
        }
    }
}


void Foam::kernelFilter::toCells()
{
    const labelList& aggregateOf = aggregates_.aggregateOf();

    weight_.setSize(mesh_.nCells());
    momentum_.setSize(mesh_.nCells());

    if (!aggregates_.gathered())
    {
        forAll(weight_, celli)
        {
            weight_[celli] = sums_.weight(aggregateOf[celli]);
            momentum_[celli] = sums_.momentum(aggregateOf[celli]);
        }
        return;
    }

    const vectorField& halfWidths = aggregates_.halfWidths();
    vectorField weightGradients(aggregates_.size());
    vectorField velocities(aggregates_.size());
    tensorField velocityGradients(aggregates_.size());

    forAll(velocities, a)
    {
        const scalar weight = sums_.weight(a);
        const vector gradient(sums_.weightGradient(a));

        // Largest change of the weight within the aggregate, relative. By its
        // extent, not by its cells, since this rank need not have all
        const scalar change =
            weight > 0
          ? (cmptMag(gradient) & halfWidths[a])/weight
          : scalar(0);

        // alpha doesn't become negative
        weightGradients[a] = gradient/max(change, scalar(1));

        // The velocity is a mean over platelets and varies linearly as long
        // as their weights do so nearly; else it is constant, lest it leaves
        // the range of the platelets' velocities
        const scalar linear = min(max(2 - 2*change, scalar(0)), scalar(1));

        velocities[a] = weight > 0 ? sums_.momentum(a)/weight : vector(Zero);
        velocityGradients[a] =
            weight > 0 && linear > 0
          ? linear/weight
           *(sums_.momentumGradient(a) - velocities[a]*gradient)
          : tensor(Zero);
    }

    forAll(weight_, celli)
    {
        const label a = aggregateOf[celli];
        const vector& offset = aggregates_.offsets()[celli];

        weight_[celli] =
            max(sums_.weight(a) + (weightGradients[a] & offset), scalar(0));
        momentum_[celli] =
            weight_[celli]*(velocities[a] + (velocityGradients[a] & offset));
    }
}


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

Foam::kernelFilter::kernelFilter
(
    const fvMesh& mesh,
    const scalar length,
    const scalar timeScale
)
:
    mesh_(mesh),
    length_(checked(length, timeScale)),
    timeScale_(timeScale),
    axes_(mesh),
    aggregates_(mesh, axes_, length/cubesPerLength),
    sums_
    (
        aggregates_.centres(),
        aggregates_.ownVolumes(),
        length,
        aggregates_.gathered()
    ),
    leastSum_(cubicKernel::value(touch)*gMin(mesh.cellVolumes())),
    exchange_(axes_, sums_.bounds(), length)
{
    aggregates_.reorder(sums_.order());
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

void Foam::kernelFilter::update
(
    const UList<point>& positions,
    const labelUList& cells,
    const UList<vector>& velocities,
    const scalar plateletVolume,
    const scalar deltaT,
    volScalarField& alpha,
    volVectorField& Uclay
)
{
    addPlatelets(positions, velocities, cells);

    // The part of the present state in the filtered one
    const scalar present =
        timeScale_ > 0 && deltaT > 0 ? 1 - std::exp(-deltaT/timeScale_) : 1;

    scalarField& a = alpha.primitiveFieldRef();
    vectorField& U = Uclay.primitiveFieldRef();

    forAll(a, celli)
    {
        const scalar fraction = weight_[celli]*plateletVolume;

        if (present < 1)
        {
            const vector flux
            (
                (1 - present)*a[celli]*U[celli]
              + present*plateletVolume*momentum_[celli]
            );
            a[celli] += present*(fraction - a[celli]);
            U[celli] = a[celli] > VSMALL ? flux/a[celli] : vector(Zero);
        }
        else
        {
            a[celli] = fraction;
            U[celli] =
                weight_[celli] > 0
              ? momentum_[celli]/weight_[celli]
              : vector(Zero);
        }
    }

    alpha.correctBoundaryConditions();
    Uclay.correctBoundaryConditions();
}
