# awk -v c=CONCENTRATION -f compare.awk TABLE.csv REFERENCE.csv
# The largest relative error of clayScales' table against the rows of a
# reference table with that concentration, as a line "<columns> <error>" per
# column that both have, and a line "rows <number>". Rows are in the same order

BEGIN {
    FS = ","
    kT = 1.380649e-23*298.15
    delta = 1e-9

    # Column of the reference -> ours
    ours["h"] = "gap"
    ours["phi"] = "fraction"
    ours["kappa"] = "inverseDebyeLength"
    ours["y0"] = "surfacePotential"
    ours["ym"] = "midPotential"
    ours["F_DDL"] = "doubleLayerForce"
    ours["F_vdW"] = "vanDerWaalsForce"
    ours["xi"] = "friction"
    ours["D"] = "diffusivity"
    ours["phi_cov"] = "coVolume"
    ours["eta_r"] = "relativeViscosity"
}

function abs(x) { return x < 0 ? -x : x }

{ sub(/\r$/, "") }

# Ours, in memory
FNR == NR {
    if (FNR == 1) { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    for (i = 1; i <= NF; ++i) value[FNR - 1, i] = $i
    next
}

FNR == 1 { for (i = 1; i <= NF; ++i) { name[i] = $i; at[$i] = i }; next }

$(at["c"]) + 0 == c + 0 {
    ++row

    for (i = 1; i <= NF; ++i) {
        if (!(name[i] in ours)) continue

        scale = abs($i)

        # D: of the sum of the magnitudes of its terms. Without the slopes in
        # the table, by the exponential's kappa F and the power law's 3 F/h
        if (name[i] == "D") {
            h = $(at["h"])
            kappa = 1.0395194e8*sqrt(c)
            slopes = kappa*$(at["F_DDL"]) + 3*$(at["F_vdW"])/h
            scale = (kT + (h + delta)^2*slopes)/$(at["xi"])
        }

        difference = abs(value[row, column[ours[name[i]]]] - $i)
        error = difference == 0 ? 0 : difference/scale

        if (error > largest[name[i]]) largest[name[i]] = error
        seen[name[i]] = 1
    }
}

END {
    print "rows", row
    for (n in seen) print ours[n], largest[n] + 0
}
