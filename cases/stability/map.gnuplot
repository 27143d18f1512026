# SPDX-License-Identifier: GPL-3.0-or-later
# Scheme over step; a square a run.
set terminal svg size 900,520 font "sans,13" background "white"
set output "map.svg"
set datafile separator "\t"
set logscale x 2
set xlabel "steps a revolution"
set xtics (240, 480, 960, 1920, 3840, 7680, 15360)
set xrange [180:22000]
set yrange [-0.7:9.7] reverse
set key outside below horizontal
verdicts = "stable inaccurate refused blown_up"
colours = "#109618 #ff9900 #999999 #dd181f"
plot for [v = 1:4] "stability.tsv" using 3:(strcol(4) eq word(verdicts, v) ? $1 : NaN):ytic(strcol(2)) with points pt 5 ps 2.4 lc rgb word(colours, v) title word(verdicts, v) noenhanced
