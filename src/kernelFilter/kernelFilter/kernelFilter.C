/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "kernelFilter.H"

#include "cubicKernel.H"

// One version of a loop per instruction set, chosen when the program starts
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define forEachMachine \
    __attribute__((target_clones("default", "arch=haswell")))
#else
#define forEachMachine
#endif

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

//- A centre that the kernel touches by less than this part of its length
//  counts as out of reach: the kernel there is nothing but round-off
constexpr scalar touch = 1e-12;


//- t = 1 - r/l for points near p, and which of them are within reach: their
//  number, their indices (counted from first) and t
forEachMachine
label findReached
(
    const scalar* const x,
    const scalar* const y,
    const scalar* const z,
    const label n,
    const scalar px,
    const scalar py,
    const scalar pz,
    const scalar perLength,
    const label first,
    label* const reached,
    scalar* const nearness
)
{
    for (label i = 0; i < n; ++i)
    {
        const scalar dx = x[i] - px;
        const scalar dy = y[i] - py;
        const scalar dz = z[i] - pz;
        nearness[i] = 1 - std::sqrt(dx*dx + dy*dy + dz*dz)*perLength;
    }

    // Without a branch, which would be mispredicted half of the time
    label found = 0;
    for (label i = 0; i < n; ++i)
    {
        const scalar t = nearness[i];
        reached[found] = first + i;
        nearness[found] = t;
        found += t > touch;
    }
    return found;
}

} // End anonymous namespace

} // End namespace Foam


// * * * * * * * * * * * * * * * * * Private * * * * * * * * * * * * * * * * //

void Foam::kernelFilter::reach(const point& p)
{
    reached_.clear();
    nearness_.clear();

    bins_.forRows
    (
        p,
        length_,
        [&](const label begin, const label end)
        {
            const label found = reached_.size();
            reached_.setSize(found + end - begin);
            nearness_.setSize(found + end - begin);

            const label n = findReached
            (
                &x_[begin],
                &y_[begin],
                &z_[begin],
                end - begin,
                p.x(),
                p.y(),
                p.z(),
                1/length_,
                begin,
                &reached_[found],
                &nearness_[found]
            );
            reached_.setSize(found + n);
            nearness_.setSize(found + n);
        }
    );
}


Foam::scalar Foam::kernelFilter::ownSum() const
{
    const scalarField& volumes = aggregates_.ownVolumes();
    scalar sum = 0;

    forAll(reached_, i)
    {
        sum += cubicKernel::value(nearness_[i])*volumes[reached_[i]];
    }
    return sum;
}


void Foam::kernelFilter::spread
(
    const point& p,
    const vector& velocity,
    const scalar sum
)
{
    const scalar perSum = 1/sum;
    const scalar slopeFactor = perSum/sqr(length_);
    const bool linear = aggregates_.gathered();

    forAll(reached_, i)
    {
        const label a = reached_[i];
        sums& s = sums_[a];

        const scalar weight = cubicKernel::value(nearness_[i])*perSum;
        s.weight += weight;
        s.momentum[0] += weight*velocity.x();
        s.momentum[1] += weight*velocity.y();
        s.momentum[2] += weight*velocity.z();

        if (linear)
        {
            const scalar slope = cubicKernel::slope(nearness_[i])*slopeFactor;
            s.gradient[0] += slope*(p.x() - x_[a]);
            s.gradient[1] += slope*(p.y() - y_[a]);
            s.gradient[2] += slope*(p.z() - z_[a]);
        }
    }
}


void Foam::kernelFilter::limitGradients()
{
    const vectorField& halfWidths = aggregates_.halfWidths();

    forAll(sums_, a)
    {
        sums& s = sums_[a];

        // By the extent of the aggregate, not by its cells, which this rank
        // need not have all
        scalar largest = 0;
        for (direction axis = 0; axis < 3; ++axis)
        {
            largest += mag(s.gradient[axis])*halfWidths[a][axis];
        }
        if (largest > s.weight)
        {
            for (scalar& slope : s.gradient)
            {
                slope *= s.weight/largest;
            }
        }
    }
}


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

