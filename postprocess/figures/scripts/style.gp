# SPDX-License-Identifier: GPL-3.0-or-later
# How everything looks: fonts, colours, line widths, symbols, palettes. Scripts name a look by what it means
# (with lines linestyle leading_edge); nothing else in this folder or in C++ knows a colour of a drawing.

# Fonts: of the two terminals, then sizes of single texts.
svg_font = 'sans-serif,13'
png_font = 'sans,13'
png_scale = 2
png_font_scale = 0.75*png_scale  # pngcairo counts in points of 1/72 inch at 96 px an inch
tiny_font = ',10'
small_font = ',11'
key_font = ',12'
panel_font = ',13'
large_font = ',14'

# Colours that stand apart, also for colour-blind eyes (Okabe and Ito).
black = '#000000'
amber = '#e69f00'
blue = '#0072b2'
pink = '#cc79a7'
vermilion = '#d55e00'
green = '#009e73'
sky = '#56b4e9'
brown = '#8c6d1f'
array series_colours[8] = [black, amber, blue, pink, vermilion, green, sky, brown]
series_colour(i) = series_colours[int(i)%8 + 1]

# Other colours by what they mean.
paper_colour = '#ffffff'
frame_colour = '#444444'
tics_colour = '#222222'
grid_colour = '#dddddd'
missing_colour = '#d9d9d9'  # under a map: no response
range_colour = '#eef3f8'  # the simulated speeds
night = '#08306b'
coral = '#ff7f50'
forward_colour = vermilion
backward_colour = blue
engine_order_text = '#333333'
corner_text = '#555555'  # engine orders on a zig-zag
family_text = blue
map_family_text = '#ffb482'
map_key_colour = '#31688e'
map_key_text = '#ffffff'
rotation_text = '#555555'
clamped_colour = '#d91a1f'
contact_colour = '#0d4dd9'

# Viridis, a perceptually even map for amplitudes: dark is small. Shares of contact: white never, dark blue always.
amplitude_palette = "0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', 7 '#6ece58', 8 '#b5de2b', 9 '#fde725'"
contact_palette = "0 '#ffffff', 1 '#c6dbef', 2 '#6baed6', 3 '#2171b5', 4 '#08306b'"

# Frame, tics, grid and key of every drawing.
set border 31 linewidth 0.8 linecolor rgb frame_colour
set tics nomirror out scale 0.6 textcolor rgb tics_colour
set grid linetype 1 linewidth 0.4 linecolor rgb grid_colour
set key noautotitle samplen 2 spacing 1.1 font key_font

# Lines and points: a number for each, then its look.
# On maps.
map_engine_order = 11; set style line map_engine_order linewidth 0.5 linecolor rgb '#a0ffffff'
map_mode = 12; set style line map_mode linewidth 1.1 linecolor rgb coral
map_irregular = 13; set style line map_irregular pointtype 2 pointsize 0.55 linewidth 1.2 linecolor rgb '#ffffff'
map_subharmonic = 14; set style line map_subharmonic pointtype 8 pointsize 0.7 linewidth 1.2 linecolor rgb '#ffe680'
map_breaking = 15; set style line map_breaking pointtype 6 pointsize 0.65 linewidth 1.2 linecolor rgb '#ff9ecb'
map_outside = 20; set style line map_outside pointtype 5 pointsize 0.5 linecolor rgb '#ff9040'
map_critical = 19; set style line map_critical pointtype 12 pointsize 1.6 linewidth 1.6 linecolor rgb '#ffffff'
expected_wave = 16; set style line expected_wave pointtype 4 pointsize 3.6 linewidth 0.8 linecolor rgb coral
contact_drift = 17; set style line contact_drift pointtype 7 pointsize 0.22 linecolor rgb '#d62728'
spectrum_line = 18; set style line spectrum_line linewidth 0.8 linecolor rgb '#31688e'

# Amplitudes over speed.
largest_on_tip = 21; set style line largest_on_tip pointtype 7 pointsize 0.6 linewidth 3 linecolor rgb '#9aa7b3'
leading_edge = 22; set style line leading_edge linewidth 1.3 linecolor rgb blue
trailing_edge = 23; set style line trailing_edge linewidth 1.3 linecolor rgb vermilion
not_periodic = 24; set style line not_periodic pointtype 6 pointsize 1.3 linewidth 1.3 linecolor rgb '#c2185b'
outside_validity = 30; set style line outside_validity pointtype 5 pointsize 0.55 linecolor rgb '#d98032'
failed_speed = 25; set style line failed_speed pointtype 2 pointsize 1 linecolor rgb '#c2185b'
predicted_aliased = 26; set style line predicted_aliased pointtype 8 pointsize 1 linecolor rgb '#555555'
predicted_linear = 27; set style line predicted_linear pointtype 9 pointsize 1 linecolor rgb green
contrast_line = 28; set style line contrast_line pointtype 7 pointsize 0.35 linewidth 1.2 linecolor rgb blue
places_line = 29; set style line places_line linewidth 1.2 linecolor rgb vermilion
sweep_from_rest = 31; set style line sweep_from_rest pointtype 7 pointsize 0.3 linewidth 1.2 linecolor rgb frame_colour
sweep_up = 32; set style line sweep_up linewidth 1.2 linecolor rgb vermilion
sweep_down = 33; set style line sweep_down linewidth 1.2 dashtype 2 linecolor rgb blue
differs_up = 34; set style line differs_up pointtype 9 pointsize 1 linecolor rgb vermilion
differs_down = 35; set style line differs_down pointtype 11 pointsize 1 linecolor rgb blue
tracked_width = 1.6
attracting_orbits = 38; set style line attracting_orbits linewidth 2.2 linecolor rgb '#31688e'
repelling_orbits = 39; set style line repelling_orbits linewidth 1.8 dashtype 2 linecolor rgb '#c2185b'
tracked_mean = 36; set style line tracked_mean linewidth 1 dashtype 3 linecolor rgb '#777777'

