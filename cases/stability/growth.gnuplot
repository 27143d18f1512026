# SPDX-License-Identifier: GPL-3.0-or-later
# growth.tsv: what each scheme's equations foretell, lines, and what the march does, points.
set terminal svg size 1100,480 font "sans,12" background "white"
set output "growth.svg"
set datafile separator "\t"
set multiplot layout 1,2 title "Lines: predicted, points: measured" font ",12"
set key top left samplen 2
set xlabel "step over its limit"
set ylabel "growth, e-folds a step"
set xzeroaxis
plot for [i = 0:2] "growth.tsv" index i using 2:3 with lines lw 1.5 lc i + 1 title columnheader(1), \
     for [i = 0:2] "growth.tsv" index i using 2:4 with points pt 7 ps 0.7 lc i + 1 notitle
set ylabel
set xlabel "step over its limit; where there is none, h omega_{max} / 2"
plot for [i = 3:6] "growth.tsv" index i using 2:3 with lines lw 1.5 lc i + 1 title columnheader(1), \
     for [i = 3:6] "growth.tsv" index i using 2:4 with points pt 7 ps 0.7 lc i + 1 notitle
unset multiplot
