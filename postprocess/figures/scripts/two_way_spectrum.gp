# SPDX-License-Identifier: GPL-3.0-or-later
# Amplitude of every travelling wave: engine order, signed nodal diameter. The largest ones are named.
# Reads lines, revolutions (recorded), sectors, lowest_nodal_diameter, amplitude_low, amplitude_high, unit, names,
# name_of_wave[]; $waves: engine order, signed nodal diameter, amplitude, the largest first; $expected: engine order and
# signed nodal diameter of the casing's harmonics.
line_width = 1.0/revolutions  # of a spectral line, in engine orders
bottom = lowest_nodal_diameter - 0.5
set palette defined (@amplitude_palette)
set xrange [0.4:line_width*lines + 0.9]
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
# Areas grow with the level, so that the largest waves stand out in black and white as well.
level(a) = log10(a/amplitude_low)/log10(amplitude_high/amplitude_low)
size(a) = (0.5 + 2.4*level(a))*(revolutions > 1 ? 0.7 : 1)
plot $expected using 1:2 with points linestyle expected_wave title 'casing, eq. 17', \
  $waves using 1:2:(size($3)):3 with points pointtype 5 pointsize variable linecolor palette, \
  $waves using 1:2:(name_of_wave[int($0) + 1]) every ::0::names-1 with labels offset 0,1.5 font small_font
