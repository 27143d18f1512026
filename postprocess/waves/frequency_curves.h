// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "simulate/response/response.h"

namespace tiprub {

/// Natural frequencies of the model over speed, by nodal diameter and family (0 is the lowest), between those of the
/// response's table.
///
/// The squares of the frequencies are nearly polynomials of Omega^2 (eq. 11), so they are read through the cubic (in
/// Omega^2) of the four nearest speeds: exact where K2 = 0 and shapes don't change with speed.
class FrequencyCurves {
 public:
  static constexpr int stencil = 4;  ///< speeds that the table must have at least, ascending

  explicit FrequencyCurves(const FrequencyTable& table);

  int nodal_diameters() const { return static_cast<int>(squares_.size()); }
  int families(int nodal_diameter) const { return static_cast<int>(squares_[nodal_diameter].cols()); }
  /// [Hz] at a speed [rad/s]; negative where the rotor is unstable.
  double frequency(int nodal_diameter, int family, double speed) const;
  /// The family whose frequency at this speed is nearest to one [Hz].
  int nearest_family(int nodal_diameter, double frequency, double speed) const;

 private:
  Eigen::VectorXd speeds_;                ///< [rad/s], ascending
  std::vector<Eigen::MatrixXd> squares_;  ///< [Hz^2], sign kept; one a nodal diameter, speeds x families
};

}  // namespace tiprub
