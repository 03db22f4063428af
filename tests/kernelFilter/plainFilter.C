/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "plainFilter.H"

#include "ListListOps.H"

#include <array>
#include <map>

using namespace Foam;

namespace
{

template<class Type>
Field<Type> ofAllRanks(const Field<Type>& mine)
{
    List<Field<Type>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = mine;
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    return ListListOps::combine<Field<Type>>(all, accessOp<Field<Type>>());
}


//- A set of cells seen as one point
struct plainAggregate
{
    std::vector<label> cells;
    point centre;
    scalar volume;

    scalar weight = 0;
    vector momentum = Zero;
    vector gradient = Zero;
    tensor momentumGradient = Zero;
};

} // End anonymous namespace


plainCells::plainCells(const fvMesh& mesh)
:
    centres(ofAllRanks<vector>(mesh.cellCentres())),
    volumes(ofAllRanks<scalar>(mesh.cellVolumes())),
    first(0)
{
    labelList sizes(Pstream::nProcs());
    sizes[Pstream::myProcNo()] = mesh.nCells();
    Pstream::gatherList(sizes);
    Pstream::scatterList(sizes);
    for (label proci = 0; proci < Pstream::myProcNo(); ++proci)
    {
        first += sizes[proci];
    }

    const boundBox bounds(mesh.points(), true);
    lower = bounds.min();
    upper = bounds.max();
}


plainFields plainFilter
(
    const plainCells& cells,
    const std::vector<plainPlatelet>& platelets,
    const scalar length,
    const scalar cube,
    const vector& periods,
    const scalar plateletVolume
)
{
    std::vector<plainAggregate> aggregates;

    if (cube > 0)
    {
        std::map<std::array<long, 3>, plainAggregate> byCube;

        forAll(cells.centres, celli)
        {
            std::array<long, 3> which;
            for (int axis = 0; axis < 3; ++axis)
            {
                which[axis] = long
                (
                    std::floor
                    (
                        (cells.centres[celli][axis] - cells.lower[axis])/cube
                      + 0.3819660112501051
                    )
                );
            }
            byCube[which].cells.push_back(celli);
        }
        for (const auto& entry : byCube)
        {
            aggregates.push_back(entry.second);
        }
    }
    else
    {
        forAll(cells.centres, celli)
        {
            aggregates.push_back(plainAggregate());
            aggregates.back().cells.push_back(celli);
        }
    }

    for (plainAggregate& a : aggregates)
    {
        a.centre = Zero;
        a.volume = 0;
        for (const label celli : a.cells)
        {
            a.centre += cells.volumes[celli]*cells.centres[celli];
            a.volume += cells.volumes[celli];
        }
        a.centre /= a.volume;
    }

    plainFields fields
    {
        scalarField(cells.centres.size(), Zero),
        vectorField(cells.centres.size(), Zero)
    };
    vectorField momentum(cells.centres.size(), Zero);

    label images[3];
    for (int axis = 0; axis < 3; ++axis)
    {
        images[axis] =
            periods[axis] > 0 ? label(length/periods[axis]) + 1 : 0;
    }

    for (const plainPlatelet& platelet : platelets)
    {
        struct hit
        {
            plainAggregate* aggregate;
            scalar kernel;
            vector gradient;
        };
        std::vector<hit> hits;
        scalar sum = 0;

        for (plainAggregate& a : aggregates)
        {
            for (label i = -images[0]; i <= images[0]; ++i)
            {
                for (label j = -images[1]; j <= images[1]; ++j)
                {
                    for (label k = -images[2]; k <= images[2]; ++k)
                    {
                        const vector d
                        (
                            platelet.position
                          + cmptMultiply(periods, vector(i, j, k))
                          - a.centre
                        );
                        const scalar q = mag(d)/length;

                        if (q < 1)
                        {
                            const scalar K = 1 - 3*q*q + 2*q*q*q;
                            hits.push_back
                            ({
                                &a,
                                K,
                                q > 0
                              ? (6*q - 6*q*q)/length*d/mag(d)
                              : vector(Zero)
                            });
                            sum += K*a.volume;
                        }
                    }
                }
            }
        }

        for (const hit& h : hits)
        {
            h.aggregate->weight += h.kernel/sum;
            h.aggregate->momentum += h.kernel/sum*platelet.velocity;
            h.aggregate->gradient += h.gradient/sum;
            h.aggregate->momentumGradient +=
                platelet.velocity*h.gradient/sum;
        }
        if (hits.empty())
        {
            const scalar perVolume = 1/cells.volumes[platelet.cell];
            fields.alpha[platelet.cell] += perVolume;
            momentum[platelet.cell] += perVolume*platelet.velocity;
        }
    }

    for (const plainAggregate& a : aggregates)
    {
        vector extent(Zero);
        for (const label celli : a.cells)
        {
            extent = max(extent, cmptMag(cells.centres[celli] - a.centre));
        }
        // Relative change of the weight from the centre to the corner
        const scalar change =
            a.weight > 0
          ? cmptSum(cmptMultiply(cmptMag(a.gradient), extent))/a.weight
          : 0;
        const scalar kept = change > 1 ? 1/change : 1;
        const scalar linear = change < 0.5 ? 1 : change > 1 ? 0 : 2 - 2*change;

        for (const label celli : a.cells)
        {
            const vector d(cells.centres[celli] - a.centre);
            const scalar weight = a.weight + kept*(a.gradient & d);

            fields.alpha[celli] += weight;
            if (a.weight > 0)
            {
                const vector velocity(a.momentum/a.weight);
                const tensor gradient
                (
                    (a.momentumGradient - velocity*a.gradient)/a.weight
                );
                momentum[celli] += weight*(velocity + linear*(gradient & d));
            }
        }
    }

    forAll(fields.alpha, celli)
    {
        if (fields.alpha[celli] > 0)
        {
            fields.U[celli] = momentum[celli]/fields.alpha[celli];
        }
        fields.alpha[celli] *= plateletVolume;
    }
    return fields;
}
