# Energy [J] of the pairs of a list of places (x y z a line), from the laws that
# clayScales -csv wrote: the integral of the net force, tapered at the cut-off,
# and of the linear repulsion in contact (doc/theory.md). Nearest images in a
# periodic box.
#
#     awk -v thickness= -v contactGap= -v thermal= -v cutOff= -v period="x y z" \
#         -f energy.awk laws.csv places
#
# The first two gaps of laws.csv are the contact gap and one a little larger; a
# period of 0 is none

function taper(gap,    q) {
    q = (gap + thickness - 0.9*cutOff)/(0.1*cutOff)
    return q <= 0 ? 1 : q >= 1 ? 0 : 1 - q*q*(3 - 2*q)
}

function max(a, b) { return a > b ? a : b }

# Once all laws are read: energies at the gaps, and the contact
function integrate(    i, well) {
    for (i = n; i > 0; --i) {
        pull[i] = net[i]*taper(gap[i])*gap[i]
        energy[i] = i == n ? 0 \
            : energy[i + 1] + 0.5*(pull[i] + pull[i + 1])*log(gap[i + 1]/gap[i])
    }
    step = log(gap[n]/gap[2])/(n - 2)
    well = 10*thermal + max(0, -energy[1]) + max(0, -net[1])*contactGap
    stiffness = max(2*well/contactGap^2, (net[1] - net[2])/(gap[2] - gap[1]))
}

# Cubic in the logarithm of the gap: -pull is the energy's slope in it
function pairEnergy(h,    i, s, t, u) {
    if (h < contactGap) {
        s = contactGap - h
        return energy[1] + s*(net[1] + 0.5*stiffness*s)
    }
    s = log(h/gap[2])/step
    i = s < 0 ? 2 : int(s) + 2
    if (i >= n) return 0
    t = s - (i - 2)
    u = 1 - t
    return energy[i]*u*u*(1 + 2*t) - step*pull[i]*t*u*u \
        + energy[i + 1]*t*t*(1 + 2*u) + step*pull[i + 1]*t*t*u
}

BEGIN { split(period, side, " ") }

FILENAME == ARGV[1] && FNR == 1 {
    columns = split($0, name, ",")
    for (i = 1; i <= columns; ++i) column[name[i]] = i
}
FILENAME == ARGV[1] && FNR > 1 {
    split($0, value, ",")
    gap[++n] = value[column["gap"]]
    net[n] = value[column["doubleLayerForce"]] - value[column["vanDerWaalsForce"]]
}
FILENAME != ARGV[1] {
    ++count
    for (i = 1; i < 4; ++i) x[count, i] = $i
}
END {
    integrate()
    for (a = 1; a <= count; ++a) {
        for (b = 1; b < a; ++b) {
            square = 0
            for (i = 1; i < 4; ++i) {
                d = x[a, i] - x[b, i]
                if (side[i] > 0) d -= side[i]*int(d/side[i] + (d < 0 ? -0.5 : 0.5))
                square += d*d
            }
            if (square < cutOff*cutOff) sum += pairEnergy(sqrt(square) - thickness)
        }
    }
    printf "%.9e\n", sum
}
