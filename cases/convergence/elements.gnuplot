# SPDX-License-Identifier: GPL-3.0-or-later
set terminal svg size 1120,1000 font 'sans-serif,13' background rgb 'white'
set output 'elements.svg'
set datafile separator '\t'
set border 31 linecolor rgb '#444444'
set grid linecolor rgb '#dddddd'
set logscale xy
set format y '%g %%'
kinds = '"hex20" "hex20, graded" "hex27"'
colours = '#0072b2 #d55e00 #009e73'
edges = '"Leading edge" "Trailing edge"'
quantities = '"speed of the peak" "amplitude of the peak" "static compliance"'
aim(quantity) = quantity == 1 ? 1 : quantity == 2 ? 5 : NaN  # per cent
orders(quantity) = quantity == 3 ? 1 : 2
# Differences: two compliances, then of each engine order, 8 and 6, speed and amplitude of the leading edge and those of the trailing edge.
at(quantity, edge, order) = quantity == 3 ? 14 + edge : 16 + 4*(order - 1) + 2*(edge - 1) + quantity
per_cent(quantity, edge, order) = 100*abs(column(at(quantity, edge, order)))
set xrange [2:400]
set multiplot
do for [edge=1:2] {
  do for [quantity=1:3] {
    set lmargin at screen 0.09 + (edge - 1) * 0.375
    set rmargin at screen 0.09 + (edge - 1) * 0.375 + 0.30
    set tmargin at screen 0.965 - (quantity - 1) * 0.32
    set bmargin at screen 0.965 - (quantity - 1) * 0.32 - 0.25
    set title word(edges, edge).', '.word(quantities, quantity) offset 0,-0.5
    set xlabel (quantity == 3 ? 'mesh and reduce, processor time [s]' : '')
    set ylabel (edge == 1 ? 'difference to the largest' : '')
    set yrange [(quantity == 2 ? 0.05 : 0.005):(quantity == 2 ? 200 : 20)]
    if (edge == 2 && quantity == 1) { set key at screen 0.775,0.965 left top Left reverse } else { unset key }
    plot for [k=1:3] for [order=1:orders(quantity)] 'elements.tsv' \
      using (strcol(1) eq word(kinds, k) ? $4 : NaN):(per_cent(quantity, edge, order)) \
      with linespoints pointtype 5+order+(quantity == 3) pointsize 0.8 dashtype 3-order-(quantity == 3) linewidth 1.5 \
      linecolor rgb word(colours, k) title sprintf('%s, EO %d', word(kinds, k), order == 1 ? 8 : 6), \
      aim(quantity) with lines linecolor rgb '#000000' title 'aim'
  }
}
unset multiplot
