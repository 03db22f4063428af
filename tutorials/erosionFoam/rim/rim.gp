# bentoFoam, GPL-3.0-or-later
# The steady rim, from runs/*/places.dat and runs/*/loss.dat
set encoding utf8
set terminal pngcairo size 1320, 500 font "sans,13"
set output "plots/rim.png"

edge = 0.0054093          # solid fraction held at the gel
D0 = 3.41946e-12          # of lone platelets [m2/s]
u0 = 1e-5                 # of the water [m/s]
z(x, y) = y/(2*sqrt(D0*x/u0))

# The column of cells next to a distance along the edge [m]
profile(x) = sprintf("< LC_ALL=C.UTF-8 awk -v at=%g '{ d = $1 - at; d = d < 0 ? -d : d } NR == FNR { if (NR == 1 || d < least) least = d; next } d < 1.0001*least' runs/withDiffusion/places.dat runs/withDiffusion/places.dat", x)
array at[5] = [0.0003, 0.001, 0.0025, 0.005, 0.009]
shade(k) = word("#a6cee3 #6fb1d8 #3f8fc5 #0b4f94 #062a5e", k)
name(k) = sprintf("%.2g mm", 1e3*at[k])

set multiplot layout 1, 3 margins 0.06, 0.985, 0.13, 0.92 spacing 0.085, 0.1
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set key opaque bottom left samplen 2.5 spacing 1.15

set title "solid fraction above the gel"
set xlabel "distance from the gel [mm]"
set ylabel "alpha.clay/0.0054 [-]"
set xrange [0:1.5]
set yrange [0:1]
set key title "along the edge" top right
plot for [k = 1:5] profile(at[k]) using ($2*1e3):($3/edge) \
    with lines lw 2.5 lc rgb shade(k) title name(k)

set title "the same over the similarity coordinate"
set xlabel "z = y/(2(D_0x/u_0)^{1/2}) [-]"
set xrange [0:8]
set key bottom left
plot for [k = 1:5] profile(at[k]) using (z($1, $2)):($3/edge) \
    with linespoints pt k + 3 ps 0.7 lw 1.5 lc rgb shade(k) title name(k)

set title "what the edge has lost up to x"
set xlabel "distance along the edge x [mm]"
set ylabel "q_0 = N/({/Symbol r}{/Symbol d}(D_0u_0x)^{1/2}) [-]" offset 1
set logscale x
set xrange [0.04:10]
set yrange [0:0.026]
set key notitle bottom right font ",11" samplen 2
plot 0.019867 with lines dt 2 lw 2 lc rgb "#999999" title "theory (A), as printed", \
    0.012028 with lines dt 1 lw 2 lc rgb "#000000" title "theory (C), conservative", \
    "runs/boundaryLayer/loss.dat" using ($1*1e3):2 with lines lw 2.5 lc rgb "#E69F00" title "imposed flow", \
    "runs/withoutDiffusion/loss.dat" using ($1*1e3):2 with lines lw 2.5 lc rgb "#56B4E9" title "flow by its pressure", \
    "runs/withDiffusion/loss.dat" using ($1*1e3):2 with lines dt 3 lw 3 lc rgb "#062a5e" title "and diffusion along it"
unset multiplot
