# bentoFoam, GPL-3.0-or-later
# Fronts around a hole whose clay is held at 0.57, from runs/hole-*/fronts.dat: time [h],
# farthest alpha.clay of 0.005, 0.02 and 0.1 [mm]; crosses: reference
set encoding utf8
set terminal pngcairo size 800, 600 font "sans,13"
set output "plots/fronts.png"

$Liu << end
10 19 15 8
240 84 63 28
end
$constant << end
10 12 9 5
240 51 39 21
end

set grid lt 1 lw 1 lc rgb "#e4e4e4"
set key top left samplen 2.5 spacing 1.15
set xlabel "{/Symbol \326}time [h^{1/2}]"
set ylabel "distance from the hole [mm]"
set xrange [0:16]
set yrange [0:110]
shade(k) = word("#a6cee3 #3f8fc5 #062a5e", k - 1)
name(k) = word("0.005 0.02 0.1", k - 1)
plot for [k = 2:4] "runs/hole-Liu/fronts.dat" using (sqrt($1)):k \
        with lines lw 2.5 lc rgb shade(k) title "Liu's D, alpha.clay ".name(k), \
    for [k = 2:4] $Liu using (sqrt($1)):k with points pt 2 ps 1.6 lw 2 lc rgb shade(k) notitle, \
    for [k = 2:4] "runs/hole-constant/fronts.dat" using (sqrt($1)):k \
        with lines dt 2 lw 2.5 lc rgb shade(k) title "0.3e-9 m^2/s, ".name(k), \
    NaN with points pt 2 ps 1.6 lw 2 lc rgb "#555555" title "reference (README.md)", \
    for [k = 2:4] $constant using (sqrt($1)):k with points pt 2 ps 1.6 lw 2 lc rgb shade(k) notitle
