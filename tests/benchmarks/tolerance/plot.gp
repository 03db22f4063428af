# results.csv -> plot.png: error and cost of each scene against the tolerance
set terminal pngcairo size 1100,560
set output "plot.png"
set datafile separator ","
set multiplot layout 1,2
set logscale xy
set format "10^{%T}"
set xlabel "tolerance [-]"
set xrange [0.2:5e-5]
set grid
set key top right

scenes = system("tail -n +2 results.csv | cut -d , -f 1 | uniq | xargs")
# Without yellow
colour(i) = i < 5 ? i : i + 1
rows(scene) = sprintf("< grep '^%s,' results.csv", scene)

set title "Error against a tight run"
set yrange [1e-7:1]
set ylabel "error of what is observed [-]"
plot x with lines linecolor "black" linewidth 2 title "error = tolerance", \
    x/100 with lines linecolor "black" dashtype 2 title "a hundredth of it", \
    for [i = 1:words(scenes)] rows(word(scenes, i)) using 2:3:($4 > 0 ? $4 : 1/0) \
        with yerrorbars linecolor colour(i) pointtype 7 notitle, \
    for [i = 1:words(scenes)] rows(word(scenes, i)) using 2:3 with linespoints \
        linecolor colour(i) pointtype 7 linewidth 2 title word(scenes, i)

set title "Cost (colours as on the left)"
set yrange [*:*]
set ylabel "steps of platelets, all runs of a point [-]"
unset key
plot for [i = 1:words(scenes)] rows(word(scenes, i)) using 2:6 with linespoints \
    linecolor colour(i) pointtype 7 linewidth 2
unset multiplot
