# SPDX-License-Identifier: GPL-3.0-or-later
# The sector's surface from two sides, coloured twice: errors of frequencies above, of compliances below.
# Reads share_low, share_high [%], pixel_columns, pixel_rows.
set palette defined (@amplitude_palette)
unset grid
unset border
unset tics
set lmargin at screen 0.06
set rmargin at screen 0.86
set tmargin at screen 0.98
set bmargin at screen 0.02
set size ratio -1
set xrange [0:pixel_columns]
set yrange [0:pixel_rows]
set logscale cb
set cbrange [share_low:share_high]
set format cb '%g'
set cbtics out scale 0.6 textcolor rgb tics_colour
set cblabel 'share of a cell in the error [%]'
set colorbox user origin screen 0.885,0.1 size screen 0.022,0.8
set label 'frequencies' at screen 0.03,0.74 center rotate by 90 font large_font
set label 'contact compliances' at screen 0.03,0.26 center rotate by 90 font large_font
plot name.'.pixels' binary array=(pixel_columns,pixel_rows) format='%float32' origin=(0.5,0.5) dx=1 dy=1 with image
