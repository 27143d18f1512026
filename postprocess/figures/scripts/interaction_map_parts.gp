# SPDX-License-Identifier: GPL-3.0-or-later
# The parts of the interaction map, one panel a nodal diameter.
# Reads what map.gp does; panel_columns, panel_rows, panels, panel_nodal_diameter[], panel_title[].
load 'scripts/map.gp'
set multiplot layout panel_rows,panel_columns margins screen 0.07,0.875,0.09 + (panel_rows == 1 ? 0.1 : 0),0.95 - (panel_rows == 1 ? 0.03 : 0) spacing screen 0.035,0.10
set xtics rotate by 35 right font tiny_font
set ytics font tiny_font
set cblabel 'amplitude [mm]'
set colorbox user origin screen 0.895,0.09 size screen 0.018,0.86
do for [i=1:panels] {
  n = int(panel_nodal_diameter[i])
  set title panel_title[i] offset 0,-0.6
  if ((i - 1)%panel_columns == 0) {
    set ylabel 'frequency [Hz]'
    set format y '%g'
  } else {
    unset ylabel
    set format y ''
  }
  if (i + panel_columns > panels) {
    set xlabel 'speed [rpm]' offset 0,0.3
  } else {
    unset xlabel
  }
  plot sprintf('%s_%d.pixels', name, n) @map_image, \
    for [k=engine_order_step:engine_order_last:engine_order_step] k*x/60 with lines linestyle map_engine_order, \
    for [k=1:families] $modes using 1:mode_column(n,k) with lines linestyle map_mode
  unset colorbox
}
unset multiplot
