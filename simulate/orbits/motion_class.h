// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <deque>

#include "simulate/motion/motion.h"

namespace tiprub::simulate {

/// The engine orders 0 .. `orders` of the samples of one revolution, which are the resolved part of a motion. Chatter
/// of a tip above the highest resolved frequency does not affect them.
class EngineOrderBand {
 public:
  /// `samples` is their number in a revolution. `orders` is limited to what the samples resolve.
  EngineOrderBand(int samples, double orders);

  int orders() const { return orders_; }
  /// The Fourier coefficients, channels x (2 orders + 1), the mean first, of a revolution of samples. `revolution`
  /// holds sample after sample, channel by channel, each value the mean over the interval of its sample. The sum of
  /// the squared coefficients is that of the motion in the band over the samples: the attenuation by the means is
  /// corrected. If all orders belong to the band, the samples themselves are returned.
  Eigen::MatrixXd coefficients(const Eigen::VectorXd& revolution) const;

 private:
  int orders_;
  int samples_;
  Eigen::MatrixXd waves_;  ///< samples x (2 orders + 1); empty if the band holds all orders
};

/// The class of a motion, read from its last revolutions.
struct MotionReading {
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;        ///< of a periodic (1) or subharmonic motion; a beat is 1/lobes of a revolution
  double off_beat_energy = 0;  ///< [1] share of the mean square that is at no multiple of lobes x Omega
};

/// The limits between classes, as shares of the mean square in the band without the mean.
struct ClassLimits {
  static constexpr double off_lines = 1e-4;   ///< largest share beside the lines of a period
  static constexpr double off_jitter = 1e-3;  ///< the same of a scheme that jitters
  static constexpr double few_lines = 0.1;    ///< a motion is modulated if this share of all lines holds ...
  static constexpr double most_energy = 0.9;  ///< ... this share of what is off the beat
  static constexpr int longest_period = 12;   ///< beats
};

/// Classifies a motion by the spectrum of its last R whole revolutions, whose lines are 1/R of an engine order apart;
/// Hann's window is applied if the motion has not settled. The period is the smallest number k of beats for which
/// less than a share `off_lines` of the mean square lies beside the lines of k beats. A motion without period is
/// modulated if a tenth of the lines holds nine tenths of what is off the beat, and otherwise broadband. If it has no
/// period and its change still decays, it is not settled, because its lines are those of a transient. `revolutions`
/// are in order, each as EngineOrderBand takes them, with `channels` values for a sample; `orders` is the highest
/// engine order of the band.
enum class Change { settled, decays, stands };
MotionReading read_motion(const std::deque<Eigen::VectorXd>& revolutions, Eigen::Index channels, double orders,
                          int lobes, Change change, double off_lines = ClassLimits::off_lines);

}  // namespace tiprub::simulate
