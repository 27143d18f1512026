# SPDX-License-Identifier: GPL-3.0-or-later
# Amplitude of every travelling wave: engine order, signed nodal diameter.
# Reads lines, revolutions (recorded), sectors, lowest_nodal_diameter, amplitude_low, amplitude_high, unit,
# pixel_columns, pixel_rows; $expected: engine order and signed nodal diameter of the casing's harmonics.
line_width = 1.0/revolutions  # of a spectral line, in engine orders
dx = line_width*lines/pixel_columns
dy = 1.0*sectors/pixel_rows
bottom = lowest_nodal_diameter - 0.5
set palette defined (@amplitude_palette)
unset grid
set xrange [0.5*line_width:(lines + 0.5)*line_width]
set yrange [bottom:bottom + sectors]
set cbrange [amplitude_low:amplitude_high]
set logscale cb
set format cb '%g'
set lmargin at screen 0.085
set rmargin at screen 0.83
set tmargin at screen 0.96
set bmargin at screen 0.13
set xtics 1
set ytics 1
set xlabel 'engine order'
set ylabel 'signed nodal diameter'
set cblabel 'amplitude ['.unit.']'
set colorbox user origin screen 0.87,0.13 size screen 0.022,0.83
plot name.'.pixels' binary array=(pixel_columns,pixel_rows) format='%float32' \
    origin=(0.5*(line_width + dx),bottom + dy/2) dx=dx dy=dy with image, \
  $expected using 1:2 with points linestyle expected_wave
