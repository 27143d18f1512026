# SPDX-License-Identifier: GPL-3.0-or-later
# An upright colour bar at the right of a painted picture; it shows only if something is plotted with palette.
# Reads palette_colours[] (#rrggbb from small to large), colour_high, colour_title.
stops = ''
do for [i=1:|palette_colours|] {
  stops = stops.sprintf("%s%d '%s'", i > 1 ? ', ' : '', i - 1, palette_colours[i])
}
eval 'set palette defined ('.stops.')'
set cbrange [0:colour_high]
set cbtics nomirror out scale 0.5 textcolor rgb black
set colorbox user origin screen 0.905,0.14 size screen 0.02,0.7
set label colour_title at screen 0.925,0.9 center font key_font front
shows_colour_bar = "using (-1):(-1):(0) with points palette"
