// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/branch_record.h"

#include <numbers>

#include "postprocess/analysis/orbit_branches.h"
#include "postprocess/records/columns.h"
#include "postprocess/tables/units.h"

namespace tiprub {

Table branch_record(const Study& study) {
  Table table{{"branch", "speed [rpm]", "amplitude [mm]", "multiplier [1]", "uncertainty [1]", "angle a map [deg]",
               "attracts", "kind"},
              {}};
  for (std::size_t b = 0; b < study.response.branches.size(); ++b) {
    const OrbitBranch& branch = study.response.branches[b];
    for (Eigen::Index i = 0; i < branch.speed.size(); ++i)
      table.rows.push_back({static_cast<int>(b), branch.speed[i] * rpm_per_rad_s, branch.amplitude[i] * mm_per_m,
                            branch.multiplier[i], branch.multiplier_uncertainty[i],
                            branch.multiplier_angle[i] * 180 / std::numbers::pi, yes_or_no(branch.attracts(i)),
                            name_of(instability(branch.multiplier_angle[i]))});
  }
  return table;
}

}  // namespace tiprub
