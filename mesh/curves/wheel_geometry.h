// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/curves/meridional_curve.h"

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

}  // namespace tiprub::mesh
