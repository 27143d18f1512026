# SPDX-License-Identifier: GPL-3.0-or-later
# The interaction maps of this report and of another one, side by side.
# Reads what map.gp does; map_title[2].
load 'scripts/map.gp'
set multiplot layout 1,2 margins screen 0.085,0.875,0.15,0.9 spacing screen 0.03,0
set xlabel 'speed [rpm]'
set xtics rotate by 35 right
set cblabel 'amplitude [mm]'
set colorbox user origin screen 0.895,0.15 size screen 0.02,0.75
do for [i=1:2] {
  set title map_title[i] offset 0,-0.4
  if (i == 1) {
    set ylabel 'frequency in the rotor frame [Hz]'
    set format y '%g'
  } else {
    unset ylabel
    set format y ''
  }
  plot sprintf('%s_%d.pixels', name, i) @map_image, \
    for [k=engine_order_step:engine_order_last:engine_order_step] k*x/60 with lines linestyle map_engine_order, \
    for [n=0:nodal_diameters-1] for [k=1:families] $modes using 1:mode_column(n,k) with lines linestyle map_mode
  unset colorbox
}
unset multiplot
