// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/section_surface.h"

#include <algorithm>
#include <cmath>

namespace tiprub {

namespace {

template <class Value>
SmoothTable table_of(const BladeSection& section, const std::vector<double>& fractions, Value value) {
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < section.size(); ++i) points.push_back({fractions[i], value(section[i])});
  return SmoothTable(std::move(points));
}

}  // namespace

SectionSurface::SectionSurface(const std::vector<BladeSection>& sections, double blunt_edge)
    : blunt_edge_(blunt_edge), heights_{0.0} {
  for (const BladeSection& section : sections) {
    const std::vector<double> fractions = fractions_of_length(section);
    const auto table = [&](auto value) { return table_of(section, fractions, value); };
    tables_.push_back({table([](const BladePoint& p) { return p.at.z; }),
                       table([](const BladePoint& p) { return p.at.r; }),
                       table([](const BladePoint& p) { return p.theta; }),
                       table([](const BladePoint& p) { return p.half_width; })});
  }
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const MeridionalPoint up = mid_chord(sections[i]) - mid_chord(sections[i - 1]);
    heights_.push_back(heights_.back() + std::hypot(up.z, up.r));
  }
  for (double& height : heights_) height /= heights_.back();
}

BladePoint SectionSurface::at(double chord, double span) const {
  const double thick_chord = std::clamp(chord, blunt_edge_, 1.0 - blunt_edge_);
  const auto between_sections = [&](std::size_t quantity, double where) {
    std::vector<std::array<double, 2>> points;
    for (std::size_t i = 0; i < tables_.size(); ++i) points.push_back({heights_[i], tables_[i][quantity].at(where)});
    return SmoothTable(std::move(points)).at(span);
  };
  return {{between_sections(0, chord), between_sections(1, chord)},
          between_sections(2, chord),
          between_sections(3, thick_chord)};
}

}  // namespace tiprub
