// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/drift_record.h"

namespace tiprub {

Table drift_record(const Study& study) {
  Table table{{"edge", "slope [s]", "intercept [rad]", "R^2", "tip length [m]", "tip length over slope [m/s]"}, {}};
  const Eigen::VectorXd& arc = study.model.contact.arc_length;
  const auto add = [&](const char* edge, const ContactDrift& drift) {
    table.rows.push_back({std::string(edge), drift.slope, drift.intercept, drift.determination,
                          arc[arc.size() - 1] - arc[0], drift.implied_wave_speed});
  };
  add("leading", study.leading_drift);
  add("trailing", study.trailing_drift);
  return table;
}

}  // namespace tiprub
