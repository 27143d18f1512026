// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "mesh/blades/blade_section.h"
#include "mesh/curves/smooth_table.h"

namespace tiprub::mesh {

/// A quantity of a section's points over the fraction of the meridional length.
template <class Value>
SmoothTable over_length(const BladeSection& section, Value value) {
  const std::vector<double> fractions = fractions_of_length(section);
  std::vector<std::array<double, 2>> points;
  for (std::size_t i = 0; i < section.size(); ++i) points.push_back({fractions[i], value(section[i])});
  return SmoothTable(std::move(points));
}

/// A blade through given sections: along a section over the fraction of its meridional length, between sections over
/// the fraction of the way from hub to tip (measured at mid-chord), both by SmoothTable.
class SectionSurface {
 public:
  /// The sections must have passed require_blade(). Within the fraction `blunt_edge` of the length from either edge
  /// the thickness stays constant, because a round edge would end in elements without thickness.
  SectionSurface(const std::vector<BladeSection>& sections, double blunt_edge);

  /// Chord 0 is the leading edge, span 0 the first section.
  BladePoint at(double chord, double span) const;

 private:
  /// z, r, theta, half width over the fraction of the length.
  using SectionTables = std::array<SmoothTable, 4>;

  double blunt_edge_;
  std::vector<SectionTables> tables_;
  std::vector<double> heights_;  ///< of the sections, from 0 to 1
};

/// A splitter that stands on the main blade's mean surface, turned by a fraction of the pitch, from its own leading
/// edge to the main blade's trailing edge. A sector's lattice can hold no other. Stations run along the main blade.
/// The splitter begins at the same station from hub to tip, so a station is a different fraction of the length at
/// each span.
class SplitterSurface {
 public:
  /// `pitch` [rad] is that of the main blades. Raises InputError, which begins with the file's name, if the splitter
  /// stands elsewhere.
  SplitterSurface(const std::string& file, const SectionSurface& main, const FileSplitter& splitter,
                  double blunt_edge, double pitch);

  double start() const { return start_; }  ///< the station of its leading edge
  /// The fraction of the main blade's length at a station.
  double main_chord(double station, double span) const;
  /// Over the splitter's own chord [rad].
  double half_width(double chord, double span) const { return surface_.at(chord, span).half_width; }

 private:
  SectionSurface surface_;
  SmoothTable starts_;  ///< the main blade's fraction at the splitter's leading edge, over the span
  double start_;
};

}  // namespace tiprub::mesh
