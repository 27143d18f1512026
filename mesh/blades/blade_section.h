// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "cases/program/text_file.h"
#include "mesh/curves/meridional_curve.h"

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

/// The section with positive half widths, whichever side the file gives first. Raises InputError at `line`, where the
/// section begins, if it has too few points, if two of them coincide, or if its sides cross.
BladeSection upright_section(const NamedText& file, int line, BladeSection section);

/// Raises InputError if there are fewer than two sections, if one runs against the first, or if they don't follow
/// each other from hub to tip.
void require_blade(const NamedText& file, const std::vector<BladeSection>& sections);

}  // namespace tiprub::mesh
