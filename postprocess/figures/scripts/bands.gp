# SPDX-License-Identifier: GPL-3.0-or-later
# The speeds to avoid, behind the curves: `plot @avoided, ...`.
# Reads concern[], empty where no band has that grade; $bands: ends [rpm], grade; band_top, the upper end of y.
set style fill solid 1 noborder
avoided = "for [g=3:0:-1] $bands using (($1 + $2)/2):(band_top/2):1:2:(0):($3 == g ? band_top : NaN) with boxxyerror linecolor rgb band_colours[g + 1] title concern[g + 1]"
