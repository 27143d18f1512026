# SPDX-License-Identifier: GPL-3.0-or-later
# Natural frequencies over speed, engine orders, and where the linear rules see them cross.
# Reads speed_low, speed_high [rpm], frequency_high [Hz], range_low, range_high [rpm] (simulated), engine_order_step,
# engine_order_last, nodal_diameters, families; $modes: speed [rpm], then the families of nodal diameter 0 [Hz], those
# of 1, ..; moves[], 1 for each nodal diameter that can; $aliased, $equation_2: crossings, and $critical, what was computed: speed [rpm],
# frequency [Hz]; $family_labels: frequency [Hz], first and last family.
family_name(first, last) = first == last ? sprintf('family %d', first) : sprintf('families %d-%d', first, last)
set style textbox opaque noborder margins 0.2,0.2 fillcolor rgb paper_colour
mode_column(n, k) = 1 + n*families + k  # of $modes, k from 1
set xrange [speed_low:speed_high]
set yrange [0:frequency_high]
set lmargin at screen 0.085
set rmargin at screen 0.91
set tmargin at screen 0.86
set bmargin at screen 0.11
set xlabel 'speed [rpm]'
set ylabel 'frequency in the rotor frame [Hz]'
set key at screen 0.5,0.985 center top horizontal maxrows 2 font small_font
set object 1 rectangle from range_low,0 to range_high,frequency_high fillcolor rgb range_colour fillstyle solid \
  noborder behind
load 'scripts/engine_orders.gp'
plot for [k=engine_order_step:engine_order_last:engine_order_step] k*x/60 with lines linestyle engine_order_line, \
  for [n=0:nodal_diameters-1] for [k=1:families] $modes using 1:(moves[n + 1] > 0 ? NaN : column(mode_column(n,k))) with lines \
    linestyle engine_order_line, \
  for [n=0:nodal_diameters-1] for [k=1:families] $modes using 1:(moves[n + 1] > 0 ? column(mode_column(n,k)) : NaN) with lines \
    linewidth mode_width linecolor rgb series_colour(n) title (k == 1 && moves[n + 1] > 0 ? sprintf('ND %d', n) : ''), \
  $aliased using 1:2 with points linestyle crossing_aliased title titled(aliased_rows, 'rule with aliasing'), \
  $equation_2 using 1:2 with points linestyle crossing_linear title titled(equation_2_rows, 'eq. 2'), \
  $critical using 1:2 with points linestyle critical_speed title titled(critical_rows, 'critical speed'), \
  $family_labels using (speed_low):1:(family_name($2, $3)) with labels boxed left offset 0.6,0.45 font tiny_font textcolor rgb family_text
