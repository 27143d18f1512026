# SPDX-License-Identifier: GPL-3.0-or-later
# Nodal diameters on one engine order (left), engine orders on one nodal diameter (right).
# Reads engine_order, nodal_diameter, nodal_diameters, engine_orders (how many). The figure's table: engine order, nodal
# diameter, backward or standing, forward [mm]; first the bars of the left panel, then those of the right one.
set multiplot
set boxwidth 0.7
set style fill solid noborder
set yrange [0:*]
set xtics 1
set tmargin at screen 0.83
set bmargin at screen 0.16
set ylabel 'amplitude [mm]'
set key at screen 0.54,0.95 center center horizontal maxrows 1
set lmargin at screen 0.105
set rmargin at screen 0.45
set title sprintf('EO %d', engine_order) offset 0,-0.5
set xlabel 'nodal diameter'
set xrange [-0.7:nodal_diameters - 0.3]
plot figure_table skip 1 every ::0::nodal_diameters-1 using 2:($3+$4) with boxes fillcolor rgb forward_colour \
    title 'forward', \
  '' skip 1 every ::0::nodal_diameters-1 using 2:3 with boxes fillcolor rgb backward_colour \
    title 'backward or standing'
unset key
set lmargin at screen 0.57
set rmargin at screen 0.975
set title sprintf('nodal diameter %d', nodal_diameter) offset 0,-0.5
set xlabel 'engine order'
set xrange [-0.7:engine_orders + 0.7]
plot figure_table skip 1 every ::nodal_diameters using 1:($3+$4) with boxes fillcolor rgb forward_colour, \
  '' skip 1 every ::nodal_diameters using 1:3 with boxes fillcolor rgb backward_colour
unset multiplot
