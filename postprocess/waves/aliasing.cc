// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/waves/aliasing.h"

#include <array>
#include <cassert>
#include <cstdlib>

#include "reduce/model/nodal_diameter.h"

namespace tiprub::postprocess {

int signed_nodal_diameter(int engine_order, int sector_count) {
  assert(sector_count >= 1);
  // eq. 17: n = k - a N with whole a
  const int remainder = ((engine_order % sector_count) + sector_count) % sector_count;
  return 2 * remainder > sector_count ? remainder - sector_count : remainder;
}

int aliased_nodal_diameter(int engine_order, int sector_count) {
  return std::abs(signed_nodal_diameter(engine_order, sector_count));
}

WaveDirection wave_direction(int signed_nodal_diameter, int sector_count) {
  if (is_standing(signed_nodal_diameter, sector_count)) return WaveDirection::standing;
  return signed_nodal_diameter > 0 ? WaveDirection::backward : WaveDirection::forward;
}

std::string name_of(WaveDirection direction) {
  constexpr std::array names = {"backward", "forward", "standing"};
  return names[static_cast<std::size_t>(direction)];
}

}  // namespace tiprub::postprocess
