# A periodic stack of n sheets that relaxes, and the diffusion equation that
# its solid fraction should follow:
#
#     d phi/dt = d/dx(D d phi/dx),
#     D = (h + delta)^2/xi (dF_vdW/dh - dF_DDL/dh)   (TR-17-13 eq. 3-4, no kT)
#
# The forces by the formulas as printed (eq. 3-7 ... 3-13), slopes by central
# differences: a twin of the laws in src/colloid that shares nothing with them.
#
#   -v task=places -v n=12             the places at the start, OpenFOAM's list
#   -v task=period|time -v n=12        length of the stack [m], duration [s]
#   -v task=diffusivity -v fraction=0.01 -v c=0.1 -v neighbours=40
#                                      D [m2/s] with that many on each side
#   -v task=lattice -v fraction=0.01 -v c=0.1 -v neighbours=3
#                                      (1/xi) dp/dn [m2/s] of a simple cubic lattice,
#                                      with that many along each edge to each side
#   -v task=error -v n=12  FILE        FILE has a line "x y z" for each sheet:
#                                      rms error of delta/spacing, relative

function tanh(x,   e) { e = exp(-2*x); return (1 - e)/(1 + e) }
function sinh(x) { return (exp(x) - exp(-x))/2 }
function asinh(x) { return log(x + sqrt(x*x + 1)) }
function atanh(x) { return log((1 + x)/(1 - x))/2 }

# Net force [N] at the gap h [m]: the potentials that a lone face has at h/2 and
# at h (eq. 3-10, 3-11), the mid-plane's by their sum (3-9), the pressure (3-8)
function force(h,   atMiddle, atOther, s, ddl, vdw)
{
    atMiddle = 4*atanh(tanh(y0/4)*exp(-kappa*h/2))
    atOther = 4*atanh(tanh(y0/4)*exp(-kappa*h))
    s = 2*sinh(atMiddle) + 4/(kappa*h)*sinh(atOther/2)
    ddl = 2*c*R*T*Sp*(sqrt(1 + s*s) - 1)
    vdw = A*Sp/(6*pi)*(1/h^3 - 2/(h + delta)^3 + 1/(h + 2*delta)^3)
    return ddl - vdw
}

function slope(h) { return (force(h*1.0001) - force(h*0.9999))/(0.0002*h) }

# Osmotic pressure of a simple cubic lattice without random motion
function ofLattice(fraction,   edge, i, j, k, r, sum)
{
    edge = (Sp*delta/fraction)^(1/3)
    for (i = -neighbours; i <= neighbours; ++i)
        for (j = -neighbours; j <= neighbours; ++j)
            for (k = -neighbours; k <= neighbours; ++k)
                if ((r = edge*sqrt(i*i + j*j + k*k)) > 0)
                    sum += r*force(r - delta)
    return sum/(6*edge^3)
}

function D(phi,   h) { h = delta/phi - delta; return -(h + delta)^2/xi*slope(h) }

# Label of the sheets below x: the integral of the fraction over delta
function below(x) { return (x + a/k1*sin(k1*x))/L }

# phi at time t [s] in m cells: explicit, second order in space, steps small
# enough (a quarter of the stability limit) for the error in time to be below
# that in space
function relax(t, m,   dx, dt, steps, s, i, flux)
{
    dx = P/m
    for (i = 0; i < m; ++i)
        phi[i] = delta*(below((i + 1)*dx) - below(i*dx))/dx
    dt = 0.125*dx*dx/D(delta/L*(1 + a))
    steps = int(t/dt) + 1
    dt = t/steps
    for (s = 0; s < steps; ++s)
    {
        for (i = 0; i < m; ++i)
            flux[i] = D((phi[i] + phi[(i + 1)%m])/2)*(phi[(i + 1)%m] - phi[i])/dx
        for (i = 0; i < m; ++i)
            phi[i] += dt/dx*(flux[i] - flux[(i + m - 1)%m])
    }
}

# Periodic cubic interpolation of the cells' values
function at(x, m,   i, q, p0, p1, p2, p3)
{
    x = x/P*m - 0.5
    i = int(x + m) - m
    q = x - i
    p0 = phi[(i - 1 + 2*m)%m]; p1 = phi[(i + 2*m)%m]
    p2 = phi[(i + 1 + 2*m)%m]; p3 = phi[(i + 2 + 2*m)%m]
    return p1 + q/2*(p2 - p0 + q*(2*p0 - 5*p1 + 4*p2 - p3 + q*(3*(p1 - p2) + p3 - p0)))
}

BEGIN {
    pi = 3.14159265358979
    kB = 1.380649e-23; e = 1.602176634e-19; NA = 6.02214076e23
    eps = 8.8541878128e-12*78.5; T = 298.15; R = kB*NA
    if (!c) c = 1
    sigma = 0.131; A = 1.0291012e-20
    delta = 1e-9; Sp = pi*(200e-9)^2/4; xi = 1.2e-9
    L = 1e-7; P = n*L; if (!a) a = 0.1
    k1 = 2*pi/P
    kappa = sqrt(2*c*(e*NA)^2/(eps*R*T))
    y0 = 2*asinh(e*NA*sigma/(2*eps*kappa*R*T))

    # Half of the decay time of the wave
    duration = 0.5/(D(delta/L)*k1*k1)

    if (task == "diffusivity")
    {
        for (j = 1; j <= neighbours; ++j)
            sum -= (j*delta/fraction)^2/xi*slope(j*delta/fraction - delta)
        printf "%.10g\n", sum
    }
    if (task == "lattice")
        printf "%.10g\n", (ofLattice(fraction*1.0001) - ofLattice(fraction*0.9999)) \
            /(0.0002*fraction/(Sp*delta))/xi
    if (task == "period") printf "%.17g\n", P
    if (task == "time") printf "%.17g\n", duration
    if (task == "places")
    {
        printf "%d\n(\n", n
        for (i = 0; i < n; ++i)
        {
            x = (i + 0.5)*L
            for (j = 0; j < 20; ++j) x -= (below(x) - i - 0.5)*L/(1 + a*cos(k1*x))
            printf "(0 %.17g 0)\n", x
        }
        print ")"
    }
    if (task != "error") exit
}

{ place[count++] = $2 }

END {
    if (task != "error") exit
    # Two grids, extrapolated: what is left of the reference's error is of
    # fourth order
    for (i = 0; i < n; ++i)
    {
        ahead = place[(i + 1)%n] + (i == n - 1 ? P : 0)
        middle[i] = (place[i] + ahead)/2 % P
        found[i] = delta/(ahead - place[i])
    }
    relax(duration, 80)
    for (i = 0; i < n; ++i) coarse[i] = at(middle[i], 80)
    relax(duration, 160)
    for (i = 0; i < n; ++i)
    {
        error = found[i]/((4*at(middle[i], 160) - coarse[i])/3) - 1
        squares += error*error
    }
    printf "%.6g\n", sqrt(squares/n)
}
