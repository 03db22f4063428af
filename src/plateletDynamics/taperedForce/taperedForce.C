/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "taperedForce.H"

namespace plateletDynamics
{

taperedForce::taperedForce
(
    std::shared_ptr<const gapForce> force,
    double thickness,
    double cutOff
)
:
    force_(std::move(force)),
    thickness_(thickness),
    cutOff_(cutOff)
{}


double taperedForce::taper(double gap) const
{
    const double q =
        (gap + thickness_ - taperBegin*cutOff_)/((1 - taperBegin)*cutOff_);

    return q > 0 ? q : 0;
}


double taperedForce::force(double gap) const
{
    const double q = taper(gap);

    return q < 1 ? (1 - q*q*(3 - 2*q))*force_->force(gap) : 0;
}


double taperedForce::slope(double gap) const
{
    const double q = taper(gap);

    if (q == 0)
    {
        return force_->slope(gap);
    }
    if (q >= 1)
    {
        return 0;
    }
    const double factorSlope = -6*q*(1 - q)/((1 - taperBegin)*cutOff_);

    return
        (1 - q*q*(3 - 2*q))*force_->slope(gap)
      + factorSlope*force_->force(gap);
}

} // End namespace plateletDynamics
