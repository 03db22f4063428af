# bentoFoam, GPL-3.0-or-later
# Error against cost for each knob, from plots/accuracy.csv

file = "plots/accuracy.csv"
set datafile separator ","
set encoding utf8
set terminal pngcairo size 1350, 1320 font "sans,12"
set output "plots/accuracy.png"

# Columns of the file
evaluations = 5; forces = 6; filtering = 7; run = 8
median = 9; rms = 10; swelling = 11; profile = 12; field = 13

rows(knob) = sprintf("< grep '^%s,' %s", knob, file)
series(knob, name) = sprintf("< grep '^%s,%s,' %s", knob, name, file)

# Smallest and largest of two columns, with room for labels
bounds(knob, a, b, below, above) = system(sprintf("LC_ALL=C.UTF-8 awk -F, '$1 == \"%s\" { \
    split($%d \" \" $%d, v, \" \"); for (i in v) if (v[i] > 0) { \
    if (!low || v[i] < low) low = v[i]; if (v[i] > high) high = v[i] } } \
    END { print low/%g \":\" high*%g }' %s", knob, a, b, below, above, file))

default(knob) = sprintf("< LC_ALL=C.UTF-8 awk -F, '$1 == \"%s\" && $4 == 1' %s", knob, file)

array colour[5] = [0x0072B2, 0xE69F00, 0x009E73, 0xCC79A7, 0x666666]
array symbol[5] = [7, 5, 9, 13, 11]
do for [k = 1:5] { set linetype k lc rgb colour[k] lw 2 pt symbol[k] ps 1.4 }
set linetype 9 lc rgb 0xD00000 lw 3 pt 6 ps 3.2
text = "font 'sans,11' left offset 1.5, 0.6 notitle"

set multiplot layout 3, 3 margins 0.065, 0.985, 0.045, 0.97 spacing 0.085, 0.08
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set logscale xy
set format y "10^{%T}"
set xtics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, \
    1000, 2000, 5000)
set key samplen 2 spacing 1.15

distance = "median distance of platelets\n from the reference [spacings]"

eval "set xrange [" . bounds("tolerance", run, run, 1.5, 2) . "]"
eval "set yrange [" . bounds("tolerance", median, median, 3, 3) . "]"
set title "1  tolerance: step, cut-off and kernel together"
set xlabel "run without writing [s]"
set ylabel distance
plot rows("tolerance") using run:median with linespoints lt 1 notitle, \
    "" using run:median:3 with labels @text, \
    default("tolerance") using run:median with points lt 9 title "default"

eval "set xrange [" . bounds("integrator", evaluations, evaluations, 20, 2) . "]"
eval "set yrange [" . bounds("integrator", median, median, 3, 3) . "]"
set title "2  integrator and step, cut-off as by default"
set xlabel "evaluations of the forces [-]"
set key bottom left Left reverse
set xtics (20, 50, 100, 200, "" 500, 1000, "" 2000, 5000)
plot for [k = 1:5] name = word("auto RKC2 BogackiShampine AdamsBashforth2 Euler", k) \
    series("integrator", name) using evaluations:median with linespoints lt k title name, \
    default("integrator") using evaluations:median with points lt 9 title "default"

set xtics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500)
eval "set xrange [" . bounds("cutOff", forces, forces, 1.5, 2) . "]"
eval "set yrange [" . bounds("cutOff", median, median, 3, 3) . "]"
set key top right Right noreverse
set title "3  cutOff [mean spacings], equal steps"
set xlabel "lists and forces [s]"
plot rows("cutOff") using forces:median with linespoints lt 1 notitle, \
    "" using forces:median:3 with labels @text, \
    default("cutOff") using forces:median with points lt 9 title "default"

