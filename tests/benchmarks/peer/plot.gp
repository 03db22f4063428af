# results.csv -> plot.png
set terminal pngcairo size 800,600
set output "plot.png"
set logscale xy
set xlabel "platelets"
set ylabel "ns per platelet and step"
set key outside below
set grid
set xrange [5e3:2e6]

# Mean of the repeats of one program
rows(program, ranks, instructions) = sprintf("< awk -F, '$1 == \"moved\" && $2 == \"%s\" && $4 == %d && $5 == \"%s\" { n[$3]++; t[$3] += $7 } END { for (N in n) print N, t[N]/n[N] }' results.csv | sort -n", program, ranks, instructions)
sets = system("awk -F, '$2 == \"bentoFoam\" && !seen[$5]++ { print $5 }' results.csv | xargs")

plot for [r = 1:2] rows("LAMMPS", r, "-") with linespoints dashtype 2 \
        title sprintf("LAMMPS, %d rank%s", r, r > 1 ? "s" : ""), \
    for [s in sets] for [r = 1:2] rows("bentoFoam", r, s) with linespoints \
        title sprintf("bentoFoam (%s), %d rank%s", s, r, r > 1 ? "s" : "")
