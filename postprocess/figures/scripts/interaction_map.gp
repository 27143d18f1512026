# SPDX-License-Identifier: GPL-3.0-or-later
# Amplitude over speed and frequency.
# Reads what map.gp does; $irregular, $subharmonic, $breaking: speeds [rpm] marked at the foot, and $outside at the top;
# $family_labels:
# frequency [Hz] where a line of nodal diameter 0 begins; $critical: speed [rpm], frequency [Hz].
load 'scripts/map.gp'
foot(row) = (0.018 + 0.022*row)*frequency_high
set key opaque fillcolor rgb map_key_colour textcolor rgb map_key_text at screen 0.45,0.985 center top horizontal maxrows 1 samplen 0.5
set lmargin at screen 0.085
set rmargin at screen 0.815
set tmargin at screen 0.895
set bmargin at screen 0.11
set xlabel 'speed [rpm]'
set ylabel 'frequency in the rotor frame [Hz]'
set cblabel 'amplitude [mm]'
set colorbox user origin screen 0.885,0.11 size screen 0.022,0.785
load 'scripts/engine_orders.gp'
plot name.'.pixels' @map_image, \
  for [k=engine_order_step:engine_order_last:engine_order_step] k*x/60 with lines linestyle map_engine_order, \
  for [n=0:nodal_diameters-1] for [k=1:families] $modes using 1:mode_column(n,k) with lines linestyle map_mode, \
  $critical using 1:2 with points linestyle map_critical title titled(critical_rows, 'critical speed'), \
  $irregular using 1:(foot(0)) with points linestyle map_irregular title titled(irregular_rows, 'does not repeat'), \
  $subharmonic using 1:(foot(1)) with points linestyle map_subharmonic \
    title titled(subharmonic_rows, 'subharmonic'), \
  $breaking using 1:(foot(2)) with points linestyle map_breaking \
    title titled(breaking_rows, 'breaks the symmetry'), \
  $outside using 1:(0.99*frequency_high) with points linestyle map_outside title titled(outside_rows, 'outside validity'), \
  $family_labels using (speed_low):1:(sprintf('family %d', $0 + 1)) with labels \
    left offset 0.6,0.5 font tiny_font textcolor rgb map_family_text
