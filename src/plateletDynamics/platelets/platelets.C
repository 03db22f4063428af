/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "platelets.H"

namespace plateletDynamics
{

namespace
{

template<class Type>
void reorderOne(std::vector<Type>& values, const std::vector<int>& order)
{
    // One that is not in use
    if (values.empty())
    {
        return;
    }

    std::vector<Type> reordered;
    reordered.reserve(order.size());

    for (const int k : order)
    {
        reordered.push_back(values[k]);
    }
    values.swap(reordered);
}

} // End namespace


void platelets::append(std::int64_t newId, const vector& newPosition)
{
    id.push_back(newId);
    tag.push_back(-1);
    position.push_back(newPosition);
    waterVelocity.push_back(vector::Zero());
    friction.push_back(1);
    fixed.push_back(0);
    previousVelocity.push_back(vector::Zero());
    previousStep.push_back(0);
    crossings.push_back({0, 0, 0});
    force.push_back(vector::Zero());
    velocity.push_back(vector::Zero());
}


void platelets::reorder(const std::vector<int>& order)
{
    reorderOne(id, order);
    reorderOne(tag, order);
    reorderOne(position, order);
    reorderOne(waterVelocity, order);
    reorderOne(friction, order);
    reorderOne(fixed, order);
    reorderOne(previousVelocity, order);
    reorderOne(previousStep, order);
    reorderOne(mobilitySlope, order);
    reorderOne(nearest, order);
    reorderOne(sinceChoice, order);
    reorderOne(crossings, order);
    reorderOne(force, order);
    reorderOne(velocity, order);
}

} // End namespace plateletDynamics
