// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/blade_section.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "mesh/curves/wheel_keys.h"

namespace tiprub::mesh {

namespace {

constexpr std::size_t fewest_points = 3;
constexpr double least_step = 1e-9;        // of a section's length
constexpr double negligible_width = 0.01;  // of the largest width; two fitted curves may cross by so much

double product(const MeridionalPoint& a, const MeridionalPoint& b) {
  return a.z * b.z + a.r * b.r;
}

double length_of(const BladeSection& section) {
  return lengths_along(section).back();
}

[[noreturn]] void refuse_section(const NamedText& file, std::size_t section, std::size_t count,
                                 const std::string& message) {
  throw InputError(file.name + ": section " + std::to_string(section + 1) + " of " + std::to_string(count) + " " +
                   message);
}

}  // namespace

std::vector<double> lengths_along(const BladeSection& section) {
  std::vector<double> lengths = {0.0};
  for (std::size_t i = 1; i < section.size(); ++i)
    lengths.push_back(lengths.back() + distance(section[i].at, section[i - 1].at));
  return lengths;
}

std::vector<double> fractions_of_length(const BladeSection& section) {
  std::vector<double> lengths = lengths_along(section);
  const double whole = lengths.back();
  for (double& length : lengths) length /= whole;
  return lengths;
}

MeridionalPoint mid_chord(const BladeSection& section) {
  const std::vector<double> fractions = fractions_of_length(section);
  const auto after = std::upper_bound(fractions.begin(), fractions.end(), 0.5) - fractions.begin();
  const double t = (0.5 - fractions[after - 1]) / (fractions[after] - fractions[after - 1]);
  return (1.0 - t) * section[after - 1].at + t * section[after].at;
}

void require_on_wheel(const NamedText& file, int line, const MeridionalPoint& at) {
  if (wheel_length.holds(at.r) && std::abs(at.z) <= wheel_length.high) return;
  std::ostringstream message;
  message << "a point at r = " << at.r << " m, z = " << at.z << " m; r must be " << wheel_length.describe()
          << " m, and z at most that far off: is [mesh] length_unit right?";
  refuse_line(file, line, message.str());
}

BladeSection upright_section(const NamedText& file, int line, BladeSection section) {
  if (section.size() < fewest_points)
    refuse_line(file, line,
                "the section that begins here has " + std::to_string(section.size()) + " points, and needs " +
                    std::to_string(fewest_points));
  const auto thinner = [](const BladePoint& a, const BladePoint& b) {
    return std::abs(a.half_width) < std::abs(b.half_width);
  };
  const double widest = std::max_element(section.begin(), section.end(), thinner)->half_width;  // either sign
  if (widest == 0.0) refuse_line(file, line, "the section that begins here has no thickness");
  const double least = least_step * length_of(section);
  for (std::size_t i = 0; i < section.size(); ++i) {
    const std::string place = " at point " + std::to_string(i + 1) + " of " + std::to_string(section.size()) +
                              " of the section that begins here";
    if (i > 0 && distance(section[i].at, section[i - 1].at) <= least)
      refuse_line(file, line,
                  "two points at the same z and r" + place + "; they must go on from leading to trailing edge");
    if (section[i].half_width / widest < -negligible_width)
      refuse_line(file, line, "the sides of the blade change places" + place + "; each must keep to its own");
  }
  for (BladePoint& point : section) point.half_width = std::max(0.0, point.half_width / widest) * std::abs(widest);
  return section;
}

void require_blade(const NamedText& file, const std::vector<BladeSection>& sections) {
  if (sections.size() < 2)
    throw InputError(file.name + ": holds " + std::to_string(sections.size()) +
                     " sections of a blade; it must hold two or more, from hub to tip");
  const auto along = [&](std::size_t i) { return sections[i].back().at - sections[i].front().at; };
  const auto up = [&](std::size_t i) { return mid_chord(sections[i]) - mid_chord(sections[i - 1]); };
  for (std::size_t i = 1; i < sections.size(); ++i) {
    if (product(along(0), along(i)) <= 0.0)
      refuse_section(file, i, sections.size(), "runs against section 1; all must run from leading to trailing edge");
    if (distance(up(i), {0.0, 0.0}) <= least_step * length_of(sections[0]))
      refuse_section(file, i, sections.size(), "lies on the one before it at mid-chord");
    if (i == 1 && along(0).z * up(1).r - along(0).r * up(1).z <= 0.0)
      refuse_section(
          file, i, sections.size(),
          "lies below section 1; write sections from hub to tip, and a wheel whose flow runs towards smaller "
          "z with the signs of z and theta changed");
    if (i > 1 && product(up(i - 1), up(i)) <= 0.0)
      refuse_section(file, i, sections.size(), "turns back; sections must follow each other from hub to tip");
  }
}

}  // namespace tiprub::mesh
