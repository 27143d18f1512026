# SPDX-License-Identifier: GPL-3.0-or-later
# Amplitude over speed of this report and of another one.
# Reads speed_low, speed_high [rpm]; $here, $there: speed [rpm], amplitude [mm]; other_name[1].
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
plot $there using 1:2 with lines linestyle other_response title other_name[1], \
  $here using 1:2 with linespoints linestyle largest_on_tip title 'this report'
