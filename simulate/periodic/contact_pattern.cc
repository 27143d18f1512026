// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/periodic/contact_pattern.h"

namespace tiprub {

void ContactPattern::add(const std::vector<int>& closed) {
  if (closed.empty()) {
    steps_.push_back(open);
    return;
  }
  const auto [place, is_new] = places_.try_emplace(closed, static_cast<int>(sets_.size()));
  if (is_new) sets_.push_back(closed);
  steps_.push_back(place->second);
}

}  // namespace tiprub
