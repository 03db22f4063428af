# bentoFoam, GPL-3.0-or-later
# Profiles across the fracture that a function object `profile` of the type
# clayProfile wrote: solid fraction and velocity of the water, at up to six
# evenly spaced times of a run and its restarts. In a case, after or in the run:
#     gnuplot <bentoFoam>/etc/plots/clayProfile.gp

# The last table, in the folder of the time at which the run began
file = system("ls -t postProcessing/profile/*/profile.dat 2>/dev/null | head -n 1")
if (file eq "") {
    print "No postProcessing/profile/<time>/profile.dat: has the run a function object named profile?"
    exit status 1
}

# The last time, and every stride-th one before it
stats file using 1 nooutput
blocks = STATS_blocks - 1     # the last is empty
stride = ceil(blocks/6.0)
first = (blocks - 1) % stride
lines = (blocks - 1 - first)/stride + 1
block(k) = first + (k - 1)*stride

array time[lines]
do for [k = 1:lines] {
    stats file index block(k) using 1 nooutput
    time[k] = STATS_min
}
name(k) = time[lines] < 1 ? sprintf("%.4g ms", 1e3*time[k]) : sprintf("%.4g s", time[k])

stats file using 2 nooutput
unit = STATS_max < 1e-3 ? "µm" : "mm"
scale = STATS_max < 1e-3 ? 1e6 : 1e3

# Darker with time
shade(k) = word("#a6cee3 #6fb1d8 #3f8fc5 #2171b5 #0b4f94 #062a5e", 6 - lines + k)

set encoding utf8
set terminal pngcairo size 1200, 550 font "sans,13" noenhanced
system("mkdir -p plots")
set output "plots/profile.png"

set multiplot layout 1, 2
set grid lt 1 lc rgb "#dddddd"
set key title "time" samplen 2 spacing 1.1
set xlabel sprintf("distance from the gel's wall [%s]", unit)
set offsets 0, 0, graph 0.04, 0
set xrange [0:*]

set key top right
set ylabel "solid fraction alpha.clay [-]"
set yrange [0:*]
plot for [k = 1:lines] file index block(k) using ($2*scale):3 \
    with lines lw 2.5 lc rgb shade(k) title name(k)

set key bottom right
set ylabel "velocity of the water along x [mm/s]"
set yrange [*:*]
plot for [k = 1:lines] file index block(k) using ($2*scale):($4*1e3) \
    with lines lw 2.5 lc rgb shade(k) title name(k)
unset multiplot
