# bentoFoam, GPL-3.0-or-later
# Profiles across the fracture that a function object `profile` of the type
# clayProfile wrote: solid fraction at six times, velocity of the water at the
# first and the last of them. In a case, after a run from time 0:
#     gnuplot <bentoFoam>/etc/plots/clayProfile.gp

file = "postProcessing/profile/0/profile.dat"

stats file using 1 nooutput
blocks = STATS_blocks - 1     # the last is empty
lines = 6
array block[lines]
array time[lines]
do for [k = 1:lines] {
    block[k] = int((k - 1)*(blocks - 1.0)/(lines - 1) + 0.5)
    stats file index block[k] using 1 nooutput
    time[k] = STATS_min
}
shades = "#c6dbef #9ecae1 #6baed6 #4292c6 #2171b5 #08306b"

set terminal pngcairo size 1200, 550 font "sans,13" noenhanced
system("mkdir -p plots")
set output "plots/profile.png"

set multiplot layout 1, 2
set grid lc rgb "#dddddd"
set xlabel "distance from the gel's wall [um]"
set key top right

set ylabel "solid fraction alpha.clay [-]"
set yrange [0:*]
plot for [k = 1:lines] file index block[k] using ($2*1e6):3 with lines lw 2 \
    lc rgb word(shades, k) title sprintf("%.3g ms", 1e3*time[k])

set ylabel "velocity of the water along x [mm/s]"
set key bottom right
plot for [k = 1:lines:lines - 1] file index block[k] using ($2*1e6):($4*1e3) \
    with lines lw 2 lc rgb word(shades, k) title sprintf("%.3g ms", 1e3*time[k])
unset multiplot
