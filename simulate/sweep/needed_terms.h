// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::simulate {

/// What a term that a sweep leaves out does to a critical speed, by the speed's error budget.
struct TermEffect {
  Variation term = Variation::friction;  ///< friction, or gap: its second order
  double setting = 0;                    ///< of the variation
  double speed = 0;                      ///< [rad/s] the critical speed without the term
  std::string failure = {};              ///< empty, or why the peak with the term was not found
  double shift = 0;                      ///< [1] relative change of the critical speed
  /// [1] relative change of the root of largest_elastic_energy(). Stress is proportional to this root as long as the
  /// shape of the motion stays the same; this program knows no stresses.
  double stress = 0;
};

/// [J] The largest elastic energy of a wheel at any instant of its motion, without that of spin. `nodal_diameters`
/// are those of the cycle.
double largest_elastic_energy(const RotorCycle& cycle, const std::vector<int>& nodal_diameters,
                              const ReducedModel& model, double speed);

/// The effects of the terms of contact that the budget of a speed varies; empty without a budget.
std::vector<TermEffect> term_effects(const SpeedResponse& response, const std::vector<int>& nodal_diameters,
                                     const ReducedModel& model);

/// Whether a term is needed, and the reason in a sentence.
struct Decision {
  bool is_needed = false;
  std::string reason;
};

/// A term is needed if it changes any of the critical speeds, or the stress there, by more than `accuracy` [1]. Where
/// the peak with the term was not found, it is not known, and the term stays off.
Decision decide(Variation term, const std::vector<TermEffect>& effects, double accuracy);

}  // namespace tiprub::simulate
