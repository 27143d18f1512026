# SPDX-License-Identifier: GPL-3.0-or-later
# What is left of response, class and cost when damping falls; columns: see the tables' first line.
set terminal svg size 1300,1000 font "sans,13" background "white"
set output "damping.svg"
set datafile separator "\t"
set datafile missing "nan"
set grid back lc rgb "#dddddd"
names = '"same" "2 %"'
titles = '"the same on every mode" "2 % above the resolved frequency"'
colours = "#dd181f #0060ad"
ratios = "0.05 0.1 0.2 0.5 1 2"
shades = "#440154 #414487 #2a788e #22a884 #7ad151 #e6c000"
of(name) = sprintf("< awk -F'\t' '$1 == \"%s\"' damping.tsv", name)
at(name, ratio) = sprintf("< awk -F'\t' '$1 == \"%s\" && $2 == %s' speeds.tsv", name, ratio)
set multiplot layout 2,2
set ylabel "amplitude [mm]"
set xlabel "speed [rev/min]"
set format x "%.0f"
set yrange [0:0.55]
set xtics 2000
do for [i = 1:2] {
  set title "Damping: ".word(titles, i)
  set key top right title "damping"
  plot for [r = 1:6] at(word(names, i), word(ratios, r)) using 3:4 with linespoints pt 7 ps 0.5 lw 1.5 lc rgb word(shades, r) title word(ratios, r)." %"
}
set key outside below horizontal maxrows 1 samplen 1 width -1 font ",11" title ""
set xlabel "damping [% of critical]" offset 0,0.4
set title "Left bars: the same on every mode; right: 2 % above the resolved"
set ylabel "speeds of 12"
set yrange [0:12]
set xrange [-0.6:5.6]
set xtics ("0.05" 0, "0.1" 1, "0.2" 2, "0.5" 3, "1" 4, "2" 5)
set boxwidth 0.34
set style fill solid 0.9
classes = '"periodic" "subharmonic" "modulated" "broadband" "not settled"'
fills = "#109618 #9acd32 #ff9900 #dd181f #999999"
# From the whole bar down, so that each class covers what lies below it.
plot for [k = 5:1:-1] for [i = 1:2] of(word(names, i)) using ($0 + 0.38 * i - 0.57):(sum [c = 3:2 + k] column(c)) with boxes lc rgb word(fills, k) title (i == 1 ? word(classes, k) : "")
set key inside top right vertical maxrows auto samplen 4 width 0 font ",13"
set format x "%g"
set logscale x
set xrange [0.04:2.5]
set yrange [0:22]
set xtics (0.05, 0.1, 0.2, 0.5, 1, 2)
set xlabel "damping [% of critical]"
set title "Cost of 12 speeds on one core"
set ylabel "processor time [s]"
plot for [i = 1:2] of(word(names, i)) using 2:11 with linespoints pt 7 lw 1.5 lc rgb word(colours, i) title word(titles, i)
unset multiplot
