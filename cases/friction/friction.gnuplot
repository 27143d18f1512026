# SPDX-License-Identifier: GPL-3.0-or-later
# The peak of `wheel` over speed with each coefficient, and over the coefficient; columns: see the tables' first line.
set terminal svg size 1300,1500 font "sans,13" background "white"
set output wheel . ".svg"
set datafile separator "\t"
set grid back lc rgb "#dddddd"
coefficients = "0 0.05 0.1 0.15 0.2 0.25"
shades = "#440154 #414487 #2a788e #22a884 #7ad151 #c8b900"
gaps = "linear second_order"
names = "'linear' 'of second order'"
colours = "#0060ad #d55e00"
at(gap, friction) = sprintf("< awk -F'\t' '$1 == \"%s\" && $2 == \"%s\"' %s_speeds.tsv", gap, friction, wheel)
of(gap) = sprintf("< awk -F'\t' '$1 == \"%s\"' %s.tsv", gap, wheel)
set multiplot layout 3,2
set xlabel "speed [rev/min]"
set ylabel "amplitude along the normal [mm]"
stats wheel . "_speeds.tsv" using 3:4 skip 1 nooutput
set xrange [STATS_min_x:STATS_max_x]
set yrange [0:1.6*STATS_max_y]
set key top left title "friction"
do for [g = 1:2] {
  set title "gap: " . word(names, g)
  plot for [i = 1:words(coefficients)] at(word(gaps, g), word(coefficients, i)) using 3:4 with linespoints pt 7 ps 0.4 lw 1.5 lc rgb word(shades, i) title word(coefficients, i)
}
unset title
set key top left title "gap"
set xlabel "coefficient of friction"
set xrange [-0.01:0.26]
set yrange [*:*]
set ylabel "critical speed [rev/min]"
set key bottom left
plot for [g = 1:2] of(word(gaps, g)) using 2:3 with linespoints pt 7 lw 1.5 lc rgb word(colours, g) title word(names, g)
set key top left
set yrange [0:]
set ylabel "tip's motion |u| [mm]"
plot for [g = 1:2] of(word(gaps, g)) using 2:5 with linespoints pt 7 lw 1.5 lc rgb word(colours, g) title word(names, g)
set ylabel "stress of the vibration [MPa]"
plot for [g = 1:2] of(word(gaps, g)) using 2:6 with linespoints pt 7 lw 1.5 lc rgb word(colours, g) title word(names, g)
set ylabel "mean power of friction [kW]"
plot for [g = 1:2] of(word(gaps, g)) using 2:8 with linespoints pt 7 lw 1.5 lc rgb word(colours, g) title word(names, g)
unset multiplot
