/*---------------------------------------------------------------------------*\
    bentoFoam: bentonite swelling, sol and erosion in fractures, in OpenFOAM
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "kernelSums.H"

#include "cubicKernel.H"

// The version of a loop is chosen when the program starts. All give the same
// bits, since nothing is contracted (-ffp-contract=off)
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define forEachMachine \
    __attribute__((target_clones("default", "avx2")))
#else
#define forEachMachine
#endif

// * * * * * * * * * * * * * * * Local functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

//- t and K at n points; the sum of K V
forEachMachine
scalar evaluate
(
    const label n,
    const scalar* __restrict__ x,
    const scalar* __restrict__ y,
    const scalar* __restrict__ z,
    const scalar* __restrict__ volume,
    const scalar px,
    const scalar py,
    const scalar pz,
    const scalar perLength,
    scalar* __restrict__ t,
    scalar* __restrict__ kernel
)
{
    for (label i = 0; i < n; ++i)
    {
        const scalar dx = x[i] - px;
        const scalar dy = y[i] - py;
        const scalar dz = z[i] - pz;
        const scalar ti = 1 - std::sqrt(dx*dx + dy*dy + dz*dz)*perLength;

        // max(ti, 0): a comparison could trap, so it would not be vectorised
        t[i] = 0.5*(ti + std::abs(ti));
        kernel[i] = cubicKernel::value(t[i]);
    }

    // As many sums as a vector has lanes, in a fixed order
    constexpr label lanes = 4;
    scalar sum[lanes] = {0, 0, 0, 0};
    label i = 0;
    for (; i + lanes <= n; i += lanes)
    {
        for (label lane = 0; lane < lanes; ++lane)
        {
            sum[lane] += kernel[i + lane]*volume[i + lane];
        }
    }
    for (; i < n; ++i)
    {
        sum[0] += kernel[i]*volume[i];
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}


//- Gradient of K times l^2 along one axis
forEachMachine
void slopes
(
    const label n,
    const scalar* __restrict__ x,
    const scalar* __restrict__ t,
    const scalar px,
    scalar* __restrict__ slope
)
{
    for (label i = 0; i < n; ++i)
    {
        slope[i] = cubicKernel::slope(t[i])*(px - x[i]);
    }
}


//- Four sums += factors*term
forEachMachine
void addTo
(
    const label n,
    const scalar* __restrict__ factors,
    const scalar* __restrict__ term,
    scalar* __restrict__ sum0,
    scalar* __restrict__ sum1,
    scalar* __restrict__ sum2,
    scalar* __restrict__ sum3
)
{
    const scalar f0 = factors[0];
    const scalar f1 = factors[1];
    const scalar f2 = factors[2];
    const scalar f3 = factors[3];

    for (label i = 0; i < n; ++i)
    {
        sum0[i] += f0*term[i];
        sum1[i] += f1*term[i];
        sum2[i] += f2*term[i];
        sum3[i] += f3*term[i];
    }
}


//- A sum and its gradient
forEachMachine
void addTo
(
    const label n,
    const scalar factor,
    const scalar slopeFactor,
    const scalar* __restrict__ term,
    const scalar* __restrict__ slopeX,
    const scalar* __restrict__ slopeY,
    const scalar* __restrict__ slopeZ,
    scalar* __restrict__ sum,
    scalar* __restrict__ gradientX,
    scalar* __restrict__ gradientY,
    scalar* __restrict__ gradientZ
)
{
    for (label i = 0; i < n; ++i)
    {
        sum[i] += factor*term[i];
        gradientX[i] += slopeFactor*slopeX[i];
        gradientY[i] += slopeFactor*slopeY[i];
        gradientZ[i] += slopeFactor*slopeZ[i];
    }
}

} // End anonymous namespace

} // End namespace Foam


// * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * * //

Foam::kernelSums::kernelSums
(
    const UList<point>& points,
    const UList<scalar>& volumes,
    const scalar length,
    const bool withGradients
)
:
    length_(length),
    withGradients_(withGradients),
    bins_(points, length/2),
    volumes_(volumes, bins_.order()),
    nReached_(0)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        x_[axis] = pointField(points, bins_.order()).component(axis);
    }
    clear();
}


// * * * * * * * * * * * * * * * Member functions  * * * * * * * * * * * * * //

void Foam::kernelSums::clear()
{
    for (int c = 0; c < components; ++c)
    {
        sums_[c] = scalarField(volumes_.size(), Zero);

        for (scalarField& gradient : gradients_[c])
        {
            gradient = scalarField(withGradients_ ? volumes_.size() : 0, Zero);
        }
    }
}


void Foam::kernelSums::next()
{
    ranges_.clear();
    nReached_ = 0;
}


Foam::scalar Foam::kernelSums::reach(const point& p)
{
    const label firstRange = ranges_.size();
    label at = nReached_;

    bins_.forRows
    (
        p,
        length_,
        [&](const label begin, const label end)
        {
            ranges_.append(range{p, begin, end});
            nReached_ += end - begin;
        }
    );

    if (t_.size() < nReached_)
    {
        const label room = nReached_ + nReached_/2;
        t_.resize(room);
        kernel_.resize(room);
        for (scalarField& slope : slope_)
        {
            slope.resize(room);
        }
    }

    scalar sum = 0;
    for (label rangei = firstRange; rangei < ranges_.size(); ++rangei)
    {
        const range& r = ranges_[rangei];

        sum += evaluate
        (
            r.end - r.begin,
            &x_[0][r.begin],
            &x_[1][r.begin],
            &x_[2][r.begin],
            &volumes_[r.begin],
            p.x(),
            p.y(),
            p.z(),
            1/length_,
            &t_[at],
            &kernel_[at]
        );
        at += r.end - r.begin;
    }
    return sum;
}


void Foam::kernelSums::add(const vector& velocity, const scalar sum)
{
    const scalar factors[components] =
        {1/sum, velocity.x()/sum, velocity.y()/sum, velocity.z()/sum};

    label at = 0;
    for (const range& r : ranges_)
    {
        const label n = r.end - r.begin;

        if (withGradients_)
        {
            for (direction axis = 0; axis < 3; ++axis)
            {
                slopes
                (
                    n,
                    &x_[axis][r.begin],
                    &t_[at],
                    r.platelet[axis],
                    &slope_[axis][at]
                );
            }
            for (int c = 0; c < components; ++c)
            {
                addTo
                (
                    n,
                    factors[c],
                    factors[c]/sqr(length_),
                    &kernel_[at],
                    &slope_[0][at],
                    &slope_[1][at],
                    &slope_[2][at],
                    &sums_[c][r.begin],
                    &gradients_[c][0][r.begin],
                    &gradients_[c][1][r.begin],
                    &gradients_[c][2][r.begin]
                );
            }
        }
        else
        {
            addTo
            (
                n,
                factors,
                &kernel_[at],
                &sums_[0][r.begin],
                &sums_[1][r.begin],
                &sums_[2][r.begin],
                &sums_[3][r.begin]
            );
        }
        at += n;
    }
}


Foam::vector Foam::kernelSums::weightGradient(const label i) const
{
    const auto& g = gradients_[0];
    return vector(g[0][i], g[1][i], g[2][i]);
}


Foam::tensor Foam::kernelSums::momentumGradient(const label i) const
{
    tensor gradient;
    for (direction c = 0; c < 3; ++c)
    {
        for (direction axis = 0; axis < 3; ++axis)
        {
            gradient[3*c + axis] = gradients_[c + 1][axis][i];
        }
    }
    return gradient;
}
