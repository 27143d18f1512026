# SPDX-License-Identifier: GPL-3.0-or-later
# The peak over speed with each coefficient, and over the coefficient; columns: see the tables' first line.
set terminal svg size 1300,1000 font "sans,13" background "white"
set output "friction.svg"
set datafile separator "\t"
set grid back lc rgb "#dddddd"
coefficients = "0 0.05 0.1 0.15 0.2"
shades = "#440154 #414487 #2a788e #22a884 #7ad151"
at(friction) = sprintf("< awk -F'\t' '$1 == \"%s\"' speeds.tsv", friction)
set multiplot layout 2,2
set xlabel "speed [rev/min]"
set ylabel "amplitude along the normal [mm]"
set yrange [0:]
set key top left title "friction"
plot for [i = 1:5] at(word(coefficients, i)) using 2:3 with linespoints pt 7 ps 0.4 lw 1.5 lc rgb word(shades, i) title word(coefficients, i)
unset key
set xlabel "coefficient of friction"
set xrange [-0.01:0.21]
set yrange [*:*]
set ylabel "critical speed [rev/min]"
plot "friction.tsv" using 1:2 with linespoints pt 7 lw 1.5 lc rgb "#0060ad"
set yrange [0:]
set ylabel "stress of the vibration [MPa]"
plot "friction.tsv" using 1:5 with linespoints pt 7 lw 1.5 lc rgb "#0060ad"
set ylabel "mean power of friction [kW]"
plot "friction.tsv" using 1:7 with linespoints pt 7 lw 1.5 lc rgb "#0060ad"
unset multiplot
