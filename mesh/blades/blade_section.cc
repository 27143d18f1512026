// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/blade_section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cases/program/text.h"

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
  const auto after = std::ranges::upper_bound(fractions, 0.5) - fractions.begin();
  const double t = (0.5 - fractions[after - 1]) / (fractions[after] - fractions[after - 1]);
  return (1.0 - t) * section[after - 1].at + t * section[after].at;
}

void require_on_wheel(const NamedText& file, int line, const MeridionalPoint& at) {
  if (wheel_length.holds(at.r) && std::abs(at.z) <= wheel_length.high) return;
  refuse_line(file, line,
              text_of("a point at r = ", at.r, " m, z = ", at.z, " m; r must be ", wheel_length.describe(),
                      " m, and z at most that far off: is [mesh] length_unit right?"));
}

double angle_beside(double other, double angle) {
  constexpr double turn = 2 * std::numbers::pi;
  return angle - turn * std::round((angle - other) / turn);
}

void count_angles_on(std::vector<BladeSection>& sections) {
  for (std::size_t k = 0; k < sections.size(); ++k)
    for (std::size_t i = 0; i < sections[k].size(); ++i)
      if (i > 0 || k > 0)
        sections[k][i].theta =
            angle_beside(i > 0 ? sections[k][i - 1].theta : sections[k - 1].front().theta, sections[k][i].theta);
}

BladeSection upright_section(const NamedText& file, int line, BladeSection section) {
  if (section.size() < fewest_points)
    refuse_line(file, line,
                "the section that begins here has " + std::to_string(section.size()) + " points, and needs " +
                    std::to_string(fewest_points));
  const auto thinner = [](const BladePoint& a, const BladePoint& b) {
    return std::abs(a.half_width) < std::abs(b.half_width);
  };
  const double widest = std::ranges::max_element(section, thinner)->half_width;  // either sign
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

namespace {

constexpr int spans = 8;     // intervals, where the leading edge is looked for
constexpr int pieces = 400;  // of the main blade's line there
constexpr double earliest = 0.05, latest = 0.95;
constexpr double allowed_distance = 0.02;  // of the main blade's length, in the meridional plane
constexpr double allowed_turn = 0.02;      // of the pitch

struct Nearest {
  double chord;
  double distance;  ///< [m]
};

/// The place on the main blade's line at a span that is nearest to a point.
Nearest nearest_chord(const SectionSurface& main, double span, const MeridionalPoint& point) {
  Nearest nearest{0.0, std::numeric_limits<double>::infinity()};
  MeridionalPoint from = main.at(0.0, span).at;
  for (int i = 0; i < pieces; ++i) {
    const MeridionalPoint to = main.at((i + 1.0) / pieces, span).at, way = to - from, beside = point - from;
    const double t = std::clamp((way.z * beside.z + way.r * beside.r) / (way.z * way.z + way.r * way.r), 0.0, 1.0);
    const double distance = length_of(beside - t * way);
    if (distance < nearest.distance) nearest = {(i + t) / pieces, distance};
    from = to;
  }
  return nearest;
}

[[noreturn]] void refuse(const std::string& file, double span, const char* what, double amount, const char* unit) {
  throw InputError(
      text_of(file, ": the splitter ", what, " by ", amount, " ", unit, " at ", span,
              " of the span; it must stand on the main blade's mean surface, turned by its pitch fraction, and end "
              "with it"));
}

SmoothTable find_starts(const std::string& file, const SectionSurface& main, const SectionSurface& splitter) {
  std::vector<std::array<double, 2>> starts;
  for (int i = 0; i <= spans; ++i) {
    const double span = static_cast<double>(i) / spans;
    const double allowed = allowed_distance * length_of(main.at(1.0, span).at - main.at(0.0, span).at);
    const Nearest leading = nearest_chord(main, span, splitter.at(0.0, span).at);
    const double end = length_of(splitter.at(1.0, span).at - main.at(1.0, span).at);
    if (leading.distance > allowed) refuse(file, span, "begins beside the main blade's line", leading.distance, "m");
    if (end > allowed) refuse(file, span, "misses the main blade's trailing edge", end, "m");
    if (leading.chord < earliest || leading.chord > latest)
      throw InputError(file + ": the splitter begins at " + std::to_string(leading.chord) +
                       " of the main blade's length; it must begin between 0.05 and 0.95");
    starts.push_back({span, leading.chord});
  }
  return SmoothTable(std::move(starts));
}

}  // namespace

SectionSurface::SectionSurface(const std::vector<BladeSection>& sections, double blunt_edge)
    : blunt_edge_(blunt_edge), heights_{0.0} {
  for (const BladeSection& section : sections) {
    const auto table = [&](auto value) { return over_length(section, value); };
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

SplitterSurface::SplitterSurface(const std::string& file, const SectionSurface& main, const FileSplitter& splitter,
                                 double blunt_edge, double pitch)
    : surface_(splitter.sections, blunt_edge), starts_(find_starts(file, main, surface_)), start_(starts_.at(0.5)) {
  // The file may give the splitter at its own angle or at the main blade's. Whole pitches don't matter.
  const auto apart = [&](double chord, double span) {
    const double station = start_ + chord * (1.0 - start_);
    return surface_.at(chord, span).theta - main.at(main_chord(station, span), span).theta;
  };
  const double own = std::remainder(apart(1.0, 0.0) - splitter.pitch_fraction * pitch, pitch);
  const double turned =
      std::abs(own) < std::abs(std::remainder(apart(1.0, 0.0), pitch)) ? splitter.pitch_fraction * pitch : 0.0;
  for (const double span : {0.0, 0.5, 1.0})
    for (const double chord : {0.0, 0.5, 1.0})
      if (const double off = std::abs(std::remainder(apart(chord, span) - turned, pitch)); off > allowed_turn * pitch)
        refuse(file, span, "leaves the main blade's mean surface", off, "rad");
}

double SplitterSurface::main_chord(double station, double span) const {
  const double own = starts_.at(span);
  return station <= start_ ? station * own / start_ : own + (station - start_) * (1.0 - own) / (1.0 - start_);
}

}  // namespace tiprub::mesh
