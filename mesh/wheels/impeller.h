// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/program/case_file.h"
#include "mesh/curves/meridional_curve.h"
#include "mesh/curves/smooth_table.h"
#include "mesh/wheels/sector_plan.h"

namespace tiprub::mesh {

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

}  // namespace tiprub::mesh
