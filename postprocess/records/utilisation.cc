// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/records/utilisation.h"

#include <array>

namespace tiprub::postprocess {

Eigen::VectorXd utilisation_over_speed(const Study& study, const FieldResults& fields) {
  Eigen::VectorXd utilisation = fields.utilisation;
  if (utilisation.size() == 0) return utilisation;
  const auto take = [&](const std::optional<FieldPeak>& peak, Eigen::Index index) {
    if (peak && peak->cycle && peak->cycle->goodman) utilisation[index] = *peak->cycle->goodman;
  };
  for (std::size_t i = 0; i < study.critical.size(); ++i) take(fields.peaks[i], study.critical[i].index);
  take(fields.of_no_critical, study.amplitudes.worst());
  return utilisation;
}

std::optional<std::size_t> worst_critical(const Study& study, const FieldResults& fields) {
  const Eigen::VectorXd utilisation = utilisation_over_speed(study, fields);
  const auto severity = [&](std::size_t i) {
    const CriticalSpeed& peak = study.critical[i];
    return std::array{utilisation.size() > 0 ? utilisation[peak.index] : 0.0,
                      fields.peaks[i] ? fields.peaks[i]->body.vibration : 0.0, peak.amplitude};
  };
  std::optional<std::size_t> worst;
  for (std::size_t i = 0; i < study.critical.size(); ++i)
    if (!worst || severity(i) > severity(*worst)) worst = i;
  return worst;
}

}  // namespace tiprub::postprocess
