# medians.csv -> plot.png
set terminal pngcairo size 800,600
set output "plot.png"
set logscale xy
set xlabel "platelets"
set ylabel "ns per platelet and step"
set key outside below
set grid
set xrange [5e3:2e6]

set datafile separator ","

rows(program, ranks, instructions) = sprintf("< grep '^moved,%s,[0-9]*,%d,%s,' medians.csv", program, ranks, instructions)
sets = system("sed -n 's/^moved,bentoFoam,[0-9]*,1,\\([^,]*\\),.*/\\1/p' medians.csv | sort -u | xargs")

plot for [r = 1:2] rows("LAMMPS", r, "-") using 3:6 with linespoints dashtype 2 \
        title sprintf("LAMMPS, %d rank%s", r, r > 1 ? "s" : ""), \
    for [s in sets] for [r = 1:2] rows("bentoFoam", r, s) using 3:6 with linespoints \
        title sprintf("bentoFoam (%s), %d rank%s", s, r, r > 1 ? "s" : "")
