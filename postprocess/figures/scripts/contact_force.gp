# SPDX-License-Identifier: GPL-3.0-or-later
# Force on sector 0 over one revolution (above) and its spectrum (below).
# Reads engine_order_max; $lines: engine order, amplitude at the leading and at the trailing edge [N]. The figure's
# table: rotor angle [deg], force at the leading and at the trailing edge [N].
apart = 0.06  # of an engine order: the two edges stand side by side
set multiplot
set lmargin at screen 0.085
set rmargin at screen 0.97
set tmargin at screen 0.92
set bmargin at screen 0.58
set xrange [0:360]
set xtics 45
set yrange [0:*]
set xlabel 'rotor angle [deg]'
set ylabel 'force [N]'
set key at screen 0.97,0.96 right center horizontal
plot figure_table skip 1 using 1:2 with lines linestyle leading_force title 'leading edge', \
  '' skip 1 using 1:3 with lines linestyle trailing_force title 'trailing edge'
set tmargin at screen 0.44
set bmargin at screen 0.12
set xlabel 'engine order'
set ylabel 'amplitude [N]'
set xrange [-0.5:engine_order_max + 0.5]
set xtics 2
unset key
plot $lines using ($1-apart):2 with impulses linestyle leading_impulse, \
  '' using ($1+apart):3 with impulses linestyle trailing_impulse
unset multiplot
