# SPDX-License-Identifier: GPL-3.0-or-later
# Spectra one above the other; each hides what lies behind it.
# Reads speed_low, speed_high [rpm], frequency_high [Hz], amplitude_high [mm]; speeds, speed[] from the back to the
# front; $spectra, a sheet a speed: frequency [Hz], amplitude [mm].
tallest = 0.2*(speed_high - speed_low)  # height of the largest line
scale = tallest/amplitude_high
set xrange [0:frequency_high]
set yrange [speed_low:speed_high + tallest]
set xlabel 'frequency in the rotor frame [Hz]'
set ylabel 'speed [rpm], spectra on top'
# One spectrum is a filled area and a line on it, so that a plain "plot for" can't keep their order.
spectrum(i) = sprintf("$spectra index %d using 1:(speed[%d] + scale*$2) with filledcurves y=speed[%d] ".\
                      "linecolor rgb paper_colour, '' index %d using 1:(speed[%d] + scale*$2) ".\
                      "with lines linestyle spectrum_line", i - 1, i, i, i - 1, i)
terms = spectrum(1)
do for [i=2:speeds] { terms = terms.', '.spectrum(i) }
eval 'plot '.terms
