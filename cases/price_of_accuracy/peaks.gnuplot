# SPDX-License-Identifier: GPL-3.0-or-later
# Errors of whole sweeps at three critical speeds over the chain's processor time. What the next coarser mesh changes in the
# reference is its uncertainty there: a dashed line. Smaller errors mean nothing and are drawn hollow.
set terminal svg size 1380,460 font "sans-serif,13" background rgb "white"
set output "peaks.svg"
set datafile separator "\t"
set border 31 linecolor rgb "#444444"
set grid linecolor rgb "#dddddd"
set logscale xy
set format y "%g %%"
quantities = '"critical speed" "motion of the tip" "alternating stress"'
colours = "#0072b2 #d55e00 #009e73"
symbols = "7 5 9"  # filled; the hollow ones precede them
least = 0.1  # per cent: what is closer to the reference stands here
of(k, group) = sprintf("awk -F '\t' '$1 == \"%s\" && $5 == %d && $10 != \"\"' peaks.tsv", group, k)
rows(k, group) = "< ".of(k, group)
uncertainty(k, q) = real(system(of(k, "finest").sprintf(" | awk -F '\t' '$2 ~ /^16/ {print 100*$%d}'", 9 + q)))
peak(k) = system(of(k, "finest").sprintf(" | awk -F '\t' 'NR == 1 {printf \"%%s, %%.0f rpm\", $9, $6}'"))
per_cent(q) = 100*column(9 + q) > least ? 100*column(9 + q) : least
set multiplot
do for [q = 1:3] {
  set lmargin at screen 0.07 + (q - 1)*0.265
  set rmargin at screen 0.07 + (q - 1)*0.265 + 0.2
  set tmargin at screen 0.92
  set bmargin at screen 0.13
  set title word(quantities, q) offset 0,-0.5
  set xlabel "processor time of the chain [s]"
  set ylabel (q == 1 ? "whole settings: error" : "")
  set xrange [40:200]
  set xtics (40, 60, 80, 100, 150, 200)
  set yrange [least:100]
  if (q == 3) { set key at screen 0.81,0.92 left top Left reverse spacing 1.5 } else { unset key }
  plot for [k = 1:3] rows(k, "combination") using 4:(per_cent(q) > uncertainty(k, q) ? per_cent(q) : NaN) \
      with points pointtype int(word(symbols, k)) linecolor rgb word(colours, k) title peak(k), \
    for [k = 1:3] rows(k, "combination") using 4:(per_cent(q) > uncertainty(k, q) ? NaN : per_cent(q)) \
      with points pointtype int(word(symbols, k)) - 1 linecolor rgb word(colours, k) notitle, \
    for [k = 1:3] uncertainty(k, q) with lines dashtype 2 linecolor rgb word(colours, k) notitle, \
    keyentry with points pointtype 6 linecolor rgb "#444444" title "below the uncertainty", \
    keyentry with lines dashtype 2 linecolor rgb "#444444" title "uncertainty of the reference"
}
unset multiplot
