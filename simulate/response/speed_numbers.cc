// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/speed_numbers.h"

namespace tiprub {

const char* name_of(MotionClass motion) {
  return name_in(motion_names, motion);
}

const char* name_of(MotionMeasure measure) {
  return name_in(measure_names, measure);
}

const char* name_of(Start start) {
  return name_in(start_names, start);
}

const char* name_of(Variation variation) {
  return name_in(variation_names, variation);
}

}  // namespace tiprub
