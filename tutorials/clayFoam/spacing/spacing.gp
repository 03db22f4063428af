# bentoFoam, GPL-3.0-or-later
# Mean distance of platelets against the solid fraction, from plots/spacing.dat
set encoding utf8
set terminal pngcairo size 1200, 560 font "sans,13"
set output "plots/spacing.png"
file = "plots/spacing.dat"

thickness = 1e-9
volume = 3.14159265359e-23
sheets(phi) = thickness/phi
cubic(phi) = (volume/phi)**(1.0/3)

array colour[4] = [0x0072B2, 0xE69F00, 0xCC79A7, 0x009E73]
array symbol[4] = [7, 4, 8, 13]
array name[4] = ["lattice", "random", "random, minimumDistance 0.5", "the same, relaxed by clayFoam"]

set multiplot layout 1, 2 margins 0.075, 0.985, 0.115, 0.92 spacing 0.085
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set key samplen 2.5 spacing 1.2
set xlabel "solid fraction [-]"
set logscale x
set xrange [7e-5:0.14]
set format x "10^{%T}"

set title "as Fig. 3-2 of TR-17-13; points: setClay and clayFoam"
set ylabel "mean distance, centre to centre [µm]"
set key bottom left Left reverse
set logscale y
set yrange [0.005:15]
set arrow 1 from 0.01, 0.005 to 0.01, 0.14646 nohead dt 3 lc rgb "#777777"
set arrow 2 from 7e-5, 0.14646 to 0.01, 0.14646 nohead dt 3 lc rgb "#777777"
set label 1 "0.1465 µm" at 9e-5, 0.118 tc rgb "#555555"
plot 1e6*sheets(x) with lines lw 2.5 dt 2 lc rgb "#000000" title "stack of sheets, {/Symbol d}_p/{/Symbol f}", \
    1e6*cubic(x) with lines lw 2.5 lc rgb "#000000" title "cubic, (V_p/{/Symbol f})^{1/3}", \
    for [k = 1:4] file using 1:(1e6*column(k + 1)) with points pt symbol[k] ps 1.5 lw 2 lc rgb colour[k] title name[k]
unset arrow
unset label

set title "the same over (V_p/{/Symbol f})^{1/3}"
set ylabel "distance to the nearest neighbour [(V_p/{/Symbol f})^{1/3}]"
unset logscale y
set yrange [0:1.35]
set key at 9e-5, 0.12 left Left reverse
set label 1 "face-centred cubic: 1.122" at 9e-5, 1.16 tc rgb "#555555"
set label 2 "points at random: 0.554" at 9e-5, 0.50 tc rgb "#555555"
plot 2**(1.0/6) with lines lw 1 dt 3 lc rgb "#777777" notitle, \
    0.554 with lines lw 1 dt 3 lc rgb "#777777" notitle, \
    1 with lines lw 2.5 lc rgb "#000000" notitle, \
    sheets(x)/cubic(x) with lines lw 2.5 dt 2 lc rgb "#000000" title "stack of sheets; symbols as on the left", \
    for [k = 1:4] file using 1:(column(k + 1)/cubic($1)) with points pt symbol[k] ps 1.5 lw 2 lc rgb colour[k] notitle
unset multiplot
