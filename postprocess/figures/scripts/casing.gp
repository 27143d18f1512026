# SPDX-License-Identifier: GPL-3.0-or-later
# The casing's shape, exaggerated, and the gap around it.
# Reads largest_distortion [mm]. The figure's table: angle [deg], gap at the leading and at the trailing edge [mm],
# distortion [mm].
drawn_distortion = 0.2  # of the circle's radius, for the largest
radius(distortion) = 1 - drawn_distortion*distortion/largest_distortion
ring = 0.45  # radius of the arrow that shows the rotation
set multiplot
set parametric
set trange [0:2*pi]
set size ratio -1
set lmargin at screen 0.02
set rmargin at screen 0.34
set tmargin at screen 0.95
set bmargin at screen 0.05
unset tics
unset border
unset grid
set xrange [-1.3:1.3]
set yrange [-1.3:1.3]
set label 1 'rotation' at 0,0 center textcolor rgb rotation_text
set arrow 1 from ring*cos(2.6),ring*sin(2.6) to ring*cos(2.75),ring*sin(2.75) head size 0.09,25 filled \
  linecolor rgb rotation_text
set samples 200
plot cos(t), sin(t) with lines linestyle round_casing, \
  ring*cos(0.4+0.35*t), ring*sin(0.4+0.35*t) with lines linestyle rotation_line, \
  figure_table skip 1 using (radius($4)*cos($1*pi/180)):(radius($4)*sin($1*pi/180)) with lines \
    linestyle casing_shape
unset label 1
unset arrow 1
unset parametric
set size noratio
load 'scripts/style.gp'  # frame, tics and grid again
set lmargin at screen 0.44
set rmargin at screen 0.97
set tmargin at screen 0.86
set bmargin at screen 0.15
set xrange [0:360]
set autoscale y
set offsets 0,0,graph 0.08,graph 0.08
set xtics nomirror 45
set ytics nomirror
set xlabel 'angle on the casing [deg]'
set ylabel 'gap [mm]'
set key above horizontal center
set xzeroaxis linewidth zero_width linecolor rgb zero_colour
plot figure_table skip 1 using 1:2 with lines linestyle leading_gap title 'leading edge', \
  '' skip 1 using 1:3 with lines linestyle trailing_gap title 'trailing edge'
unset multiplot
