# bentoFoam, GPL-3.0-or-later
# What uncertain inputs make of the rate of erosion, by clayRim -sweep: a tornado
# and a band of percentiles, from postProcessing/clayRim/0. Run in the case:
#     gnuplot <bentoFoam>/etc/plots/clayRimSweep.gp
set encoding utf8
set terminal pngcairo size 1320, 540 font "sans,13"
system("mkdir -p plots")
set output "plots/clayRimSweep.png"

folder = "postProcessing/clayRim/0/"
tornado = folder."tornado.dat"
band = folder."percentiles.dat"
samples = folder."samples.dat"
base = system("LC_ALL=C.UTF-8 awk '!/^#/ { print $7; exit }' ".tornado) + 0
at(p) = system(sprintf("LC_ALL=C.UTF-8 awk '$1 == %d { print $2 }' %s", p, band)) + 0
# Of rates in the tornado, with the case's among them
extreme(sign) = system(sprintf("LC_ALL=C.UTF-8 awk '!/^#/ { for (i = 5; i <= 7; ++i) if ($i > 0 && (!n++ || %s$i > %sx)) x = $i } END { print x }' %s", sign, sign, tornado)) + 0
lowest = extreme("-")
highest = extreme("")
rows = system("grep -vc '^#' ".tornado) + 0
left = system("LC_ALL=C.UTF-8 awk '!/^#/ && $NF < 0 { ++n } END { print n + 0 }' ".samples) + 0

set multiplot
set bmargin at screen 0.12
set tmargin at screen 0.91
set grid x lt 1 lw 1 lc rgb "#e4e4e4"
set logscale x
set format x "10^{%T}"
set xlabel "erosion [kg/a]"

set lmargin at screen 0.115
set rmargin at screen 0.545
set title "each input at the ends of its range"
set yrange [rows - 0.4:-1.15]
set ytics scale 0
# Room for the ends' values beside the bars
room = (highest/lowest)**0.33
set xrange [lowest/room:highest*room]
set key at graph 0.98, graph 0.985 right top horizontal samplen 1.2
set style fill solid noborder
set arrow 1 from base, -0.6 to base, rows - 0.4 nohead lw 2 lc rgb "#444444" front
written(unit) = unit eq "(-)" ? "" : " ".unit
end(x, unit) = sprintf("%.3g", x).written(unit)
# A bar from the case to each end; the label on the side where the end lies
low(x, y) = x < y ? x : y
high(x, y) = x > y ? x : y
plot tornado using (low($5, base)):($0):(low($5, base)):(high($5, base)):($0 - 0.32):($0 - 0.0):ytic(1) \
        with boxxyerror lc rgb 0x56B4E9 title "lower end", \
    tornado using (low($6, base)):($0):(low($6, base)):(high($6, base)):($0 + 0.0):($0 + 0.32) \
        with boxxyerror lc rgb 0xE69F00 title "upper end", \
    tornado using ($5 > 0 && $5 < base ? $5 : NaN):($0 - 0.16):(end($3, strcol(2))." ") with labels right font ",11" notitle, \
    tornado using ($5 >= base ? $5 : NaN):($0 - 0.16):(" ".end($3, strcol(2))) with labels left font ",11" notitle, \
    tornado using ($6 > 0 && $6 < base ? $6 : NaN):($0 + 0.16):(end($4, strcol(2))." ") with labels right font ",11" notitle, \
    tornado using ($6 >= base ? $6 : NaN):($0 + 0.16):(" ".end($4, strcol(2))) with labels left font ",11" notitle

unset arrow 1
unset style
set lmargin at screen 0.625
set rmargin at screen 0.985
set title sprintf("all inputs at random in their ranges%s", left > 0 ? sprintf("; %d samples whose clay coagulates left out", left) : "")
set grid y lt 1 lw 1 lc rgb "#e4e4e4"
set ytics autofreq scale 1 0, 20, 100
set ylabel "samples with less [%]" offset 1
set yrange [0:100]
set xrange [at(1)/1.3:at(99)*1.3]
set arrow 1 from base, 0 to base, 100 nohead lw 2 lc rgb "#444444" front
set object 1 rectangle from at(5), graph 0 to at(95), graph 1 fc rgb "#e8f0f6" fs solid noborder behind
set object 2 rectangle from at(25), graph 0 to at(75), graph 1 fc rgb "#c9dcea" fs solid noborder behind
set key default
set key inside top left Left reverse vertical samplen 2 spacing 1.2
set style fill solid noborder
plot band using 2:1 with lines lw 3 lc rgb 0x0072B2 title gprintf("median %.1t×10^{%T} kg/a", at(50)), \
    NaN with boxes fc rgb "#c9dcea" title "25 to 75 %", \
    NaN with boxes fc rgb "#e8f0f6" title "5 to 95 %", \
    NaN with lines lw 2 lc rgb "#444444" title "the case itself"
unset multiplot
