# bentoFoam, GPL-3.0-or-later
# Along the line through the middle of the block, at 1e-4 s: what TR-17-13 shows
# in Fig. 3-10 ... 3-13, from runs/*/{alongLine,leastSquares,equilibrium}.dat
set encoding utf8
set terminal pngcairo size 1200, 1400 font "sans,13"
set output "plots/freeExpansion.png"

file(c) = sprintf("runs/c%s/alongLine.dat", c)
# Nothing of a method that this run left out
table(c, method) = system(sprintf("ls runs/c%s/%s.dat 2>/dev/null || echo /dev/null", c, method))
half(c) = 1e6*real(system(sprintf("sed -n 's/.*box *(.*) *([^ ]* [^ ]* \\(.*\\));.*/\\1/p' runs/c%s/system/setClayDict", c)))
length(c) = 1e6*real(system(sprintf("sed -n 's/^ *filter length *\\([^ ]*\\) m.*/\\1/p' runs/c%s/log.clayFoam", c)))
array number[2] = ["0.1", "1e-4"]
width(k) = 1e6*real(system(sprintf("LC_ALL=C.UTF-8 awk '/^[^#]/ && $2 > 1e-6 && $1 > x { x = $1 } END { print x }' %s", file(number[k]))))

set multiplot layout 4, 2 margins 0.095, 0.985, 0.045, 0.965 spacing 0.1, 0.045
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set key samplen 2 spacing 1.15
array colour[4] = [0x0072B2, 0xD00000, 0x000000, 0x999999]

# The block as it was placed, in grey
blockOf(k) = sprintf("set object 1 rectangle from %g, graph 0 to %g, graph 1 \
    fc rgb '#f3efe6' fs solid noborder behind", -half(number[k]), half(number[k]))
across(k) = sprintf("set xrange [-%g:%g]", 1.06*width(k), 1.06*width(k))

do for [k = 1:2] {
    eval blockOf(k)
    eval across(k)
    set title sprintf("%s mol/m³, filter length %.2g µm", number[k], length(number[k]))
    set ylabel "solid fraction alpha.clay [-]"
    unset xlabel
    set yrange [0:*]
    set offsets 0, 0, graph 0.06, 0
    set format y "%g"
    set key at graph 0.5, graph 0.35 center
    plot file(number[k]) using ($1*1e6):2 with lines lw 2.5 lc rgb colour[1] title "1e-4 s", \
        NaN with boxes fs solid border lc rgb "#c8bfa8" fc rgb "#f3efe6" title "block at first: 0.01"
}
unset title
unset offsets
do for [k = 1:2] {
    eval blockOf(k)
    eval across(k)
    set ylabel "|grad alpha.clay| [1/m]"
    set logscale y
    set format y "10^{%T}"
    set yrange [*:*]
    plot file(number[k]) using ($1*1e6):($2 > 0 ? abs($4) : NaN) with lines lw 2.5 lc rgb colour[1] notitle
    unset logscale y
}
do for [k = 1:2] {
    eval blockOf(k)
    eval across(k)
    set ylabel "velocity of the clay along x [mm/s]"
    set format y "%g"
    set yrange [*:*]
    plot file(number[k]) using ($1*1e6):($2 > 0 ? $3*1e3 : NaN) with lines lw 2.5 lc rgb colour[1] notitle
}
set xlabel "x [µm]"
do for [k = 1:2] {
    eval blockOf(k)
    eval across(k)
    set ylabel "|D|/D_{Liu} [-]"
    set logscale y
    set format y "10^{%T}"
    # Room for the legend
    set yrange [*:(k == 1 ? 1e5 : 1e7)]
    set key default samplen 2 spacing 1.15 top center
    # Tables of the fraction, at where the line has it, to both sides
    plot 1 with lines lw 1 dt 2 lc rgb "#000000" notitle, \
        file(number[k]) using ($1*1e6):(abs($5)/$6) with linespoints lw 1.2 pt 7 ps 0.6 lc rgb colour[1] title "pointwise (eq. 3-65)", \
        "" using ($1*1e6):($5 < 0 ? -$5/$6 : NaN) with points pt 6 ps 1.3 lw 2 lc rgb colour[2] title "negative", \
        for [s = -1:1:2] table(number[k], "leastSquares") using (s*$5*1e6):($2/$4):($3/$4) with yerrorbars pt 5 ps 1 lw 2 lc rgb 0x009E73 title (s > 0 ? "least squares" : ""), \
        for [s = -1:1:2] table(number[k], "equilibrium") using (s*$5*1e6):($2/$4) with lines lw 2.5 lc rgb 0xE69F00 title (s > 0 && table(number[k], "equilibrium") ne "/dev/null" ? "at equilibrium, cubic lattice" : "")
    unset logscale y
}
unset multiplot
