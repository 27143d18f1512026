# SPDX-License-Identifier: GPL-3.0-or-later
# Where an edge rubs, over speed (above); contrast and number of separate places (below).
# Reads speed_low, speed_high [rpm], pixel_columns, pixel_rows; drift_lobes (0: no line), drift_start [deg],
# drift_slope [deg/rpm]; cut [deg], where the map begins; places_high, places_tics. The figure's table: speed [rpm], contrast [1], places.
set palette defined (@contact_palette)
set object 99 rectangle from graph 0,0 to graph 1,1 fillcolor rgb missing_colour fillstyle solid noborder behind
set xrange [speed_low:speed_high]
set multiplot
unset grid
set lmargin at screen 0.085
set rmargin at screen 0.86
set tmargin at screen 0.97
set bmargin at screen 0.33
set yrange [cut:cut + 360]
unset ytics
set ytics ()
do for [angle=0:675:45] {
  if (angle >= cut && angle <= cut + 360) { set ytics add (sprintf('%d', angle % 360) angle) }
}
set format x ''
set cbrange [0:1]
set ylabel 'angle on the casing [deg]'
set cblabel 'share of steps in contact [1]'
set colorbox user origin screen 0.885,0.33 size screen 0.022,0.64
dx = (speed_high - speed_low)/pixel_columns
dy = 360.0/pixel_rows
wrapped(angle) = angle - 360*floor((angle - cut)/360)  # a line that leaves at the top comes in below
plot name.'.pixels' binary array=(pixel_columns,pixel_rows) format='%float32' origin=(speed_low + dx/2,cut + dy/2) \
    dx=dx dy=dy with image, \
  for [lobe=0:drift_lobes-1] wrapped(drift_start + 360.0*lobe/drift_lobes + drift_slope*x) with points \
    linestyle contact_drift
unset object 99
set grid
set tmargin at screen 0.30
set bmargin at screen 0.12
set format x '%g'
set xlabel 'speed [rpm]'
set yrange [0:1.05]
unset ytics
set ytics 0.5 nomirror
set ylabel 'contrast [1]'
set y2range [0:places_high]
set y2tics places_tics nomirror
set y2label 'places'
set key at screen 0.85,0.315 right center horizontal
plot figure_table skip 1 using 1:2 with linespoints linestyle contrast_line title 'contrast', \
  '' skip 1 using 1:3 axes x1y2 with steps linestyle places_line title 'places'
unset multiplot
