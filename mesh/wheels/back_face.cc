// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/wheels/back_face.h"

#include <algorithm>

#include "mesh/curves/chord_table.h"

namespace tiprub {

namespace {

constexpr double usual_bore_share = 0.45;  // of the stations that stand on the bore

}  // namespace

MeridionalPoint BackFace::foot(double station) const {
  if (station <= bore_end) return {front_z + (profile.at(bore_radius) - front_z) * station / bore_end, bore_radius};
  const double radius = bore_radius + (exit_radius - bore_radius) * (station - bore_end) / (1.0 - bore_end);
  return {profile.at(radius), radius};
}

SmoothTable read_back_profile(CaseTable& table) {
  return SmoothTable(
      table.points("back_profile", std::nullopt, Range::between(-wheel_length.high, wheel_length.high), "m"));
}

void read_bore_elements(CaseTable& table, SectorPlan& plan) {
  const int usual = std::max(1, static_cast<int>(usual_bore_share * plan.elements.chord));
  plan.elements.bore =
      table.integer("elements_along_bore", usual, Range::between(1, plan.elements.chord - 1), "elements");
}

}  // namespace tiprub
