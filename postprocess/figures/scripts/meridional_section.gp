# SPDX-License-Identifier: GPL-3.0-or-later
# The wheel in the meridional plane, its axis along the foot, its inlet at the left.
# Reads outline_title[] (empty: another piece of the one before), inlet_first (1: the inlet is at the lower end of z);
# $outlines, a sheet a piece, $casing, $contact, $clamped: z, r [mm].
set lmargin at screen 0.095
set rmargin at screen 0.72
set tmargin at screen 0.96
set bmargin at screen 0.12
set size ratio -1
set offsets graph 0.06,graph 0.06,graph 0.06,0
set yrange [0:*]
if (inlet_first == 0) { set xrange [*:*] reverse }
set xlabel 'z [mm]'
set ylabel 'r [mm]'
set key at screen 0.74,0.94 left top vertical Left reverse
set style fill transparent solid 0.75 border linecolor rgb frame_colour
array colour_of[|outline_title|]
parts = 0
do for [i=1:|outline_title|] {
  if (strlen(outline_title[i]) > 0) { parts = parts + 1 }
  colour_of[i] = section_colour(parts)
}
plot for [i=1:|outline_title|] $outlines index (i-1) using 1:2 with filledcurves closed fillcolor rgb colour_of[i] \
    title outline_title[i], \
  $casing using 1:2 with lines linestyle section_casing title 'casing', \
  $clamped using 1:2 with points linestyle section_clamped title 'clamped nodes', \
  $contact using 1:2 with points linestyle section_contact title 'contact nodes', \
  $contact using 1:2 every ::0::0 with points linestyle section_leading title 'leading edge', \
  $contact using 1:2 every ::contact_rows-1 with points linestyle section_trailing title 'trailing edge'