eval "set xrange [" . bounds("kernel", forces, forces, 1.5, 2) . "]"
eval "set yrange [" . bounds("kernel", rms, rms, 3, 3) . "]"
set title "4  kernel: auto with its tolerance, and exact"
set xlabel "lists and forces [s]"
set ylabel "root mean square distance of platelets\n from the reference [spacings]"
exact = real(system(sprintf("LC_ALL=C.UTF-8 awk -F, '$1 == \"kernel\" && $2 == \"exact\" { print $%d }' %s", forces, file)))
set arrow 1 from exact, graph 0 to exact, graph 1 nohead lw 2 dt 2 lc rgb colour[2]
set key bottom left Left reverse
set label 1 "exact (the reference)" at exact, graph 0.5 rotate by 90 center offset -1, 0 font "sans,11"
plot series("kernel", "auto") using forces:rms with linespoints lt 1 title "auto", \
    "" using forces:rms:3 with labels @text, \
    default("kernel") using forces:rms with points lt 9 title "default"
unset arrow 1
unset label 1
set key top right Right noreverse

eval "set xrange [" . bounds("filter", filtering, filtering, 1.5, 2) . "]"
eval "set yrange [" . bounds("filter", field, field, 3, 3) . "]"
set title "5  filter length [mean spacings]"
set xlabel "filter [s]"
set ylabel "alpha.clay, cell by cell, against\n the count of platelets [-]"
plot rows("filter") using filtering:field with linespoints lt 1 notitle, \
    "" using filtering:field:3 with labels @text, \
    default("filter") using filtering:field with points lt 9 title "default"

eval "set xrange [" . bounds("mesh", run, run, 1.5, 2) . "]"
eval "set yrange [" . bounds("mesh", profile, swelling, 3, 5) . "]"
set title "6  mesh: cells per mean spacing"
set xlabel "run without writing [s]"
set ylabel "relative error [-]"
perSpacing(n) = sprintf("%.2g", n/4.4e-6*1.375e-7)
plot rows("mesh") using run:profile with linespoints lt 1 title "profile of alpha.clay", \
    "" using run:profile:(perSpacing($3)) with labels @text, \
    "" using run:swelling with linespoints lt 2 title "swelling", \
    default("mesh") using run:profile with points lt 9 title "this case"

eval "set xrange [" . bounds("flowStep", run, run, 1.5, 2) . "]"
eval "set yrange [" . bounds("flowStep", profile, swelling, 3, 10) . "]"
set title "7  step of the flow, deltaT"
plot rows("flowStep") using run:profile with linespoints lt 1 title "profile of alpha.clay", \
    "" using run:swelling with linespoints lt 2 title "swelling", \
    "" using run:swelling:(sprintf("%g µs", 1e6*$3)) with labels @text, \
    default("flowStep") using run:profile with points lt 9 title "this case"

eval "set xrange [" . bounds("alpha", run, run, 1.5, 6) . "]"
eval "set yrange [" . bounds("alpha", profile, swelling, 3, 30) . "]"
set title "8  coarseGraining: alpha, and layers of parcels"
plot rows("alpha") using run:profile with linespoints lt 1 title "profile of alpha.clay", \
    "" using run:swelling with linespoints lt 2 title "swelling", \
    "" using run:swelling:(sprintf("%d (%d layers)", $3, 12/$3)) with labels @text, \
    default("alpha") using run:profile with points lt 9 title "default"

# The ninth place tells how to read the others
unset logscale
unset tics
unset grid
unset border
unset title
unset xlabel
unset ylabel
unset key
set xrange [0:1]
set yrange [0:1]
set label 11 "{/:Bold How to read this page}\n\n\
A point is a run of clayFoam: its cost, and how\n\
far it ends from a run that is tighter in this\n\
knob. Lower is more exact, left is cheaper. The\n\
number at a point is the value of the knob.\n\n\
Gel of 6912 platelets in 12 layers expands into\n\
water of 0.1 mol/m^3. One core.\n\n\
Swelling: error of the rise of the clay's centre.\n\
Profile: root of the mean square error of slabs,\n\
over that of the profile itself.\n\n\
Panel 1 holds the errors of step, cut-off and\n\
kernel, panel 8 those and the one of alpha; each\n\
other panel that of its knob alone. Panel 5 needs\n\
no reference." at graph -0.1, 0.95 left front
plot NaN notitle
unset multiplot
