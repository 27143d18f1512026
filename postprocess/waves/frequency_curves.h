// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/model/reduced_model.h"

namespace tiprub {

/// Natural frequencies of the model over speed, by nodal diameter and family (0 is the lowest).
///
/// The squares of the frequencies are nearly polynomials of Omega^2 (eq. 11), so they are solved at `speed_samples`
/// speeds and read in between through the cubic (in Omega^2) of the four nearest: exact where K2 = 0 and shapes don't
/// change with speed. Costs speed_samples eigenvalue problems a nodal diameter, each nodal diameter in its own
/// thread.
class FrequencyCurves {
 public:
  static constexpr int speed_samples = 33;

  /// Curves over 0 .. speed_max [rad/s].
  FrequencyCurves(const ReducedModel& model, double speed_max);

  int nodal_diameters() const { return static_cast<int>(squares_.size()); }
  int families(int nodal_diameter) const { return static_cast<int>(squares_[nodal_diameter].cols()); }
  /// [Hz] at a speed [rad/s]; negative where the rotor is unstable.
  double frequency(int nodal_diameter, int family, double speed) const;
  /// The family whose frequency at this speed is nearest to one [Hz].
  int nearest_family(int nodal_diameter, double frequency, double speed) const;

 private:
  Eigen::VectorXd speeds_;                ///< [rad/s], uniform
  std::vector<Eigen::MatrixXd> squares_;  ///< [Hz^2], sign kept; one a nodal diameter, speeds x families
};

}  // namespace tiprub
