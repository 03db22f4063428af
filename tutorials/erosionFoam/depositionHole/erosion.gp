# bentoFoam, GPL-3.0-or-later
# Erosion over 1000 years, from postProcessing/
set encoding utf8
set terminal pngcairo size 1200, 520 font "sans,13"
set output "plots/erosion.png"

file = "postProcessing/rimErosion/0/rimErosion.dat"
year = 3.15576e7

set multiplot layout 1, 2 margins 0.085, 0.975, 0.13, 0.92 spacing 0.1, 0.1
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set xlabel "time [years]"
set xrange [0:1000]
set object 1 rectangle from 100, graph 0 to 300, graph 1 fc rgb "#e8f1fa" fs noborder behind
set label 1 "10 to 0.1 mol/m^3" at 200, graph 0.955 center textcolor rgb "#2171b5"

set title "rate of erosion as the water turns dilute"
set ylabel "rate [g/year]"
set yrange [0:*]
set offsets 0, 0, graph 0.1, 0
set key bottom right
plot file using ($1/year):($3*1e3) with lines lw 2.5 lc rgb 0x062a5e title "leaves the fracture", \
    file using ($1/year):($5*year*1e3) with lines dt 2 lw 2.5 lc rgb 0xE69F00 title "comes from the hole"

unset label 1
set title "where the clay is"
set ylabel "mass of clay [kg]"
set key top left
plot file using ($1/year):6 with lines lw 2.5 lc rgb 0x062a5e title "eroded", \
    file using ($1/year):7 with lines lw 2.5 lc rgb 0xE69F00 title "in the fracture"
unset multiplot
