// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "cases/program/case_file.h"
#include "mesh/curves/meridional_curve.h"
#include "mesh/wheels/sector_plan.h"

namespace tiprub::mesh {

enum class BladeKind { main, splitter };

/// A part of the sector; volumes of the file are named after it.
enum class Region { disc, main_blade, splitter };

/// The shape of a wheel, as the mesher sees it: a disc and blades on it, whose cells follow the blades' wrap. A
/// station runs from leading edge (0) to trailing edge (1). The radius and the axial position of a point don't depend
/// on the angle, so that thickness is spread along circles.
class WheelGeometry {
 public:
  virtual ~WheelGeometry() = default;

  /// Height 0 is the bore or the back face, 1 the hub.
  virtual MeridionalPoint disc_point(double station, double height) const = 0;
  /// Span 0 is the hub, 1 the tip.
  virtual MeridionalPoint blade_point(double station, double span) const = 0;
  /// Where the main blade's mid-thickness surface is [rad]. The sector's cuts follow it at span 0.
  virtual double theta(double station, double span) const = 0;
  /// Half of the blade's thickness along the circle [rad]. At span 0 it is asked for at every station, also upstream
  /// of a splitter, whose columns go on through the disc.
  virtual double half_width(BladeKind blade, double station, double span) const = 0;
  /// The span at which the fillet at the root ends; 0 without one.
  virtual double fillet_end(double /*station*/) const { return 0.0; }
  /// The keys of [mesh] that shape this part, for messages.
  virtual std::string keys_that_shape(Region region) const = 0;
};

/// What [mesh] describes: the shape, and how to cut it into elements.
struct Wheel {
  SectorPlan plan;
  std::unique_ptr<WheelGeometry> geometry;
};

/// Reads the whole table, whatever its family, and checks that no blade is wider than its place. Raises InputError.
Wheel read_wheel(CaseTable& table);

// Each family of wheels reads and checks its own keys, and completes the plan by what they say. Raises InputError,
// and RunError if a file can't be read.

/// A centrifugal impeller, by the dimensions that its designers use.
std::unique_ptr<WheelGeometry> read_impeller(CaseTable& table, SectorPlan& plan);

/// An annular disc, with axial blades on its rim or bare.
std::unique_ptr<WheelGeometry> read_bladed_disc(CaseTable& table, SectorPlan& plan);

/// A wheel whose blades come from a file, with or without a disc that the keys describe.
std::unique_ptr<WheelGeometry> read_wheel_of_blade_file(CaseTable& table, SectorPlan& plan);

}  // namespace tiprub::mesh
