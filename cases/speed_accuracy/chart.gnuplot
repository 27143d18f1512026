# SPDX-License-Identifier: GPL-3.0-or-later
# Error of the settled response over what a revolution costs; columns of the tables: see their second line.
set terminal svg size 1300,1250 font "sans,13" background "white"
set output "chart.svg"
set datafile separator "\t"
set datafile missing "nan"
set logscale xy
set format "10^{%T}"
set grid back lc rgb "#dddddd"
set key outside right font ",11"
files = "accuracy_fast.tsv accuracy_made.tsv"
titles = '"Fast impeller" "Made-up wheel, 900 dofs"'
schemes = "trigonometric central_differences paper moreau_jean penalty_1 penalty_10 residual_flexibility"
colours = "#0060ad #dd181f #ff9900 #109618 #cc66cc #990099 #00aaaa"
rows(file, group, name) = sprintf("< awk -F'\t' '$1 == \"%s\" && $2 == \"%s\"' %s", group, name, file)
set multiplot layout 3,2
do for [i = 1:2] {
  file = word(files, i)
  do for [cost = 6:7] {
    set title word(titles, i)
    set xlabel cost == 6 ? "processor time of a revolution [ms]" : "multiplications of a revolution"
    set ylabel "relative error"
    plot for [s = 1:7] rows(file, "scheme", word(schemes, s)) using cost:5 with linespoints pt 7 ps 0.6 lw 1.5 lc rgb word(colours, s) title word(schemes, s) noenhanced, \
      rows(file, "full", "all_nodal_diameters") using cost:5 with linespoints pt 6 ps 0.6 dt 2 lc rgb "#0060ad" title "all nodal diameters", \
      rows(file, "default", "trigonometric") using cost:5 with points pt 6 ps 2.2 lw 2 lc rgb "black" title "the default"
  }
}
do for [i = 1:2] {
  file = word(files, i)
  set title word(titles, i) . ", 1440 steps a revolution"
  set xlabel "modes with mass, a nodal diameter"
  plot rows(file, "modes", "quasi_static") using 4:5 with linespoints pt 7 lc rgb "#00aaaa" title "others quasi-static", \
    rows(file, "modes", "dropped") using 4:5 with linespoints pt 7 lc rgb "#888888" title "others dropped"
}
unset multiplot
