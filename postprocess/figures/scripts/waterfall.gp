# SPDX-License-Identifier: GPL-3.0-or-later
# Spectra one above the other; each hides what lies behind it.
# Reads speed_low, speed_high [rpm], frequency_high [Hz], amplitude_high [mm]; engine_order_step, engine_order_last; speeds, speed[] from the back to the
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
# Engine orders are lines f = k rpm/60 under the spectra, named at their upper ends.
set samples 2
set rmargin at screen 0.88
set tmargin at screen 0.95
order_line(k) = sprintf("[speed_low:speed_high] '+' using (%d*$1/60.0):1 with lines linestyle engine_order_line", k)
orders = ''
do for [k=engine_order_step:engine_order_last:engine_order_step] {
  orders = orders.order_line(k).', '
  end = k*speed_high/60.0
  if (end <= frequency_high) {
    set label sprintf('EO %d', k) at first end, first (speed_high + 0.3*tallest) center font tiny_font textcolor rgb engine_order_text
  }
}
# The scale: a round amplitude, as tall as in the spectra.
round = 10**floor(log10(amplitude_high))
set arrow from graph 1.04, first speed_low to graph 1.04, first (speed_low + scale*round) nohead linestyle scale_bar
set label sprintf('%g mm', round) at graph 1.055, first (speed_low + 0.5*scale*round) left font small_font
eval 'plot sample '.orders.terms
