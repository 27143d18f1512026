# SPDX-License-Identifier: GPL-3.0-or-later
# Stress of the vibration over speed.
# Reads speed_low, speed_high [rpm], stress_high [MPa]; allowed, yield [MPa], 0 if not known, allowed_name; what bands.gp
# does; $recovered, over a cycle, and $at_least, at one instant: speed [rpm], stress [MPa]. The figure's table: speed
# [rpm], stress [MPa].
band_top = 1.08*stress_high
load 'scripts/bands.gp'
set xrange [speed_low:speed_high]
set yrange [0:band_top]
set lmargin at screen 0.085
set rmargin at screen 0.975
set tmargin at screen 0.79
set bmargin at screen 0.16
set xlabel 'speed [rpm]'
set ylabel 'von Mises [MPa]'
set key at screen 0.53,0.985 center top horizontal maxrows 2
plot @avoided, \
  figure_table skip 1 using 1:2 with lines linestyle estimated_stress title 'estimated', \
  $recovered using 1:2 with points linestyle recovered_stress title titled(recovered_rows, 'recovered'), \
  $at_least using 1:2 with points linestyle stress_at_least title titled(at_least_rows, 'at least (one instant)'), \
  allowed > 0 ? allowed : NaN with lines linestyle allowed_stress title titled(allowed > 0, allowed_name), \
  yield > 0 ? yield : NaN with lines linestyle yield_strength title titled(yield > 0, 'yield strength')
