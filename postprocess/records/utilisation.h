// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"

namespace tiprub::postprocess {

/// [1] Goodman's utilisation at every speed of the response: that of the cycle where one was recovered, elsewhere the
/// estimate FieldResults::utilisation; empty without that.
Eigen::VectorXd utilisation_over_speed(const Study& study, const FieldResults& fields);

/// The critical speed with the largest utilisation; of those of equal or no utilisation, that with the largest stress
/// of the vibration; without any stress, that with the largest amplitude. Nothing if no speed is critical.
std::optional<std::size_t> worst_critical(const Study& study, const FieldResults& fields);

}  // namespace tiprub::postprocess
