// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>

#include "postprocess/analysis/study.h"
#include "postprocess/fields/field_study.h"

namespace tiprub::postprocess {

/// [1] Goodman's utilisation at every speed of the response; empty if no cycle is rated. It is exact where a cycle
/// is. Elsewhere FieldResults::over_speed, times its ratio to the alternating stress of the nearest rated speed,
/// stands for the alternating stress, and the mean stress is that speed's.
Eigen::VectorXd utilisation_over_speed(const Study& study, const FieldResults& fields);

/// The critical speed with the largest utilisation; of those of equal or no utilisation, that with the largest stress
/// of the vibration; without any stress, that with the largest amplitude. Nothing if no speed is critical.
std::optional<std::size_t> worst_critical(const Study& study, const FieldResults& fields);

}  // namespace tiprub::postprocess
