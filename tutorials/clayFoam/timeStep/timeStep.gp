# bentoFoam, GPL-3.0-or-later
# Displacement of the middle one of three platelets over time, from runs/
set encoding utf8
set terminal pngcairo size 1200, 600 font "sans,13"
set output "plots/timeStep.png"

# Along the curve of the force, sinh(kappa d): tanh(kappa d/2) falls
# exponentially. kappa in 1/h0, lambda in 1/us
kappa = 0.734
lambda = 2*7.34e6*1500*3.14159265e-14*exp(-kappa)/1.2e-9*1e-6
exact(t) = 2/kappa*atanh(tanh(0.1*kappa/2)*exp(-lambda*t))
growth(dt) = 1 - lambda*dt

file(name) = sprintf("runs/%s/displacement", name)
steps = "2e-6 5e-6 1e-5"
own = "auto RKC2 BogackiShampine AdamsBashforth2"
array dt[3] = [2, 5, 10]     # [us]
array colour[3] = [0x0072B2, 0xE69F00, 0xD00000]
array ownColour[4] = [0x000000, 0x009E73, 0xCC79A7, 0x56B4E9]
array symbol[4] = [6, 4, 8, 12]

set multiplot layout 1, 2 margins 0.075, 0.985, 0.115, 0.93 spacing 0.085
set grid lt 1 lw 1 lc rgb "#e4e4e4"
set xlabel "time [µs]"
set xrange [0:31]
set samples 400
set key samplen 2.5 spacing 1.15 Left reverse

set title "Euler's method (as TR-17-13, Fig. 3-4)"
set ylabel "displacement of the middle platelet [h_0 = 0.1 µm]"
set yrange [-0.68:0.45]
set key bottom left
plot 0 with lines lw 1 lc rgb "#999999" notitle, \
    exact(x) with lines lw 2 dt 2 lc rgb "#000000" title "exact", \
    for [k = 3:1:-1] file("Euler-" . word(steps, k)) using ($1*1e6):2 \
        with linespoints lw 2.5 pt 7 ps 1.2 lc rgb colour[k] \
        title sprintf("{/Symbol D}t = %g µs: × %.3f a step", \
            dt[k], growth(dt[k]))

set title "its size; open symbols: integrators, flow step 10 µs"
set ylabel "|displacement| [h_0]"
set logscale y
set format y "10^{%T}"
set yrange [1e-9:3]
plot exact(x) with lines lw 2 dt 2 lc rgb "#000000" title "exact", \
    for [k = 1:3] 0.1*abs(growth(dt[k]))**(x/dt[k]) \
        with lines lw 1.5 lc rgb colour[k] \
        title sprintf("0.1 |1 - {/Symbol l}{/Symbol D}t|^n, {/Symbol D}t = %g µs", dt[k]), \
    for [k = 1:3] file("Euler-" . word(steps, k)) using ($1*1e6):(abs($2)) \
        with points pt 7 ps 1.2 lc rgb colour[k] notitle, \
    for [k = 1:4] file(word(own, k) . "-1e-5") using ($1*1e6):(abs($2)) \
        with points pt symbol[k] ps 1.2 + 0.5*k lw 2.5 lc rgb ownColour[k] title word(own, k)
unset multiplot
