// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/motion/scene_choices.h"

namespace tiprub::simulate {

/// Interpolates points [x, y] with ascending x: linear between them, constant outside.
inline double linear_between(const std::vector<std::array<double, 2>>& points, double x) {
  if (x <= points.front()[0]) return points.front()[1];
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto& [x0, y0] = points[i - 1];
    const auto& [x1, y1] = points[i];
    if (x <= x1) return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
  }
  return points.back()[1];
}

/// [Hz] The frequency up to which the modes of a model are trusted: twice the highest frequency at which the model
/// was verified against the unreduced sector (the lowest of the last verified frequencies of all nodal diameters and
/// speeds). A bending wave of twice the frequency is shorter by a factor of 1.4; the error of quadratic elements
/// grows with the fourth power of that, and is four times as large. Infinite if the model came without verification.
double resolved_frequency(const ReducedModel& model);

/// Modal damping as ratios of critical: by family or by frequency up to the resolved frequency, and one ratio
/// beyond it. The modes beyond represent the compliance of the tips, but their frequencies are artefacts of the
/// mesh. With the small damping of a wheel they would ring after each impact, and the motion would not settle.
struct Damping {
  DampingRatios ratios{.by_family = {0.0}};
  double resolved_frequency = std::numeric_limits<double>::infinity();  ///< [Hz] modes above it get ratios.beyond

  Damping() = default;
  Damping(std::initializer_list<double> by_family) : ratios{.by_family = by_family} {}

  /// [1] of critical, for mode `family` (from 0) of a nodal diameter at its frequency [Hz].
  double ratio(int nodal_diameter, int family, double frequency) const;
  /// [1] The largest ratio of resolved modes.
  double largest() const;
  /// [1] the smallest of them.
  double smallest() const;
};

/// [1] of critical. The range ends below critical damping, where modes no longer oscillate and the coefficients of
/// the step are singular.
extern const Range damping_range;

/// Reads the keys of [simulate] that give the damping of resolved modes. Raises InputError.
Damping read_damping(CaseTable& table);

/// Refuses the damping of a mode that the model does not have, or that lies above the resolved frequency at rest
/// and at the highest speed of the model. Raises InputError at its row.
void require_modes_of_wheel(const CaseTable& table, const Damping& damping, const ReducedModel& model);

}  // namespace tiprub::simulate
