// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>

#include "cases/program/case_file.h"
#include "mesh/curves/blade_surface.h"
#include "mesh/curves/meridional_curve.h"
#include "mesh/curves/smooth_table.h"
#include "mesh/curves/wheel_geometry.h"
#include "mesh/lattice/sector_plan.h"

namespace tiprub {

/// The inner border of a radial wheel's disc: the bore from the front face to the back face, then the back face out
/// to the exit.
struct BackFace {
  double front_z;       ///< of the front face [m]
  double bore_radius;   ///< [m]
  double exit_radius;   ///< [m]
  SmoothTable profile;  ///< z of the back face over the radius [m]
  double bore_end;      ///< station of the corner between bore and back face

  static constexpr int fewest_stations = 2;  ///< one on the bore and one on the back face

  MeridionalPoint foot(double station) const;
};

/// Reads `back_profile`. Raises InputError.
SmoothTable read_back_profile(CaseTable& table);

/// Reads `elements_along_bore`; those along the chord must be known. Raises InputError.
void read_bore_elements(CaseTable& table, SectorPlan& plan);

/// A centrifugal impeller, by the dimensions that its designers use. The hub's leading edge is at z = 0, the flow
/// turns from the axis to the radius, the back face lies on the side of larger z.
struct ImpellerParameters {
  double inlet_hub_radius;         ///< [m]
  double inlet_tip_radius;         ///< [m]
  double exit_radius;              ///< [m]
  double exit_tip_width;           ///< blade height at the exit [m]
  double axial_length;             ///< of the hub, from leading edge to exit [m]
  std::array<double, 2> hub_arms;  ///< of the hub's Bezier curve, see MeridionalCurve
  std::array<double, 2> tip_arms;
  BladeAngles angles;
  SmoothTable thickness_root;  ///< over a blade's own chord [m]
  SmoothTable thickness_tip;
  double bore_radius;        ///< [m]
  SmoothTable back_profile;  ///< z of the back face over the radius [m]
};

/// Reads and checks the keys of this family, and what it says about the plan. Raises InputError.
ImpellerParameters read_impeller(CaseTable& table, SectorPlan& plan);

std::unique_ptr<WheelGeometry> make_impeller(const ImpellerParameters& parameters, const SectorPlan& plan);

}  // namespace tiprub
