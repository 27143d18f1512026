// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "cases/program/case_file.h"
#include "mesh/curves/wheel_geometry.h"
#include "mesh/lattice/sector_plan.h"

namespace tiprub::mesh {

/// What [mesh] describes: the shape, and how to cut it into elements.
struct Wheel {
  SectorPlan plan;
  std::unique_ptr<WheelGeometry> geometry;
};

/// Reads the whole table, whatever its family, and checks that no blade is wider than its place. Raises InputError.
Wheel read_wheel(CaseTable& table);

}  // namespace tiprub::mesh
