// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "cases/program/case_file.h"
#include "mesh/curves/wheel_geometry.h"
#include "mesh/lattice/sector_plan.h"

namespace tiprub {

/// A wheel whose blades come from a file, with or without a disc that the keys describe. Reads and checks the keys of
/// this family and the file, and what they say about the plan. Raises InputError, and RunError if the file can't be
/// read.
std::unique_ptr<WheelGeometry> read_wheel_of_blade_file(CaseTable& table, SectorPlan& plan);

}  // namespace tiprub
