# bentoFoam, GPL-3.0-or-later
# How many platelets have entered, and where they are: plots/filling.png
set encoding utf8
set terminal pngcairo size 1200, 540 font "sans,13"
set output "plots/filling.png"

count = "runs/box/postProcessing/entered/0/entered.dat"
profile = "runs/box/postProcessing/profile/0/profile.dat"

# Platelets that the box holds at the spacing asked for
sizes(axis) = real(system(sprintf("sed -n 's/^%s  *\\([0-9]*\\);.*/\\1/p' runs/box/system/blockMeshDict", axis)))
full = sizes("width")**2*sizes("height")
unit = full > 1e5 ? 1000 : 1

# A square root through the first millisecond
stats count using ($1 <= 0.001001 ? $1 : NaN):(-$5) nooutput
root = STATS_max_y/sqrt(STATS_max_x)

set multiplot layout 1, 2 margins 0.08, 0.985, 0.12, 0.95 spacing 0.09, 0.1
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set key samplen 2 spacing 1.15

set xlabel "time [ms]"
set ylabel unit > 1 ? "platelets [thousands]" : "platelets"
set xrange [0:*]
set yrange [0:1.1*full/unit]
set key bottom right
plot full/unit with lines lw 1 dt 2 lc rgb "#000000" title "box full at 0.3 µm", \
    count using ($1*1e3):(root*sqrt($1)/unit) with lines lw 2 dt 3 lc rgb "#999999" title "square root of time", \
    "" using ($1*1e3):(-$5/unit) with lines lw 3 lc rgb "#0072B2" title "went through the inlet"

set xlabel "height above the inlet [µm]"
set ylabel "solid fraction alpha.clay [10^{-3}]"
set xrange [0:0.3*sizes("height")]
set yrange [0:1.9]
set key top right title "time" maxrows 4
shade(k) = word("#a6cee3 #7fb9da #5aa2cd #3f8fc5 #2a7ab8 #1a62a6 #0b4f94 #083c78 #062a5e #041a3e", k)
stats profile using 1 nooutput
lines = STATS_blocks - 1
plot 1.1636 with lines lw 1 dt 2 lc rgb "#000000" notitle, \
    for [k = 1:lines] profile index k - 1 using ($2*1e6):($3*1e3) \
    with linespoints lw 2.5 pt 7 ps 0.6 lc rgb shade(k) title sprintf("%d ms", k)
unset multiplot
