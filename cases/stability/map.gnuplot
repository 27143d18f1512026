# SPDX-License-Identifier: GPL-3.0-or-later
# Scheme over step; a square a run.
set terminal svg size 900,560 font "sans,13" background "white"
set output "map.svg"
set datafile separator "\t"
set logscale x 2
set xlabel "steps a revolution"
set xtics (240, 480, 960, 1920, 3840, 7680, 15360)
set xrange [180:22000]
set ytics () noenhanced
set yrange [-0.7:9.7] reverse
names = "trigonometric residual_flexibility_20 moreau_jean central_differences paper penalty_10 penalty_100 penalty_1000 trigonometric_8_modes trigonometric_40_modes"
do for [i = 1:10] { set ytics add (word(names, i) i - 1) }
set key outside below horizontal font ",11" width -3
set bmargin 5
verdicts = "stable inaccurate refused blown_up"
colours = "#109618 #ff9900 #999999 #dd181f"
plot for [v = 1:4] "stability.tsv" using 3:(strcol(4) eq word(verdicts, v) ? $1 : NaN) with points pt 5 ps 2.4 lc rgb word(colours, v) title word(verdicts, v) noenhanced
