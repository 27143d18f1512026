# SPDX-License-Identifier: GPL-3.0-or-later
# One sector from two sides; the key names its node sets in their colours.
load 'scripts/picture.gp'
set label '● clamped' at screen 0.07,0.955 left font panel_font textcolor rgb clamped_text front
set label '● contact nodes' at screen 0.24,0.955 left font panel_font textcolor rgb contact_text front
set label '● lower cut face' at screen 0.47,0.955 left font panel_font textcolor rgb lower_cut_text front
set label '● upper cut face' at screen 0.71,0.955 left font panel_font textcolor rgb upper_cut_text front
plot name.'.pixels' @picture
