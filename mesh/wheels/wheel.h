// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "cases/program/case_file.h"
#include "mesh/curves/wheel_geometry.h"
#include "mesh/wheels/sector_plan.h"

namespace tiprub::mesh {

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
