# SPDX-License-Identifier: GPL-3.0-or-later
# Several views of the wheel beside and above each other, each with its name, and one colour bar.
# Reads what picture.gp and colour_bar.gp do; $panels: middle of each panel's name, in shares of the figure's width and
# height; panel_title[].
load 'scripts/picture.gp'
load 'scripts/colour_bar.gp'
plot name.'.pixels' @picture, '+' @shows_colour_bar, \
  $panels using (pixel_columns*$1):(pixel_rows*$2):(panel_title[int($0) + 1]) with labels center font panel_font
