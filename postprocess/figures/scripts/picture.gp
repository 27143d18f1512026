# SPDX-License-Identifier: GPL-3.0-or-later
# The frame of a painted picture of the wheel: it fills the figure, and the axes count its pixels.
# Reads pixel_columns, pixel_rows.
set border 0 linewidth 1 linecolor rgb black  # of the colour bar
unset tics
unset key
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 0
set xrange [0:pixel_columns]
set yrange [0:pixel_rows]
picture = "binary array=(pixel_columns,pixel_rows) format='%float32%float32%float32' origin=(0.5,0.5) with rgbimage"
