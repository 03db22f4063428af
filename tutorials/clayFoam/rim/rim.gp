# bentoFoam, GPL-3.0-or-later
# Growth of the rim, and the water that flows past it, from postProcessing/,
# thickness.dat and continuum.dat
set encoding utf8
set terminal pngcairo size 1200, 980 font "sans,13"
set output "plots/rim.png"

profile = "postProcessing/profile/0/profile.dat"

stats "thickness.dat" using 3 nooutput
across = 1.4*STATS_max*1e6     # the height that is drawn [µm]
stats profile using 1 nooutput
end = STATS_blocks - 2
last = STATS_max
array block[5] = [int(end/20.0), int(end/5.0), int(2*end/5.0), int(7*end/10.0), end]
array time[5]
do for [k = 1:5] {
    stats profile index block[k] using 1 nooutput
    time[k] = STATS_min
}
shade(k) = word("#a6cee3 #6fb1d8 #3f8fc5 #0b4f94 #062a5e", k)
name(k) = sprintf("%.2g ms", time[k]*1e3)

# Relative viscosity at a solid fraction, 0.1 mol/m3 (TR-17-13, eq. 3-14 ... 3-16);
# beyond the gel's 0.0054 nothing flows
covolume(a) = 1.6*a/0.0054093
viscosity(a) = covolume(a) < 1.6 ? 1 + 1.022*covolume(a) + 1.358*covolume(a)**3 : NaN

set multiplot layout 2, 2 margins 0.07, 0.985, 0.07, 0.96 spacing 0.09, 0.13
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set offsets 0, 0, graph 0.05, 0
set key opaque top left samplen 2.5 spacing 1.15

set title "the rim grows"
set xlabel "{/Symbol \326}time [ms^{1/2}]"
set ylabel "height above the inlet [µm]"
set xrange [0:sqrt(last*1e3)]
set yrange [0:*]
plot "thickness.dat" using (sqrt($1*1e3)):($2*1e6) with linespoints pt 7 lw 2 lc rgb 0x062a5e title "gel: alpha.clay above 0.0054", \
    "" using (sqrt($1*1e3)):($3*1e6) with linespoints pt 7 lw 2 lc rgb 0xE69F00 title "clay: above 0.001", \
    "continuum.dat" using (sqrt($1*1e3)):($2 > 0 ? $2*1e6 : NaN) with lines dt 2 lw 2 lc rgb 0x062a5e notitle, \
    "" using (sqrt($1*1e3)):($3*1e6) with lines dt 2 lw 2 lc rgb 0xE69F00 title "dashed: as a continuum"

set title "viscosity, where clay is a sol"
set key top right title "time"
set xlabel "height above the inlet [µm]"
set ylabel "viscosity over that of water [-]"
set xrange [0:across]
set yrange [1:20]
set logscale y
plot for [k = 1:5] profile index block[k] using ($2*1e6):(viscosity($3)) with lines lw 2.5 lc rgb shade(k) title name(k)
unset logscale

set title "velocity of the water"
set xlabel "height above the inlet [µm]"
set ylabel "velocity along x [mm/s]"
set xrange [0:across]
set yrange [0:1.1]
set key bottom right
plot for [k = 1:5] profile index block[k] using ($2*1e6):($4*1e3) with lines lw 2.5 lc rgb shade(k) title name(k)

set key top right
set title "solid fraction; dashed: gel above"
set ylabel "alpha.clay [-]"
set yrange [0:*]
set key top right
plot 0.0054093 with lines lw 1.5 dt 2 lc rgb "#000000" notitle, \
    for [k = 1:5] profile index block[k] using ($2*1e6):3 with lines lw 2.5 lc rgb shade(k) title name(k)
unset multiplot
