// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "postprocess/waves/aliasing.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// Natural frequencies of the model at any speed, by nodal diameter and family (0 is the lowest), interpolated in the
/// response's table.
///
/// The squares of the frequencies are nearly polynomials of Omega^2 (eq. 11). They are therefore interpolated by
/// the cubic in Omega^2 through the four nearest speeds, which is exact if K2 = 0 and the shapes do not change
/// with speed.
class FrequencyCurves {
 public:
  static constexpr int stencil = 4;  ///< the least number of speeds in the table, which ascend

  explicit FrequencyCurves(const FrequencyTable& table);

  int nodal_diameters() const { return static_cast<int>(squares_.size()); }
  int families(int nodal_diameter) const { return static_cast<int>(squares_[nodal_diameter].cols()); }
  /// [Hz] at a speed [rad/s]; negative where the rotor is unstable.
  double frequency(int nodal_diameter, int family, double speed) const;
  /// The family whose frequency at this speed is nearest to one [Hz].
  int nearest_family(int nodal_diameter, double frequency, double speed) const;
  /// [1] of critical, at the nearest speed of the table; nothing if the response does not state it.
  std::optional<double> damping_ratio(int nodal_diameter, int family, double speed) const;
  /// [1] The smallest of all modes.
  std::optional<double> smallest_damping_ratio() const;

 private:
  Eigen::VectorXd speeds_;                ///< [rad/s], ascending
  std::vector<Eigen::MatrixXd> squares_;  ///< [Hz^2], with their sign, by nodal diameter; speeds x families
  std::vector<Eigen::MatrixXd> damping_;  ///< [1] of the same modes, or none
};

/// A travelling wave of the response, and the natural mode whose frequency is nearest.
struct WaveLabel {
  double engine_order = 0;        ///< a fraction for a subharmonic
  int signed_nodal_diameter = 0;  ///< see aliasing.h
  double amplitude = 0;           ///< [m]
  WaveDirection direction = WaveDirection::standing;
  int family = 0;                ///< with the nearest frequency at this nodal diameter and speed; 0 is the lowest
  double natural_frequency = 0;  ///< [Hz] of that family
  double detuning = 0;           ///< [1] (engine order Omega/(2 pi) - natural frequency) / natural frequency
  /// [rad/s] Half-width of the mode's resonance over speed: its damping ratio times its frequency over the engine
  /// order. Nothing if the response does not state the damping.
  std::optional<double> half_width{};
};

/// Fills in direction, family and detuning of a wave at a speed [rad/s].
WaveLabel label_wave(const FrequencyCurves& curves, int sector_count, double speed, double engine_order,
                     int signed_nodal_diameter, double amplitude);

/// "6", or "5.5" for a subharmonic.
std::string engine_order_text(double engine_order);
/// "EO 6", "EO 5.5".
std::string engine_order_name(double engine_order);
/// "EO 6 ND -4", "EO 4 ND +4".
std::string wave_name(double engine_order, int signed_nodal_diameter);
std::string wave_name(const WaveLabel& wave);

}  // namespace tiprub::postprocess
