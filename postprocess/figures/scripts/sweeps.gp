# SPDX-License-Identifier: GPL-3.0-or-later
# Amplitude over speed from rest, upwards and downwards, filled where motions differ; orbits.
# Reads speed_low, speed_high [rpm]; $sweeps: speed [rpm], from rest, up, down, up if it differs, down if it differs [mm];
# $attracting, $repelling: speed [rpm], amplitude [mm], a sheet a run of orbits; sweeps_drawn: whether there are sweeps.
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
plot $sweeps using 1:2 with linespoints linestyle sweep_from_rest title 'from rest', \
  '' using 1:3 with lines linestyle sweep_up title titled(sweeps_drawn, 'up'), \
  '' using 1:4 with lines linestyle sweep_down title titled(sweeps_drawn, 'down'), \
  '' using 1:5 with points linestyle differs_up title titled(sweeps_drawn, 'up differs'), \
  '' using 1:6 with points linestyle differs_down title titled(sweeps_drawn, 'down differs'), \
  $attracting using 1:2 with lines linestyle attracting_orbits title titled(attracting_rows, 'orbits that attract'), \
  $repelling using 1:2 with lines linestyle repelling_orbits title titled(repelling_rows, 'orbits that repel')
