// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "postprocess/analysis/postprocess_parameters.h"
#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub {

/// Responses of the same case swept up and down; an empty path: there is none.
struct SweepFiles {
  std::filesystem::path up, down;
};

/// One speed reached in another way: by a sweep that carried its motion along from the speed before.
struct SweptSpeed {
  double amplitude = 0;  ///< [m] half of the peak-to-peak, the largest over sectors and nodes
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;
  /// [1] of the two-way spectra at whole engine orders, at the maps' contact node: norm of the difference to the
  /// response from rest over the larger of the two norms. Spectra, because irregular motions never repeat sample by
  /// sample.
  double difference = 0;
  bool differs = false;  ///< far above the settling tolerance; of irregular motions, above what chance makes
};

/// A speed of the response beside what sweeps up and down came to; nothing where a sweep has no such speed.
struct SweepComparison {
  Eigen::Index index = 0;  ///< in the response's speeds
  std::optional<SweptSpeed> up, down;

  bool differs() const { return (up && up->differs) || (down && down->differs); }
};

/// One entry a speed of `response`, or none if neither sweep is given. Reads the files one after the other; raises
/// RunError as read_response() does, InputError if a sweep is of another casing or another rotor.
std::vector<SweepComparison> compare_sweeps(const Response& response, const ContactLine& contact, int node,
                                            Component component, const SweepFiles& files);

}  // namespace tiprub