# Natural frequencies.
engine_order_line = 41; set style line engine_order_line linewidth 0.6 linecolor rgb '#aaaaaa'
mode_width = 1.4
crossing_aliased = 42; set style line crossing_aliased pointtype 6 pointsize 1.1 linewidth 1.2 linecolor rgb tics_colour
crossing_linear = 43; set style line crossing_linear pointtype 4 pointsize 1.5 linewidth 1.2 linecolor rgb tics_colour
critical_speed = 48; set style line critical_speed pointtype 13 pointsize 1.5 linecolor rgb '#c2185b'
zigzag_line = 44; set style line zigzag_line linewidth 1 linecolor rgb '#999999'
modes_standing_still = 45; set style line modes_standing_still pointtype 6 pointsize 0.9 dashtype 3 linecolor rgb blue
modes_spinning = 46; set style line modes_spinning pointtype 7 pointsize 0.9 linewidth 1.4 linecolor rgb blue
driven_corner = 47; set style line driven_corner pointtype 7 pointsize 0.8 linecolor rgb vermilion

# Motion and force at one speed; the casing.
even_sector = 51; set style line even_sector linewidth 1.3 linecolor rgb blue
odd_sector = 52; set style line odd_sector linewidth 1.3 linecolor rgb night
scale_bar = 53; set style line scale_bar linewidth 3 linecolor rgb black
leading_force = 54; set style line leading_force linewidth 1.5 linecolor rgb blue
trailing_force = 55; set style line trailing_force linewidth 1.5 linecolor rgb vermilion
leading_impulse = 56; set style line leading_impulse linewidth 3 linecolor rgb blue
trailing_impulse = 57; set style line trailing_impulse linewidth 3 linecolor rgb vermilion
round_casing = 58; set style line round_casing dashtype 2 linecolor rgb '#999999'
rotation_line = 59; set style line rotation_line linecolor rgb rotation_text
casing_shape = 61; set style line casing_shape linewidth 2.5 linecolor rgb night
leading_gap = 62; set style line leading_gap linewidth 2 linecolor rgb blue
trailing_gap = 63; set style line trailing_gap linewidth 2 linecolor rgb vermilion
zero_width = 1
# The wheel's section: parts in the mesh's order, disc, main blade, splitter.
array section_colours[4] = ['#c3ccd5', '#9ecae9', '#f7cf8b', '#b7dfc9']
section_colour(i) = section_colours[(int(i) + 3)%4 + 1]
section_casing = 64; set style line section_casing linewidth 2.5 linecolor rgb night
section_leading = 67; set style line section_leading pointtype 9 pointsize 1.7 linecolor rgb contact_colour
section_trailing = 68; set style line section_trailing pointtype 5 pointsize 1.3 linecolor rgb contact_colour
section_clamped = 65; set style line section_clamped pointtype 7 pointsize 0.45 linecolor rgb clamped_colour
section_contact = 66; set style line section_contact pointtype 7 pointsize 0.9 linecolor rgb contact_colour
zero_colour = '#777777'
array band_colours[4] = ['#f7f2d2', '#fae6d8', '#ead9f2', '#f3ccd9']  # speeds to avoid, the gravest last
estimated_stress = 71; set style line estimated_stress linewidth 1.6 linecolor rgb '#a3367f'
recovered_stress = 72; set style line recovered_stress pointtype 7 pointsize 0.9 linecolor rgb '#a3367f'
stress_at_least = 75; set style line stress_at_least pointtype 6 pointsize 0.9 linewidth 1.3 linecolor rgb '#a3367f'
allowed_stress = 73; set style line allowed_stress linewidth 1.4 dashtype 2 linecolor rgb '#c2185b'
yield_strength = 74; set style line yield_strength linewidth 1.4 dashtype 3 linecolor rgb tics_colour
array budget_colours[3] = [vermilion, blue, '#999999']  # data and physics, settings, their sum
