// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/marched_map.h"

#include <cstdint>

namespace tiprub {

MarchedMap::MarchedMap(TimeMarch& march, const RotorAtSpeed& rotor, const Casing& casing, const ContactLine& contact)
    : march_(march), map_(march, casing.lobes), tangent_(rotor, casing, contact, march, Disturbance::symmetric) {}

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