namespace
{

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
    bins_(aggregates_.centres(), length/3),
    exchange_(axes_, bins_.bounds(), length)
{
    aggregates_.reorder(bins_.order());

    x_ = aggregates_.centres().component(vector::X);
    y_ = aggregates_.centres().component(vector::Y);
    z_ = aggregates_.centres().component(vector::Z);
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
    sums_ = List<sums>(aggregates_.size());

    pointField places(positions.size());
    forAll(places, k)
    {
        places[k] = aggregates_.counting(positions[k]);
    }
    const List<plateletExchange::guests> guests
    (
        exchange_.send(places, velocities)
    );

    // Sums of the kernels. A platelet of this rank that reaches nothing beyond
    // it is done with at once
    List<scalarField> ownSums(guests.size());
    const label me = Pstream::myProcNo();

    forAll(guests, proci)
    {
        ownSums[proci].setSize(guests[proci].positions.size());

        forAll(ownSums[proci], i)
        {
            const point& p = guests[proci].positions[i];

            reach(p);
            ownSums[proci][i] = ownSum();

            if
            (
                proci == me
             && ownSums[me][i] > 0
             && exchange_.single(exchange_.sentTo(me)[i])
            )
            {
                spread(p, guests[me].velocities[i], ownSums[me][i]);
            }
        }
    }

    const scalarField sumOf(exchange_.sumBack(ownSums));
    const List<scalarField> guestSums(exchange_.tell(sumOf));

    forAll(guests, proci)
    {
        forAll(guestSums[proci], i)
        {
            const bool done =
                proci == me && exchange_.single(exchange_.sentTo(me)[i]);

            if (!done && guestSums[proci][i] > 0)
            {
                reach(guests[proci].positions[i]);
                spread
                (
                    guests[proci].positions[i],
                    guests[proci].velocities[i],
                    guestSums[proci][i]
                );
            }
        }
    }

    limitGradients();

    // Per cell, weight per volume and the same times velocity
    const scalarField& V = mesh_.cellVolumes();
    const labelList& aggregateOf = aggregates_.aggregateOf();
    const vectorField& offsets = aggregates_.offsets();
    scalarField weight(V.size());
    vectorField momentum(V.size());

    forAll(weight, celli)
    {
        const sums& s = sums_[aggregateOf[celli]];
        const vector& d = offsets[celli];
        const scalar* g = s.gradient;
        const scalar* m = s.momentum;

        weight[celli] =
            max(0., s.weight + g[0]*d.x() + g[1]*d.y() + g[2]*d.z());
        momentum[celli] =
            s.weight > 0
          ? weight[celli]/s.weight*vector(m[0], m[1], m[2])
          : vector(Zero);
    }
    forAll(sumOf, k)
    {
        if (!(sumOf[k] > 0))
        {
            weight[cells[k]] += 1/V[cells[k]];
            momentum[cells[k]] += velocities[k]/V[cells[k]];
        }
    }

    // The part of the present state in the filtered one
    const scalar present =
        timeScale_ > 0 && deltaT > 0 ? 1 - std::exp(-deltaT/timeScale_) : 1;

    scalarField& a = alpha.primitiveFieldRef();
    vectorField& U = Uclay.primitiveFieldRef();

    forAll(a, celli)
    {
        const scalar fraction = weight[celli]*plateletVolume;

        if (present < 1)
        {
            const vector flux
            (
                (1 - present)*a[celli]*U[celli]
              + present*plateletVolume*momentum[celli]
            );
            a[celli] += present*(fraction - a[celli]);
            U[celli] = a[celli] > VSMALL ? flux/a[celli] : vector(Zero);
        }
        else
        {
            a[celli] = fraction;
            U[celli] =
                weight[celli] > 0
              ? momentum[celli]/weight[celli]
              : vector(Zero);
        }
    }

    alpha.correctBoundaryConditions();
    Uclay.correctBoundaryConditions();
}
