# SPDX-License-Identifier: GPL-3.0-or-later
# Amplitudes of points (engine order, nodal diameter) over speed, panels one above the other.
# Reads speed_low, speed_high [rpm], height [px], panels, panel_title[], curves, curve_name[]; $curves, a sheet a panel:
# speed [rpm], mean [mm], then a column a curve [mm].
left = 0.1
right = 0.86
top = 0.96
foot = 30.0/height
panel_height = (top - foot)/panels
set xrange [speed_low:speed_high]
set multiplot
set yrange [0:*]
set offsets 0,0,graph 0.08,0
set lmargin at screen left
set rmargin at screen right
set ylabel 'amplitude [mm]'
do for [p=1:panels] {
  ceiling = top - (p - 1)*panel_height
  set tmargin at screen ceiling - 0.02
  set bmargin at screen ceiling - 0.82*panel_height
  set title panel_title[p] offset 0,-0.6
  set key at screen right + 0.01,ceiling - 0.02 left top Left reverse
  if (p == panels) { set xlabel 'speed [rpm]' }
  plot for [k=1:curves] $curves index p-1 using 1:k+2 with lines linewidth tracked_width \
      linecolor rgb series_colour(k - 1) title (curve_name[k] eq '' ? '' : curve_name[k]), \
    $curves index p-1 using 1:2 with lines linestyle tracked_mean title 'mean'
}
unset multiplot
