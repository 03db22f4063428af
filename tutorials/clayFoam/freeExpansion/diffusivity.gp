# bentoFoam, GPL-3.0-or-later
# D against the solid fraction from the layer that expands, from runs/layer/*.dat
set encoding utf8
set terminal pngcairo size 1200, 560 font "sans,13"
set output "plots/diffusivity.png"
table(name) = sprintf("runs/layer/%s.dat", name)

set multiplot layout 1, 2 margins 0.09, 0.975, 0.12, 0.92 spacing 0.095
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set key samplen 2.5 spacing 1.2
set xlabel "solid fraction [-]"
set logscale x
set xrange [9e-4:0.0108]
set xtics (0.001, 0.002, 0.003, "" 0.004, 0.005, "" 0.006, 0.007, "" 0.008, "" 0.009, 0.01)

set title "platelets in water of 0.1 mol/m³"
set ylabel "D [10^{-12} m²/s]"
set logscale y
set yrange [1:20000]
set key top left Left reverse
plot table("Liu") using 1:($2*1e12) with lines lw 2.5 dt 2 lc rgb "#000000" title "Liu et al. (eq. 3-4): a stack of sheets", \
    table("equilibrium") using 1:($2*1e12) with lines lw 2.5 lc rgb 0xE69F00 title "platelets at equilibrium, (1/{/Symbol x}) dp/dn", \
    table("leastSquares") using 1:($2*1e12):($3*1e12) with yerrorbars pt 7 ps 1.3 lw 2 lc rgb 0x009E73 title "least squares, platelets that spread", \
    table("pointwise") using 1:($2*1e12):($3*1e12) with yerrorbars pt 6 ps 1.3 lw 1.5 lc rgb 0x0072B2 title "the same, mean of pointwise (eq. 3-65)"

set title "the same over that at equilibrium; bars: standard error"
set ylabel "D/D_{equilibrium} [-]"
unset logscale y
set yrange [0.7:1.3]
set key top left Left reverse
set object 1 rectangle from graph 0, first 0.9 to graph 1, first 1.1 fc rgb "#f3efe6" fs solid noborder behind
plot 1 with lines lw 2.5 lc rgb 0xE69F00 notitle, \
    table("leastSquaresOverEquilibrium") with yerrorbars pt 7 ps 1.3 lw 2 lc rgb 0x009E73 title "least squares", \
    table("pointwiseOverEquilibrium") with yerrorbars pt 6 ps 1.3 lw 1.5 lc rgb 0x0072B2 title "mean of pointwise (eq. 3-65)", \
    NaN with boxes fs solid noborder fc rgb "#f3efe6" title "within 10 %"
unset multiplot
