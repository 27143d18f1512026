// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/marched_map.h"

#include <algorithm>
#include <cstdint>

namespace tiprub {

MarchedMap::MarchedMap(TimeMarch& march, int power)
    : march_(march), map_(march, power), tangent_(march, Disturbance::symmetric, power) {
  const auto has_mass = [](const WaveModes& wave) { return wave.moving == wave.omega.size(); };
  all_have_mass_ = std::all_of(march.rotor().waves.begin(), march.rotor().waves.end(), has_mass);
}

void MarchedMap::put(const Eigen::VectorXd& state) {
  map_.put(state);
  if (all_have_mass_) return;
  for (int i = 0; i < march_.steps_per_revolution(); ++i) march_.step();
}

MapImage MarchedMap::image(const Eigen::VectorXd& state) {
  const std::int64_t start = march_.step_count();
  auto pattern = std::make_shared<ContactPattern>();
  map_.put(state);
  for (int i = 0; i < map_.steps(); ++i) {
    march_.step();
    pattern->add(march_.contact().closed());
  }
  MapImage image{map_.image(), std::move(pattern)};
  march_.set_step(start);
  return image;
}

Eigen::VectorXd MarchedMap::tangent(const std::shared_ptr<const ContactPattern>& pattern,
                                    const Eigen::VectorXd& change) {
  return tangent_(pattern, change);
}

}  // namespace tiprub
