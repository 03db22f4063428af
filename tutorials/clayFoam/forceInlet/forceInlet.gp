# bentoFoam, GPL-3.0-or-later
# Platelets that inlets have let in and that have passed a plane, over time, and how
# they lie at the end; from runs/
set encoding utf8
set terminal pngcairo size 1200, 980 font "sans,13"
set output "plots/forceInlet.png"

names = system("for r in pair calibrated reservoir; do [ ! -d runs/$r ] || echo $r; done")
count = words(names)
what(k) = word(names, k) eq "reservoir" ? "reservoir" : "force " . word(names, k)
array colour[3] = [0x0072B2, 0xD00000, 0x009E73]
passed(k, surface) = sprintf("runs/%s/postProcessing/%s/0/%s.dat", word(names, k), surface, surface)
profile(k) = sprintf("runs/%s/postProcessing/profile/0/profile.dat", word(names, k))

stats passed(1, "entered") using 1 nooutput
last = STATS_max
first = 1e-4


set multiplot layout 2, 2 margins 0.075, 0.98, 0.07, 0.96 spacing 0.09, 0.13
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set key bottom right samplen 2.5 spacing 1.15
set offsets 0, 0, graph 0.05, 0
set xlabel "time [ms]"
set ylabel "platelets"
set xrange [0:last*1e3]
set yrange [0:*]
set title "through the plane 0.5 µm above the inlet (as Fig. 3-6)"
plot for [k = 1:count] passed(k, "flux") using ($1*1e3):4 with lines lw 2.5 lc rgb colour[k] title what(k)

set title "through the inlet: as {/Symbol \326}t until the box is full"
set logscale xy
set xrange [first*1e3:last*1e3]
set yrange [20:2000]
set ylabel "platelets"
# Through what the first run had let in at a tenth of the time
reference = real(system(sprintf("LC_ALL=C.UTF-8 awk '/^[^#]/ && $1 >= %g { print -$4; exit }' %s", last/16, passed(1, "entered"))))
plot reference*sqrt(x*1e-3/(last/16)) with lines lw 1.5 dt 2 lc rgb "#000000" title "{/Symbol \265} {/Symbol \326}t", \
    for [k = 1:count] passed(k, "entered") using ($1*1e3):(-$4) with lines lw 2.5 lc rgb colour[k] title what(k)
unset logscale

set title "solid fraction at the end (filtered over three spacings)"
set xlabel "height above the inlet [µm]"
set ylabel "alpha.clay over the inlet's 0.0314"
set xrange [0:*]
set yrange [0:*]
set key bottom left
stats profile(1) using 1 nooutput
end = STATS_blocks - 2
plot 1 with lines lw 1 dt 2 lc rgb "#000000" notitle, \
    for [k = 1:count] profile(k) index end using ($2*1e6):($3/0.0314159) with linespoints pt 7 ps 0.8 lw 2.5 lc rgb colour[k] title what(k)

set yrange [0:1.1]
set title "solid fraction over time, force pair"
set key top right title "time"
array block[5] = [0, int(end/8.0 + 0.5), int(end/4.0 + 0.5), int(end/2.0 + 0.5), end]
shade(k) = word("#a6cee3 #6fb1d8 #3f8fc5 #0b4f94 #062a5e", k)
array time[5]
do for [k = 1:5] {
    stats profile(1) index block[k] using 1 nooutput
    time[k] = STATS_min
}
plot for [k = 1:5] profile(1) index block[k] using ($2*1e6):($3/0.0314159) with lines lw 2.5 lc rgb shade(k) title sprintf("%.2g ms", time[k]*1e3)
unset multiplot
