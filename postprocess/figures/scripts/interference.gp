# SPDX-License-Identifier: GPL-3.0-or-later
# Frequencies over the nodal diameter without spin and at two speeds, with the zig-zag of the engine orders.
# Reads nodal_diameters, sectors, families, frequency_high [Hz], panel_title[], engine_orders[] (drawn in each panel);
# $modes: nodal diameter, then the families [Hz], sheets: without spin, left, right; $zigzag, a sheet a panel: nodal
# diameter, frequency [Hz], engine order, whether the casing drives it; $family_labels, a sheet a panel: frequency [Hz],
# first and last family.
family_name(first, last) = first == last ? sprintf('family %d', first) : sprintf('families %d-%d', first, last)
set style textbox opaque noborder margins 0.2,0.2 fillcolor rgb paper_colour
few_orders = 12  # more, and only those that the casing drives are named
rises(order) = 2*(int(order)%sectors) < sectors  # with the engine order, from the one before
named(order, driven, count) = count > few_orders ? driven > 0 : order > 0
order_name(order) = sprintf('EO %d', order)
set multiplot layout 1,2 margins screen 0.085,0.98,0.11,0.86 spacing screen 0.07,0.1
set xrange [-0.3:nodal_diameters - 1 + 0.2*nodal_diameters]  # room for names
set yrange [0:frequency_high]
set xtics 0,1,nodal_diameters-1
set xlabel 'nodal diameter'
set ylabel 'frequency in the rotor frame [Hz]'
set key at screen 0.53,0.985 center top horizontal maxrows 1
do for [p=1:2] {
  set title panel_title[p] offset 0,-0.5
  # Names beside the zig-zag: below it where it rises with the engine order, above it where it falls.
  plot $zigzag index p-1 using 1:2 with lines linestyle zigzag_line title 'engine orders', \
    for [k=1:families] for [s=0:1] $modes index s*p using 1:k+1 with linespoints \
      linestyle (s == 0 ? modes_standing_still : modes_spinning) \
      title (k > 1 ? '' : s == 0 ? 'modes at rest' : 'modes at speed'), \
    $zigzag index p-1 using ($4 > 0 ? $1 : NaN):2 with points linestyle driven_corner title 'driven by the casing', \
    $family_labels index p-1 using (nodal_diameters-1):1:(family_name($2, $3)) with labels \
      boxed left offset 0.9,0 font tiny_font textcolor rgb family_text, \
    $zigzag index p-1 using 1:2:(named($3, $4, engine_orders[p]) && rises($3) ? order_name($3) : '') with labels \
      boxed left offset 0.8,-0.3 font tiny_font textcolor rgb corner_text, \
    '' index p-1 using 1:2:(named($3, $4, engine_orders[p]) && !rises($3) ? order_name($3) : '') with labels \
      boxed left offset 0.8,0.4 font tiny_font textcolor rgb corner_text
  unset ylabel
  unset key
}
unset multiplot
