# SPDX-License-Identifier: GPL-3.0-or-later
# The whole wheel, one sector in colour.
load 'scripts/picture.gp'
set label 'sector 0' at screen 0.03,0.94 left font large_font textcolor rgb sector_text front
plot name.'.pixels' @picture
