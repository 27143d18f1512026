// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/reduced_model.h"
#include "simulate/motion/scene_choices.h"

namespace tiprub {

/// [Hz] up to which a model's modes are taken for those of the wheel: twice the highest frequency at which it was
/// verified against the unreduced sector (the lowest of the nodal diameters' last ones, at any speed). A bending wave
/// of twice the frequency is 1.4 times as short, so that quadratic bricks, whose error goes as the fourth power of
/// that, are four times as wrong there. Infinite if the model came without verification.
double resolved_frequency(const ReducedModel& model);

/// Modal damping: ratios of critical, by family or by frequency, up to the highest frequency that is resolved;
/// another ratio beyond it. Modes beyond stand for the compliance of the tips; their frequencies are the mesh's, and
/// with a wheel's own small damping they ring on after each impact and keep a motion from settling that is none of
/// theirs.
class Damping {
 public:
  using Table = decltype(DampingRatios::by_frequency);

  Damping() = default;
  /// The first family's, the second's, ...; the last one holds for all further ones.
  explicit Damping(std::vector<double> by_family) : ratios_{.by_family = std::move(by_family)} {}
  Damping(std::initializer_list<double> by_family) : ratios_{.by_family = by_family} {}
  /// Linear between the points, level outside.
  explicit Damping(Table by_frequency) : ratios_{.by_frequency = std::move(by_frequency)} {}

  /// Modes above `frequency` [Hz] take `ratio`.
  void set_beyond(double frequency, double ratio);
  /// [1] of critical of mode `family` (from 0) of a nodal diameter, at its frequency [Hz].
  double ratio(std::size_t family, double frequency) const;
  /// [1] the largest of those given for resolved modes.
  double largest() const;
  const DampingRatios& ratios() const { return ratios_; }

 private:
  DampingRatios ratios_{.by_family = {0.0}};
  double resolved_ = std::numeric_limits<double>::infinity();
};

/// [1] of critical: modes that swing, with room to the critical damping, at which the march divides by nothing.
extern const Range damping_range;

/// Reads the keys of [simulate] that give the damping, without what the model says of its resolution. Raises
/// InputError.
Damping read_damping(CaseTable& table);

}  // namespace tiprub
