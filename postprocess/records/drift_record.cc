// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/drift_record.h"

#include <cmath>

namespace tiprub {

Table drift_record(const Study& study) {
  Table table{{"what", "slope [s]", "intercept [rad]", "R^2", "tip length [m]", "tip length over slope [m/s]",
               "median lag [s]", "lower quartile [s]", "upper quartile [s]"},
              {}};
  const Eigen::VectorXd& arc = study.model.contact.arc_length;
  const double length = arc[study.model.contact.trailing_edge()] - arc[0];
  const auto add = [&](const char* edge, const ContactDrift& drift) {
    const Cell none = std::string();
    table.rows.push_back({std::string(edge), drift.slope, drift.intercept, drift.determination, length,
                          drift.implied_wave_speed, none, none, none});
  };
  add("leading edge's middle", study.leading_drift);
  add("trailing edge's middle", study.trailing_drift);
  const EdgeLag& lag = study.edge_lag;
  table.rows.push_back({"leading edge's force after the trailing edge's", lag.slope, lag.intercept, lag.determination,
                        length, lag.slope != 0 ? length / std::abs(lag.slope) : 0.0, lag.median, lag.lower_quartile,
                        lag.upper_quartile});
  return table;
}

}  // namespace tiprub
