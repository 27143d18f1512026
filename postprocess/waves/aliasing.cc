// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/aliasing.h"
#include "reduce/model/nodal_diameter.h"

#include <cassert>
#include <cstdlib>

namespace tiprub {

int signed_nodal_diameter(int engine_order, int sector_count) {
  assert(sector_count >= 1);
  // eq. 17: n = k - a N with whole a
  const int remainder = ((engine_order % sector_count) + sector_count) % sector_count;
  return 2 * remainder > sector_count ? remainder - sector_count : remainder;
}

int aliased_nodal_diameter(int engine_order, int sector_count) {
  return std::abs(signed_nodal_diameter(engine_order, sector_count));
}

std::optional<int> smallest_engine_order(int nodal_diameter, int lobes, int sector_count) {
  assert(lobes >= 1);
  for (int k = 1; k <= sector_count; ++k)  // eq. 17: a N +- n = k N_l
    if (aliased_nodal_diameter(k * lobes, sector_count) == nodal_diameter) return k * lobes;
  return std::nullopt;
}

WaveDirection wave_direction(int signed_nodal_diameter, int sector_count) {
  if (is_standing(signed_nodal_diameter, sector_count)) return WaveDirection::standing;
  return signed_nodal_diameter > 0 ? WaveDirection::backward : WaveDirection::forward;
}

std::string name_of(WaveDirection direction) {
  switch (direction) {
    case WaveDirection::backward:
      return "backward";
    case WaveDirection::forward:
      return "forward";
    case WaveDirection::standing:
      return "standing";
  }
  return "";
}

}  // namespace tiprub
