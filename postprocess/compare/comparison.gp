# SPDX-License-Identifier: GPL-3.0-or-later
# Amplitude over speed of this report and of others.
# Reads speed_low, speed_high [rpm]; $here, $there: speed [rpm], amplitude [mm], a sheet of $there for each of the `others`;
# other_name[others].
set xrange [speed_low:speed_high]
set yrange [0:*]
set offsets 0,0,graph 0.05,0
set xlabel 'speed [rpm]'
set ylabel 'amplitude [mm]'
set lmargin at screen 0.085
set rmargin at screen 0.975
set tmargin at screen 0.9
set bmargin at screen 0.13
set key at screen 0.5,0.96 center center horizontal
array other_colour[6] = ['#7a4fa3', '#009e73', '#e69f00', '#cc79a7', '#d55e00', '#56b4e9']
plot for [i=1:others] $there index i-1 using 1:2 with lines linewidth 2 dashtype i+1 linecolor rgb other_colour[(i-1)%6+1] title other_name[i], \
  $here using 1:2 with linespoints linestyle largest_on_tip title 'this report'
