# SPDX-License-Identifier: GPL-3.0-or-later
# What the interaction map and its parts have in common: axes, colours, grey where no speed has a response.
# Reads speed_low, speed_high [rpm], frequency_high [Hz], amplitude_low, amplitude_high [mm], pixel_columns, pixel_rows,
# engine_order_step, engine_order_last, nodal_diameters, families; $modes: speed [rpm], then the families of nodal
# diameter 0 [Hz], those of 1, ..
set palette defined (@amplitude_palette)
set object 99 rectangle from graph 0,0 to graph 1,1 fillcolor rgb missing_colour fillstyle solid noborder behind
unset grid
set xrange [speed_low:speed_high]
set yrange [0:frequency_high]
set logscale cb
set cbrange [amplitude_low:amplitude_high]
set format cb '%g'
dx = (speed_high - speed_low)/pixel_columns
dy = frequency_high/pixel_rows
map_image = "binary array=(pixel_columns,pixel_rows) format='%float32' origin=(speed_low + dx/2,dy/2) dx=dx dy=dy with image"
mode_column(n, k) = 1 + n*families + k  # of $modes, k from 1
