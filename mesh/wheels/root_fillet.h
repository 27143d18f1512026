// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "cases/program/case_file.h"
#include "mesh/curves/wheel_geometry.h"
#include "mesh/lattice/sector_plan.h"

namespace tiprub {

/// Reads `fillet_radius`, and gives the wheel that fillet where the hub meets either flank of its blades: at height h
/// above the hub, along the span, a flank stands out by radius - sqrt(h (2 radius - h)) across the blade, a quarter
/// of a circle that leaves the flank smoothly and runs out on the hub. With radius 0 the wheel is returned as it is.
/// The family's part of the plan must be known. Raises InputError.
std::unique_ptr<WheelGeometry> read_root_fillet(CaseTable& table, SectorPlan& plan,
                                                std::unique_ptr<WheelGeometry> wheel);

}  // namespace tiprub
