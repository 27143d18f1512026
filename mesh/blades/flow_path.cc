// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/flow_path.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include "mesh/blades/section_surface.h"

namespace tiprub {

namespace {

constexpr double allowed_gap = 0.01;  // of the blade's height, between hub and first section
constexpr std::size_t fewest_sections = 9;
constexpr int bisections = 50;

double length_of(const MeridionalPoint& step) {
  return std::hypot(step.z, step.r);
}

// Where a function that is negative at the low end and positive at the high one changes sign.
double sign_change(const std::function<double(double)>& function, double low, double high) {
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    (function(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The spans between which a blade stands in its path.
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
  std::ostringstream message;
  message << blade_name << ": the blade stands from " << first << " to " << last << " m above " << hub_name << " at "
          << chord << " of its length; its first profile must lie on the hub or below, its last one above";
  throw InputError(message.str());
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

}  // namespace tiprub
