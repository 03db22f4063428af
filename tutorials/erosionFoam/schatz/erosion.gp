# bentoFoam, GPL-3.0-or-later
# Erosion or none, from erosion.dat: concentration [mol/m3], velocity [m/s], mean
# rate [mg/h], share that is eroded at the end, plug [g];
# with what has been measured, data/*.dat, as data/README.md has it
set encoding utf8
set terminal pngcairo size 1200, 540 font "sans,13"
set output "plots/erosion.png"

measured = system("ls data/*.dat 2>/dev/null")
rest = 1e-8                   # where water at rest is drawn [m/s]
place(u) = u > 0 ? u : rest
hours = system("sed -n 's/^# until \\([0-9]*\\) h.*/\\1/p' erosion.dat")
CCC = 76.24                   # [mol/m3], of the default platelet

set multiplot layout 1, 2 margins 0.08, 0.985, 0.13, 0.915 spacing 0.18, 0.1
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set logscale x
set format x "10^{%T}"
set xrange [4e-9:4e-5]
set xtics ("at rest" rest, "10^{-7}" 1e-7, "10^{-6}" 1e-6, "10^{-5}" 1e-5)
set xlabel "velocity of the water [m/s]"
set logscale y

set title "share of the plug that is eroded in ".hours." h"
set ylabel "concentration of the cation [mol/m^3]"
set yrange [0.02:2000]
set palette defined (0 "#deebf7", 0.25 "#9ecae1", 0.5 "#fdae6b", 0.75 "#d94801", 1 "#7f2704")
set cbrange [0:1]
set cblabel "share of the plug [-]"
set arrow 1 from 4e-9, CCC to 4e-5, CCC nohead dt 2 lw 1.5 lc rgb "#555555"
set label 1 "CCC" at 3.2e-8, CCC*1.35 center textcolor rgb "#555555"
unset key
plot "erosion.dat" using (place($2)):($4 > 0.001 ? $1 : NaN):4 with points pt 7 ps 5 palette notitle, \
    "" using (place($2)):($4 > 0.001 ? NaN : $1) with points pt 6 ps 5 lw 2 lc rgb "#777777" notitle, \
    "" using (place($2)):1:($4 > 0.001 ? sprintf($4 > 0.1 ? "%.0f %%" : "%.1f %%", 100*$4) : "none") with labels offset 0, -1.8 font ",11" notitle

unset arrow 1
unset label 1
set title "mean rate over these ".hours." h"
set ylabel "erosion [mg/h]"
set yrange [1e-3:10]
set format y "10^{%T}"
set key inside top left vertical maxrows 5 samplen 2 spacing 1.15 title "mol/m^3" left
c = "0.1 1 10 100 500"
shade(k) = word("#08306b #2171b5 #6baed6 #fd8d3c #a63603", k)
plot for [k = 1:words(c)] "erosion.dat" using ($1 == word(c, k) + 0 && $3 > 1e-3 ? place($2) : NaN):3 \
        with linespoints pt 7 ps 1.3 lw 2 lc rgb shade(k) title word(c, k).(word(c, k) eq "500" ? ": none" : ""), \
    for [k = 1:words(measured)] word(measured, k) using 1:3:4 with yerrorbars pt 5 ps 1.2 lw 2 lc rgb "black" \
        title system("sed -n 's/^# *source: *//p' ".word(measured, k))
unset multiplot
