/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchPieces.H"
#include "boundBox.H"
#include "HashTable.H"
#include "labelPair.H"

Foam::patchPieces::patchPieces(const patchLayer& layer, const scalar edge)
:
    layer_(layer),
    pieceOf_(layer.triangles().size())
{
    const List<patchLayer::triangle>& triangles = layer.triangles();
    const vector directions[2] = {layer.along(), layer.across()};

    List<FixedList<scalar, 2>> middles(triangles.size());
    FixedList<scalar, 2> low{GREAT, GREAT};
    FixedList<scalar, 2> high{-GREAT, -GREAT};
    forAll(triangles, t)
    {
        for (direction i = 0; i < 2; ++i)
        {
            middles[t][i] = 0;
            for (const point& corner : triangles[t].corners)
            {
                const scalar at = corner & directions[i];
                low[i] = min(low[i], at);
                high[i] = max(high[i], at);
                middles[t][i] += at/3;
            }
        }
    }

    // Fields without triangles are no pieces
    const label fields[2] =
    {
        max(label(1), label(min((high[0] - low[0])/edge, scalar(labelMax/8)))),
        max(label(1), label(min((high[1] - low[1])/edge, scalar(labelMax/8))))
    };
    HashTable<label, labelPair, labelPair::Hash<>> pieceAt;
    forAll(triangles, t)
    {
        label field[2];
        for (direction i = 0; i < 2; ++i)
        {
            const scalar part = (middles[t][i] - low[i])/(high[i] - low[i]);
            field[i] = min(label(part*fields[i]), fields[i] - 1);
        }
        const labelPair number(field[0], field[1]);
        if (pieceAt.insert(number, areaUpTo_.size()))
        {
            areaUpTo_.append(scalarList(triangles.size(), Zero));
        }
        pieceOf_[t] = pieceAt[number];
        areaUpTo_[pieceOf_[t]][t] = triangles[t].area;
    }

    for (scalarList& areas : areaUpTo_)
    {
        for (label t = 1; t < areas.size(); ++t)
        {
            areas[t] += areas[t - 1];
        }
    }
}


Foam::label Foam::patchPieces::of(const point& x) const
{
    const label triangle = layer_.triangleAt(x);
    return triangle < 0 ? -1 : pieceOf_[triangle];
}
