// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>

#include "postprocess/analysis/study.h"

namespace tiprub {

/// What all sectors do at the speed that is shown.
struct SectorSignal {
  std::string what;        ///< begins a caption: "The normal displacement, leading edge"
  std::string unit;        ///< of the values
  Eigen::MatrixXd values;  ///< a row a sample, a column a sector
};

/// [mm] of the map's component at its contact node.
SectorSignal motion_of_sectors(const Study& study);
/// [N] the contact force at that node.
SectorSignal force_of_sectors(const Study& study);

/// "12300 rpm": the speed that is shown.
std::string shown_speed_text(const Study& study);

}  // namespace tiprub
