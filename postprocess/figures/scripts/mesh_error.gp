# SPDX-License-Identifier: GPL-3.0-or-later
# The sector's surface from two sides, coloured twice: errors of frequencies above, of compliances below.
# Reads share_low, share_high [%] and $faces, a surface in pieces: axis, around it, outwards [mm], both shares [%].
set palette defined (@amplitude_palette)
unset grid
unset border
unset tics
set view equal xyz
set xyplane 0
set pm3d depthorder
set logscale cb
set cbrange [share_low:share_high]
set format cb '%g'
set cbtics out scale 0.6 textcolor rgb tics_colour
set cblabel 'share of a cell in the error [%]'
set colorbox user origin screen 0.885,0.1 size screen 0.022,0.8
set label 1 'frequencies' at screen 0.03,0.74 center rotate by 90 font large_font
set label 2 'contact compliances' at screen 0.03,0.26 center rotate by 90 font large_font
set multiplot
do for [side = 0:1] {
  set view 70, (side == 0 ? 153 : 333), 0.85
  do for [row = 0:1] {
    set lmargin at screen 0.05 + 0.41*side
    set rmargin at screen 0.45 + 0.41*side
    set tmargin at screen 0.98 - 0.48*row
    set bmargin at screen 0.5 - 0.48*row
    splot $faces using 1:2:3:(column(4 + row)) with pm3d
    unset label
    unset colorbox
  }
}
unset multiplot
