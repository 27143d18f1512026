// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/blade_files.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "cases/program/text.h"
#include "mesh/blades/blade_section.h"

namespace tiprub::mesh {

namespace {

constexpr double allowed_gap = 0.01;  // of the blade's height, between hub and first section
constexpr std::size_t fewest_sections = 9;
constexpr int bisections = 50;

// Where a function that is negative at the low end and positive at the high one changes sign.
double sign_change(const std::function<double(double)>& function, double low, double high) {
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    (function(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The spans at which a blade meets the hub and ends below the shroud.
class Cut {
 public:
  Cut(const SectionSurface& blade, const MeridionalPath& hub, const MeridionalPath& shroud, double clearance)
      : blade_(blade),
        hub_(hub),
        shroud_(shroud),
        clearance_(clearance),
        inward_(nearest_on(hub, shroud[shroud.size() / 2]).beside > 0.0 ? 1.0 : -1.0) {}

  double above_hub(double chord, double span) const {
    return inward_ * nearest_on(hub_, blade_.at(chord, span).at).beside;
  }
  double root(double chord) const {
    if (above_hub(chord, 0.0) >= 0.0) return 0.0;
    return sign_change([&](double span) { return above_hub(chord, span); }, 0.0, 1.0);
  }
  double tip(double chord) const {
    const auto beyond = [&](double span) {
      return clearance_ + inward_ * nearest_on(shroud_, blade_.at(chord, span).at).beside;
    };
    return beyond(1.0) <= 0.0 ? 1.0 : sign_change(beyond, 0.0, 1.0);
  }

 private:
  const SectionSurface& blade_;
  const MeridionalPath& hub_;
  const MeridionalPath& shroud_;
  double clearance_;
  double inward_;  ///< the side of the paths on which the channel lies
};

void require_on_hub(const Cut& cut, double chord, const std::string& blade_name, const std::string& hub_name) {
  const double first = cut.above_hub(chord, 0.0), last = cut.above_hub(chord, 1.0);
  if (first <= allowed_gap * last && cut.root(chord) < cut.tip(chord)) return;
  throw InputError(text_of(blade_name, ": the blade stands from ", first, " to ", last, " m above ", hub_name, " at ",
                           chord,
                           " of its length; its first profile must lie on the hub or below, its last one above"));
}

constexpr std::size_t coordinates = 3;
constexpr double same_place = 1e-9;        // of a section's length
constexpr double allowed_mismatch = 0.05;  // of a section's length: between the meridional curves of its sides

BladePoint point_of(const NamedText& file, const NumberLine& line, double length) {
  const auto coordinate = [&](std::size_t word, const char* meaning) {
    return length * number_in(file, line, word, meaning);
  };
  const double x = coordinate(0, "x"), y = coordinate(1, "y"), z = coordinate(2, "z");
  const auto is_mark = [](std::string_view word) {
    return word.starts_with("le") || word.starts_with("te") || word.starts_with("LE") || word.starts_with("TE");
  };
  for (std::size_t word = coordinates; word < line.words.size(); ++word)
    if (!is_mark(line.words[word]))
      refuse_line(file, line.number, "a point is x, y, z and perhaps a mark le or te; there is more");
  const MeridionalPoint at{z, std::hypot(x, y)};
  require_on_wheel(file, line.number, at);
  return {at, std::atan2(y, x), 0.0};
}

/// The points once round a profile; their angles have no jumps.
using Loop = BladeSection;

void close(Loop& loop) {
  for (std::size_t i = 1; i < loop.size(); ++i)
    loop[i].theta = loop[i - 1].theta + std::remainder(loop[i].theta - loop[i - 1].theta, 2.0 * std::numbers::pi);
}

/// The indices of the leading and the trailing edge in the loop.
std::pair<std::size_t, std::size_t> edges(const Loop& loop, const MeridionalPath& hub) {
  std::pair<std::size_t, std::size_t> found{0, 0};
  for (std::size_t i = 0; i < loop.size(); ++i)
    for (std::size_t k = i + 1; k < loop.size(); ++k)
      if (distance(loop[i].at, loop[k].at) > distance(loop[found.first].at, loop[found.second].at)) found = {i, k};
  if (nearest_on(hub, loop[found.first].at).along > nearest_on(hub, loop[found.second].at).along)
    std::swap(found.first, found.second);
  return found;
}

/// One side from leading to trailing edge, along the loop or against it. Where an edge stands across the flow,
/// several points coincide in the meridional plane; the side keeps only the one that belongs to it.
BladeSection side(const Loop& loop, std::size_t from, std::size_t to, std::size_t step) {
  const double least = same_place * distance(loop[from].at, loop[to].at);
  BladeSection points;
  for (std::size_t i = from;; i = (i + step) % loop.size()) {
    if (points.empty() || distance(points.back().at, loop[i].at) > least)
      points.push_back(loop[i]);
    else if (points.size() == 1)
      points.back() = loop[i];
    if (i == to) return points;
  }
}

/// Mean line and thickness from two sides, at the points of the first.
BladeSection between(const NamedText& file, int line, const BladeSection& one, const BladeSection& other) {
  const SmoothTable z = over_length(other, [](const BladePoint& p) { return p.at.z; });
  const SmoothTable r = over_length(other, [](const BladePoint& p) { return p.at.r; });
  const SmoothTable theta = over_length(other, [](const BladePoint& p) { return p.theta; });
  const std::vector<double> fractions = fractions_of_length(one);
  const double allowed = allowed_mismatch * distance(one.front().at, one.back().at);
  BladeSection section;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const MeridionalPoint opposite{z.at(fractions[i]), r.at(fractions[i])};
    if (distance(one[i].at, opposite) > allowed)
      refuse_line(
          file, line,
          "the sides of the profile that begins here go different ways in the meridional plane; both must lie "
          "on one surface of revolution");
    const double angle = theta.at(fractions[i]);
    section.push_back({0.5 * (one[i].at + opposite), 0.5 * (one[i].theta + angle), 0.5 * (one[i].theta - angle)});
  }
  return section;
}

BladeSection section_of(const NamedText& file, int line, Loop loop, const MeridionalPath& hub) {
  constexpr std::size_t fewest = 6;  // three a side
  if (loop.size() < fewest)
    refuse_line(file, line,
                "the profile that begins here has " + std::to_string(loop.size()) + " points, and needs " +
                    std::to_string(fewest));
  close(loop);
  const auto [leading, trailing] = edges(loop, hub);
  if (distance(loop[leading].at, loop[trailing].at) <= 0.0)
    refuse_line(file, line, "the profile that begins here is a point in the meridional plane");
  return upright_section(
      file, line,
      between(file, line, side(loop, leading, trailing, 1), side(loop, leading, trailing, loop.size() - 1)));
}

}  // namespace

PlaceOnPath nearest_on(const MeridionalPath& path, const MeridionalPoint& point) {
  PlaceOnPath nearest{0.0, std::numeric_limits<double>::infinity()};
  double before = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const MeridionalPoint way = path[i] - path[i - 1], to = point - path[i - 1];
    const double length = length_of(way);
    const double t = std::clamp((way.z * to.z + way.r * to.r) / (length * length), 0.0, 1.0);
    const double distance = length_of(to - t * way);
    const double left = way.z * to.r - way.r * to.z;
    if (distance < std::abs(nearest.beside)) nearest = {before + t * length, left < 0.0 ? -distance : distance};
    before += length;
  }
  return nearest;
}

FileBlade cut_to_path(const FileBlade& blade, const MeridionalPath& hub, const MeridionalPath& shroud,
                      double clearance, const std::string& blade_name, const std::string& hub_name) {
  const SectionSurface whole(blade.sections, 0.0);
  const Cut cut(whole, hub, shroud, clearance);
  FileBlade standing = blade;
  standing.sections.assign(std::max(fewest_sections, blade.sections.size()), {});
  for (const double chord : fractions_of_length(blade.sections.front())) {
    require_on_hub(cut, chord, blade_name, hub_name);
    const double root = cut.root(chord), tip = cut.tip(chord);
    for (std::size_t i = 0; i < standing.sections.size(); ++i)
      standing.sections[i].push_back(
          whole.at(chord, root + (tip - root) * static_cast<double>(i) / (standing.sections.size() - 1)));
  }
  return standing;
}

MeridionalPath read_path_curve(const NamedText& file, double length) {
  MeridionalPath path;
  for (const NumberLine& line : lines_of(file)) {
    if (line.words.empty()) continue;
    const MeridionalPoint at = point_of(file, line, length).at;
    if (path.size() >= most_points) refuse_line(file, line.number, "more points than any curve has");
    if (path.empty() || distance(path.back(), at) > 0.0) path.push_back(at);
  }
  if (path.size() < 2)
    throw InputError(file.name + ": holds " + std::to_string(path.size()) +
                     " points; it must hold two or more, x y z a line, from inlet to outlet");
  return path;
}

FileBlade read_profile_curve(const NamedText& file, double length, const MeridionalPath& hub) {
  FileBlade blade;
  blade.file = file.name;
  Loop loop;
  int begun = 0;  // the line where the profile began
  const auto end_profile = [&] {
    if (loop.empty()) return;
    if (blade.sections.size() >= most_sections) refuse_line(file, begun, "more profiles than any blade has");
    blade.sections.push_back(section_of(file, begun, std::move(loop), hub));
    loop.clear();
  };
  for (const NumberLine& line : lines_of(file)) {
    if (line.words.empty()) {
      end_profile();
      if (line.remark.starts_with("##") && !blade.sections.empty())
        refuse_line(file, line.number, "a second blade begins here; only one can be taken: leave splitters out");
      continue;
    }
    if (loop.empty()) begun = line.number;
    loop.push_back(point_of(file, line, length));
    if (loop.size() > most_points) refuse_line(file, line.number, "more points than any profile has");
  }
  end_profile();
  count_angles_on(blade.sections);
  require_blade(file, blade.sections);
  return blade;
}

}  // namespace tiprub::mesh
