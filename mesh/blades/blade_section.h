// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cases/program/text_file.h"
#include "mesh/curves/meridional_curve.h"
#include "mesh/curves/smooth_table.h"

namespace tiprub::mesh {

/// A point of a blade's mean line.
struct BladePoint {
  MeridionalPoint at;
  double theta;       ///< [rad]
  double half_width;  ///< of the blade along the circle [rad]
};

/// From leading to trailing edge.
using BladeSection = std::vector<BladePoint>;

/// A shorter blade between two main blades.
struct FileSplitter {
  std::vector<BladeSection> sections;  ///< from hub to tip
  double pitch_fraction;               ///< its place between two main blades, towards +theta
};

/// A blade as every format of blade files gives it.
struct FileBlade {
  std::string file;                    ///< its name, for messages
  std::vector<BladeSection> sections;  ///< from hub to tip
  std::optional<FileSplitter> splitter;
  std::optional<int> blade_count;  ///< of the wheel, if the file gives it
};

/// The units of a file's numbers.
struct FileUnits {
  double length;  ///< [m] of one unit
  double angle;   ///< [rad] of one unit
};

/// The largest numbers of points in a section, and of sections in a blade, that are read.
inline constexpr int most_points = 2000, most_sections = 1000;

/// Raises InputError, with the line, if a point lies on the axis or more than 10 m away, as no point of a wheel does.
void require_on_wheel(const NamedText& file, int line, const MeridionalPoint& at);

/// [m] The meridional length from the leading edge to each point.
std::vector<double> lengths_along(const BladeSection& section);

/// The fraction of the meridional length at each point, from 0 to 1.
std::vector<double> fractions_of_length(const BladeSection& section);

/// Where half of the meridional length lies on either side.
MeridionalPoint mid_chord(const BladeSection& section);

/// An angle [rad], by whole turns the one nearest to another: files may count angles from -pi to pi.
double angle_beside(double other, double angle);

/// Takes jumps by whole turns out of the angles, from point to point and from section to section.
void count_angles_on(std::vector<BladeSection>& sections);

/// The section with positive half widths, whichever side the file gives first. Raises InputError at `line`, where the
/// section begins, if it has too few points, if two of them coincide, or if its sides cross.
BladeSection upright_section(const NamedText& file, int line, BladeSection section);

/// Raises InputError if there are fewer than two sections, if one runs against the first, or if they don't follow
/// each other from hub to tip.
void require_blade(const NamedText& file, const std::vector<BladeSection>& sections);

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
