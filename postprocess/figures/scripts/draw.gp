# SPDX-License-Identifier: GPL-3.0-or-later
# Draws one figure twice, as <name>.svg and as <name>.png with more pixels. The program runs it after a prologue that
# assigns name, script, width and height [px], and whatever that script says that it reads.
set encoding utf8
set datafile separator ','
set datafile missing 'NaN'
figure_table = name.'.csv'
titled(rows, words) = rows > 0 ? words : ''  # a table without rows is not in the key

load 'scripts/style.gp'
set terminal svg enhanced size width,height font svg_font background rgb paper_colour
set output name.'.svg'
load 'scripts/'.script.'.gp'
unset output

reset
set encoding utf8
set datafile separator ','
set datafile missing 'NaN'
load 'scripts/style.gp'
set terminal pngcairo enhanced size png_scale*width,png_scale*height font png_font fontscale png_font_scale \
  linewidth png_scale pointscale png_scale
set output name.'.png'
load 'scripts/'.script.'.gp'
unset output
