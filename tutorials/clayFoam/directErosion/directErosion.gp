# bentoFoam, GPL-3.0-or-later
# What the gel's edge loses, from loss.dat, extrapolated.dat, runs/, and by clayRim
# edgeLoss.dat and rim*.dat
set encoding utf8
set terminal pngcairo size 1200, 980 font "sans,13"
set output "plots/directErosion.png"

losses = system("tail -n 1 edgeLoss.dat")
A = 0 + word(losses, 1)
C = 0 + word(losses, 2)
fit = system("LC_ALL=C.UTF-8 awk '$1 == 0.25 { print $2, $3, $4/2 }' extrapolated.dat")
zero = 0 + word(fit, 1)
error = 0 + word(fit, 2)
slope = 0 + word(fit, 3)

colour(alpha) = alpha == 800 ? 0x6fb1d8 : alpha == 400 ? 0x0b4f94 : alpha == 200 ? 0xE69F00 : 0x009E73
sizes = "800 400 200 100"
has(alpha) = int(system("ls runs | grep -c '^".alpha."[.]1$'"))

set multiplot layout 2, 2 margins 0.085, 0.985, 0.07, 0.96 spacing 0.1, 0.13
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set key opaque samplen 2.5 spacing 1.15
set bars small

set title "loss by similarity, along the edge"
set xlabel "x/L_x [-]"
set ylabel "q_0 [-]"
set xrange [0:1.05]
set yrange [0.01:0.026]
set ytics 0.002
set key bottom right maxrows 6
plot C with lines lw 2 lc rgb 0 title "theory (C), D of the parcels", \
    A with lines lw 1.5 dt 2 lc rgb 0 title "as printed (A)", \
    "continuum.dat" using 1:2 with lines lw 2 lc rgb "#CC3311" title "erosionFoam, D of the parcels", \
    for [a in sizes] has(a) ? "< LC_ALL=C.UTF-8 awk '$4 == ".a."' loss.dat" : "< echo NaN NaN NaN NaN NaN" \
        using 5:2:(2*$3) with yerrorbars pt 7 lw 1.5 lc rgb colour(int(a)) \
        title (has(a) ? "parcels of ".a."^3" : "")

set title "loss against the parcels' size; line: at L_x/4"
set xlabel "{/Symbol a}/√(x/L_x), as spacing of parcels over the rim [-]"
set xrange [0:1700]
set yrange [0.014:0.022]
set key bottom right maxrows 6
set object 1 rectangle from 0, zero - error to 25, zero + error fc rgb "#bbbbbb" fs solid noborder
plot zero + slope*x with lines lw 2 lc rgb "#888888" title \
        sprintf("to %.5f ± %.5f (95 %%)", zero, error), \
    C with lines lw 2 lc rgb 0 title "theory (C)", \
    for [a in sizes] has(a) ? "< LC_ALL=C.UTF-8 awk '$4 == ".a."' loss.dat" : "< echo NaN NaN NaN NaN NaN" \
        using 1:2:(2*$3) with yerrorbars pt 7 lw 1.5 lc rgb colour(int(a)) \
        title (has(a) ? "parcels of ".a."^3" : "")
unset object 1

set title "solid fraction in the rim, at L_x/2"
set xlabel "distance from the gel [mm]"
set ylabel "solid fraction [-]"
set xrange [0:1.1]
set yrange [0:*]
set ytics 0.001
set key top right
# By theory at the end, the distances as the root of x
plot "rimConservative.dat" using ($2*1e3*sqrt(0.5)):3 with lines lw 2 lc rgb 0 title "theory (C)", \
    "rimPrinted.dat" using ($2*1e3*sqrt(0.5)):3 with lines lw 1.5 dt 2 lc rgb 0 title "as printed (A)", \
    for [a in sizes] has(a) ? "runs/".a.".1/profile.dat" : "< echo NaN NaN NaN NaN NaN" \
        using ($1*1e3):2:(2*$3) with yerrorbars pt 7 ps 0.8 lc rgb colour(int(a)) \
        title (has(a) ? "parcels of ".a."^3" : "")

set title "from empty water to the steady rate, at L_x/4"
set xlabel "time [s]"
set ylabel "q_0 [-]"
set xrange [0:8800]
set xtics 2000
set yrange [0:0.026]
set ytics 0.005
set key bottom right
plot C with lines lw 2 lc rgb 0 title "theory (C), steady", \
    for [a in sizes] has(a) ? "runs/".a.".1/rate.dat" : "< echo NaN NaN NaN NaN NaN" \
        using 1:2 with linespoints pt 7 ps 0.8 lw 1.5 lc rgb colour(int(a)) \
        title (has(a) ? "parcels of ".a."^3" : "")
unset multiplot
