// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/blades/blade_section.h"
#include "mesh/curves/smooth_table.h"

namespace tiprub {

/// A blade through given sections: along a section over the fraction of its meridional length, between sections over
/// the fraction of the way from hub to tip (measured at mid-chord), both by SmoothTable.
class SectionSurface {
 public:
  /// Sections are sound (see require_blade). Over the fraction `blunt_edge` of the length at either edge the blade
  /// keeps the thickness that it has there: a round edge would end in elements without thickness.
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

}  // namespace tiprub
