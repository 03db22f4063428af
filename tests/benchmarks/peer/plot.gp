# medians.csv -> plot.png: lists by movement; LAMMPS and ours with each set of
# instructions in a colour each, two ranks dashed
set terminal pngcairo size 800,640
set output "plot.png"
set title "One step of a platelet, lists by movement"
set logscale x
set xlabel "platelets"
set ylabel "ns per platelet and step, median"
set yrange [0:*]
set key below
set grid
set xrange [7e3:1.5e6]

set datafile separator ","

rows(program, ranks, instructions) = sprintf("< grep '^moved,%s,[0-9]*,%d,%s,' medians.csv", program, ranks, instructions)
sets = system("sed -n 's/^moved,bentoFoam,[0-9]*,1,\\([^,]*\\),.*/\\1/p' medians.csv | LC_ALL=C.UTF-8 sort -u | xargs")
ranks(r) = sprintf("%d rank%s", r, r > 1 ? "s" : "")

plot for [r = 1:2] rows("LAMMPS", r, "-") using 3:6 with linespoints \
        linecolor 1 pointtype 7 dashtype r linewidth 2 \
        title sprintf("LAMMPS, %s", ranks(r)), \
    for [i = 1:words(sets)] for [r = 1:2] rows("bentoFoam", r, word(sets, i)) \
        using 3:6 with linespoints linecolor i + 1 pointtype 7 dashtype r linewidth 2 \
        title sprintf("bentoFoam (%s), %s", word(sets, i), ranks(r))
