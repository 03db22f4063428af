# Osmotic pressure [Pa] of a periodic cube, n kT + sum r F/(3 V), from the places of
# its platelets at several times, after the laws that clayScales -csv wrote:
#
#     awk -v edge= -v kT= -v thickness= -f pressure.awk laws.csv places...
#
# prints mean, standard error of the mean (times count as independent), n kT

FILENAME == ARGV[1] && FNR == 1 {
    columns = split($0, name, ",")
    for (i = 1; i <= columns; ++i) column[name[i]] = i
}
FILENAME == ARGV[1] && FNR > 1 {
    split($0, value, ",")
    gap[++n] = log(value[column["gap"]])
    net = value[column["doubleLayerForce"]] - value[column["vanDerWaalsForce"]]

    # Far away attraction is left, of no weight
    force[n] = log(net > 1e-30 ? net : 1e-30)
}
FILENAME != ARGV[1] && FNR == 1 { add(); count = 0 }
FILENAME != ARGV[1] {
    ++count
    for (i = 1; i < 4; ++i) x[count, i] = $i
}

# The sum over pairs of the nearest images, force interpolated in logarithms on
# gaps that grow by a constant factor
function add(    i, j, a, d, r2, r, s, sum) {
    if (!count) return
    for (i = 1; i <= count; ++i) {
        for (j = 1; j < i; ++j) {
            r2 = 0
            for (a = 1; a < 4; ++a) {
                d = x[i, a] - x[j, a]
                if (d > edge/2) d -= edge
                if (d < -edge/2) d += edge
                r2 += d*d
            }
            if (r2 > edge*edge/4) continue
            r = sqrt(r2)
            s = (log(r - thickness) - gap[1])/(gap[2] - gap[1])
            d = int(s) + 1
            if (d >= n) continue
            s -= d - 1
            sum += r*exp(force[d]*(1 - s) + force[d + 1]*s)
        }
    }
    sum = sum/(3*edge^3) + count*kT/edge^3
    ++times
    mean += sum
    squares += sum*sum
}

END {
    add()
    mean /= times
    printf "%.6g %.3g %.6g\n", mean, sqrt((squares/times - mean*mean)/(times - 1)), count*kT/edge^3
}
