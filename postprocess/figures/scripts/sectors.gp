# SPDX-License-Identifier: GPL-3.0-or-later
# A signal of all sectors, one above the other.
# Reads revolutions, sectors, middle[] (of each sector's values), spacing (between neighbours), bar_label (of half a
# spacing). The figure's table: rotor angle [deg], then a column a sector.
right = 360.0*revolutions
set xrange [0:right]
set yrange [-0.8:sectors - 0.2]
set lmargin at screen 0.085
set rmargin at screen 0.95
set tmargin at screen 0.97
set bmargin at screen 0.1
set xtics 45*revolutions
set ytics 1
set xlabel 'rotor angle [deg]'
set ylabel 'sector'
set arrow 1 from right*1.015,0 to right*1.015,0.5 nohead linestyle scale_bar
set label 1 bar_label at right*1.03,0.25 rotate by 90 center font tiny_font
set clip two
plot for [j=0:sectors-1] figure_table skip 1 using 1:(j + (column(j + 2) - middle[j + 1])/spacing) with lines \
  linestyle (j%2 == 0 ? even_sector : odd_sector)
