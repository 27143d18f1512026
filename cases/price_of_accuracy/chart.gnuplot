# SPDX-License-Identifier: GPL-3.0-or-later
# Errors over the chain's processor time: above whole settings against the reference, below one knob at a time.
set terminal svg size 1380,900 font "sans-serif,13" background rgb "white"
set output "chart.svg"
set datafile separator "\t"
set border 31 linecolor rgb "#444444"
set grid linecolor rgb "#dddddd"
set logscale xy
set format y "%g %%"
quantities = '"critical speed" "motion of the tip" "alternating stress"'
knobs = '"contact" "prestress" "modes" "step" "settling" "speeds" "scheme" "symmetry" "steady state"'
colours = "#d55e00 #009e73 #0072b2 #cc79a7 #999999 #000000 #e69f00 #56b4e9 #8c510a"
least = 1e-3  # per cent: what is closer to the reference stands here
per_cent(column_number) = column(column_number) > 1e-2*least ? 100*column(column_number) : least
# The cheapest that is as good: errors that fall with the price.
frontier(q) = sprintf("< sort -t '\t' -k 8,8g mesh.tsv | awk -F '\t' '$1 == \"combination\" && ($%d < best || !best) {best = $%d; printf \"%%s\\t%%s\\n\", $8, $%d}'", 12+q, 12+q, 12+q)
rows(file, group) = sprintf("< awk -F '\t' '$1 == \"%s\" && $8 > 0' %s", group, file)
# [%] What the next coarser mesh changes: smaller errors say nothing.
uncertainty(q) = real(system(sprintf("awk -F '\t' '$1 == \"finest\" && $2 ~ /^16/ {print 100*$%d}' mesh.tsv", 12+q)))
set multiplot
do for [q = 1:3] {
  set lmargin at screen 0.07 + (q - 1)*0.265
  set rmargin at screen 0.07 + (q - 1)*0.265 + 0.2
  set tmargin at screen 0.95
  set bmargin at screen 0.58
  set title word(quantities, q) offset 0,-0.5
  set xlabel "processor time of the chain [s]"
  set ylabel (q == 1 ? "whole settings: error" : "")
  set xrange [10:300]
  set xtics (10, 20, 50, 100, 200)
  set yrange [0.02:100]
  if (q == 3) { set key at screen 0.81,0.95 left top Left reverse spacing 1.5 } else { unset key }
  set object 1 rectangle from graph 0, graph 0 to graph 1, first uncertainty(q) behind fillstyle solid noborder fillcolor rgb "#e6e6e6"
  plot frontier(q) using 1:(100*$2) with steps linewidth 2 linecolor rgb "#0072b2" title "frontier of whole settings", \
    rows("mesh.tsv", "combination") using 8:(per_cent(12 + q)) with points pointtype 7 pointsize 0.9 linecolor rgb "#0072b2" title "a whole setting", \
    "" using 8:(per_cent(12 + q)):(strstrt(strcol(2), "the case") ? "" : word(strcol(2), 1)[1:strstrt(word(strcol(2)."", 1).",", ",") - 1]) with labels offset 0.8,0.6 font ",10" textcolor rgb "#0072b2" notitle, \
    rows("mesh.tsv", "combination") using (strcol(2)[1:16] eq "the case: points" ? $8 : NaN):(per_cent(12 + q)) with points pointtype 6 pointsize 2.2 linewidth 2 linecolor rgb "#000000" title "case's mesh, at points", \
    rows("mesh.tsv", "combination") using (strcol(2)[1:20] eq "the case, by default" ? $8 : NaN):(per_cent(12 + q)) with points pointtype 4 pointsize 2.2 linewidth 2 linecolor rgb "#000000" title "case's mesh, 10 segments", \
    rows("mesh.tsv", "finest") using (column(12 + q) > 0 ? $8 : NaN):(per_cent(12 + q)) with linespoints pointtype 8 linecolor rgb "#d55e00" title "the finest on each mesh", \
    keyentry with boxes fillstyle solid fillcolor rgb "#e6e6e6" title "uncertainty of the reference"
  unset object 1
  set tmargin at screen 0.45
  set bmargin at screen 0.08
  set ylabel (q == 1 ? "one knob at a time: error" : "") offset 1,0
  set xrange [10:300]
  set xtics (10, 20, 50, 100, 200)
  set yrange [least:100]
  if (q == 3) { set key at screen 0.81,0.45 left top Left reverse } else { unset key }
  plot for [k = 1:9] rows("knobs.tsv", word(knobs, k)) using 8:(per_cent(12 + q)) with points pointtype 4 + k pointsize 1 linewidth 1.5 linecolor rgb word(colours, k) title word(knobs, k)
}
unset multiplot
