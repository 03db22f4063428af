# bentoFoam, GPL-3.0-or-later
# The gel that swells from a hole, by clayRim with an `expansion`: its rim's
# radius, what enters the fracture and what leaves it, and profiles, from
# postProcessing/clayRim/0. Run in the case:
#     gnuplot <bentoFoam>/etc/plots/clayRim.gp
# With a run of the pseudo-steady model in runs/pseudoSteady, that too
set encoding utf8
set terminal pngcairo size 1320, 500 font "sans,13"

folder = "postProcessing/clayRim/0/"
history = folder."history.dat"
profiles = folder."profiles.dat"
other = "runs/pseudoSteady/".history
if (system("test -s ".history." && echo 1 || echo 0") + 0 == 0) {
    print "No ".history.": has clayRimDict an expansion?"
    exit status 1
}
system("mkdir -p plots")
set output "plots/clayRim.png"
compares = system("test -e ".other." && echo 1 || echo 0") + 0
blocks = system("grep -c time ".profiles) + 0
year(k) = system(sprintf("LC_ALL=C.UTF-8 awk '/time/ { if (n++ == %d) printf \"%%.0f\", $3 }' %s", k, profiles))

set multiplot layout 1, 3 margins 0.055, 0.985, 0.13, 0.91 spacing 0.075
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set key samplen 2.2 spacing 1.2
set format "10^{%T}"
set logscale xy

set title "how far the gel has swollen"
set xlabel "time [a]"
set ylabel "radius of the rim r_R [m]"
set key top left Left reverse
set format y "%g"
if (compares) {
    plot history using 1:2 with lines lw 3 lc rgb 0x0072B2 title "full model", \
        other using 1:2 with lines lw 2.5 dt 2 lc rgb 0xE69F00 title "pseudo-steady"
} else {
    plot history using 1:2 with lines lw 3 lc rgb 0x0072B2 notitle
}

set title "clay that enters the fracture and leaves it"
set ylabel "rate [kg/a]" offset 1
set format y "10^{%T}"
set key top right Right noreverse
plot history using 1:4 with lines lw 3 lc rgb 0x0072B2 title "enters the fracture", \
    history using 1:5 with lines lw 3 lc rgb 0xD55E00 title "eroded at the rim"

unset logscale
set logscale y
set yrange [0.003:1]
set title "solid fraction of the gel"
set xlabel "radius [m]"
set ylabel "solid fraction [-]" offset 0
set format x "%g"
set format y "%g"
set palette defined (0 "#56B4E9", 0.5 "#0072B2", 1 "#1b1b3a")
unset colorbox
set key top right Right noreverse
plot for [k = 0:blocks - 1] profiles index k using 1:2 with lines lw 2.5 \
    lc palette frac (blocks > 1 ? k/(blocks - 1.0) : 0) title year(k)." a"
unset multiplot
