# SPDX-License-Identifier: GPL-3.0-or-later
# Tip amplitude over speed, critical speeds labelled, speeds that the linear rules predict at the foot.
# Reads what bands.gp does; speed_low, speed_high [rpm], amplitude_high [mm]; $peaks: speed [rpm], amplitude [mm], with peak_name[];
# $not_periodic: likewise; $aliased, $equation_2, $failed, $outside: speeds [rpm]. The figure's table: speed [rpm], largest,
# leading edge, trailing edge [mm].
label_room = 1.45
foot = 0.02*label_room*amplitude_high
set xrange [speed_low:speed_high]
set yrange [0:label_room*amplitude_high]
set lmargin at screen 0.085
set rmargin at screen 0.975
set tmargin at screen 0.83
set bmargin at screen 0.13
set xlabel 'speed [rpm]'
set ylabel 'amplitude [mm]'
set key at screen 0.53,0.985 center top horizontal maxrows 2
band_top = label_room*amplitude_high
load 'scripts/bands.gp'
plot @avoided, \
  $peaks using 1:2:(peak_name[int($0) + 1]) with labels rotate by 90 left offset 0,0.7 \
    font small_font, \
  figure_table skip 1 using 1:2 with linespoints linestyle largest_on_tip title 'largest on the tip line', \
  '' skip 1 using 1:3 with lines linestyle leading_edge title 'leading edge', \
  '' skip 1 using 1:4 with lines linestyle trailing_edge title 'trailing edge', \
  $not_periodic using 1:2 with points linestyle not_periodic title titled(not_periodic_rows, 'not periodic'), \
  $aliased using 1:(foot) with points linestyle predicted_aliased \
    title titled(aliased_rows, 'rule with aliasing'), \
  $equation_2 using 1:(foot) with points linestyle predicted_linear title titled(equation_2_rows, 'eq. 2'), \
  $failed using 1:(2*foot) with points linestyle failed_speed title titled(failed_rows, 'failed'), \
  $outside using 1:(0.985*label_room*amplitude_high) with points linestyle outside_validity \
    title titled(outside_rows, 'outside validity')
