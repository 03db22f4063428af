# bentoFoam, GPL-3.0-or-later
# Profiles across the fracture that the function object clayProfile wrote:
# solid fraction at several times, and the water's velocity at the last.
# In a case:  gnuplot <bentoFoam>/etc/plots/clayProfile.gp

file = system("ls -d postProcessing/profile/*/profile.dat | head -n 1")
stats file using 1 nooutput
blocks = STATS_blocks - (STATS_blank > 0 ? 0 : 0)

set terminal pngcairo size 1200, 600 font "sans,13" noenhanced
system("mkdir -p plots")
set output "plots/profile.png"

set multiplot layout 1, 2
set grid lc rgb "#dddddd"
set key top right
set xlabel "distance from the gel's wall [um]"

set ylabel "solid fraction alpha.clay [-]"
set yrange [0:*]
shades = "#c6dbef #9ecae1 #6baed6 #3182bd #08519c #08306b"
shown = 5
plot for [k = 0:shown] i = int(k*(blocks - 1.0)/shown + 0.5) file index i \
    using ($2*1e6):3 with lines lw 2 lc rgb word(shades, k + 1) \
    title sprintf("%.3g ms", 1e3*system(sprintf( \
        "awk 'BEGIN { RS = \"\"; FS = \"[ \\t\\n]+\" } !/^#/ || NR > 1 { if (n++ == %d) { for (j = 1; j <= NF; ++j) if ($j ~ /^[0-9]/) { print $j; exit } } }' %s", i, file)))

set ylabel "velocity of the water along x [mm/s]"
plot file index blocks - 1 using ($2*1e6):($4*1e3) with lines lw 2 \
    lc rgb "#08519c" title "at the end"
unset multiplot
