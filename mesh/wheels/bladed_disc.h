// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "cases/program/case_file.h"
#include "mesh/curves/smooth_table.h"
#include "mesh/curves/wheel_geometry.h"
#include "mesh/lattice/sector_plan.h"

namespace tiprub {

/// An annular disc, with axial blades on its rim or bare. The rim's middle is at z = 0, the leading edge at
/// z = -axial_length / 2.
struct BladedDiscParameters {
  double bore_radius;          ///< [m]
  double rim_radius;           ///< [m]
  double axial_length;         ///< of the rim and of the blades [m]
  SmoothTable disc_profile;    ///< the disc's axial thickness over the radius [m]
  double tip_radius;           ///< [m]; the rim's without blades
  double stagger_root;         ///< between blade and axis, positive towards +theta downstream [rad]
  double stagger_tip;          ///< [rad]; the root's for a straight blade
  SmoothTable thickness_root;  ///< over the chord [m]
  SmoothTable thickness_tip;
};

/// Reads and checks the keys of this family, and what it says about the plan. Raises InputError.
BladedDiscParameters read_bladed_disc(CaseTable& table, SectorPlan& plan);

std::unique_ptr<WheelGeometry> make_bladed_disc(const BladedDiscParameters& parameters);

}  // namespace tiprub
