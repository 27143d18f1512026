# SPDX-License-Identifier: GPL-3.0-or-later
# Names of the engine orders where their lines f = k rpm/60 leave the drawn box, at the right or on top; on top, those
# that would run into each other are left out.
# Reads speed_low, speed_high [rpm], frequency_high [Hz], engine_order_step, engine_order_last.
top_label_width = 0.05*(speed_high - speed_low)
free_below = speed_high + top_label_width
do for [k=engine_order_step:engine_order_last:engine_order_step] {
  frequency_at_right = k*speed_high/60.0
  speed_at_top = frequency_high*60.0/k
  if (frequency_at_right <= frequency_high) {
    set label sprintf('EO %d', k) at first speed_high, first frequency_at_right left offset 0.6,0 \
      font small_font textcolor rgb engine_order_text
  } else {
    if (speed_at_top > speed_low && speed_at_top < free_below) {
      free_below = speed_at_top - top_label_width
      set label sprintf('EO %d', k) at first speed_at_top, first frequency_high center offset 0,0.6 \
        font small_font textcolor rgb engine_order_text
    }
  }
}
