# SPDX-License-Identifier: GPL-3.0-or-later
# What each source of error does to one critical speed, as bars from the value as computed.
# Reads source[], panel_title[] and panel_value[] of the panels. The figure's table: source, kind (data, setting, sum),
# change of speed [rpm], of |u| [mm], of stress [MPa]; the last may be empty.
array kinds[3] = ['data', 'setting', 'sum']
array kind_titles[3] = ['data and physics', 'settings of the computation', 'root of the sum of squares']
panels = |panel_title|
rows = |source|
thickness = 0.34  # half of a bar's, in rows
is(kind) = strcol(2) eq kinds[kind]
# A sum has no sign: its bar reaches to both sides.
middle(value, kind) = is(kind) ? (kind == 3 ? 0 : value/2) : NaN
half_length(value, kind) = abs(kind == 3 ? value : value/2)
number(value) = value == 0 ? '' : sprintf(abs(value) < 10 ? '%+.2g' : '%+.0f', value)
# A round number of one digit, not above the value.
digit(value) = 10.0**floor(log10(value))
round_below(value) = floor(value/digit(value))*digit(value)
array largest[panels]
do for [p=1:panels] {
  stats figure_table skip 1 using (abs(column(p+2))) nooutput
  largest[p] = STATS_max > 0 ? STATS_max : 1
}
set multiplot layout 1,panels margins screen 0.2,0.98,0.17,0.83 spacing screen 0.02,0.1
do for [k=1:3] {
  set label k "■ ".kind_titles[k] at screen 0.2 + 0.25*(k - 1),0.95 font key_font textcolor rgb budget_colours[k]
}
set yrange [rows - 0.4:-0.6]
set ytics scale 0 ('' -1)
set grid noytics
set yzeroaxis linetype 1 linewidth 0.8 linecolor rgb frame_colour
do for [p=1:panels] {
  set xrange [-1.5*largest[p]:1.5*largest[p]]
  tick = round_below(largest[p])
  set xtics (sprintf('%+g', -tick) -tick, '0' 0, sprintf('%+g', tick) tick)
  do for [r=1:rows] { set ytics add (p == 1 ? source[r] : '' r - 1) }
  set title panel_title[p].': '.panel_value[p] offset 0,-0.6
  set xlabel 'change, in the same unit'
  plot for [k=1:3] figure_table skip 1 using (middle(column(p+2), k)):0:(half_length(column(p+2), k)):(thickness) \
      with boxxyerror fillstyle solid noborder fillcolor rgb budget_colours[k], \
    '' skip 1 using (is(3) || column(p+2) < 0 ? NaN : column(p+2)):0:(number(column(p+2))) with labels font tiny_font left offset 0.4,0, \
    '' skip 1 using (is(3) || column(p+2) >= 0 ? NaN : column(p+2)):0:(number(column(p+2))) with labels font tiny_font right offset -0.4,0
  unset label
}
unset multiplot
