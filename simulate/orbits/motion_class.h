// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <deque>

#include "simulate/motion/motion.h"

namespace tiprub {

/// Engine orders 0 .. `orders` of the samples of one revolution: what of a motion counts as the wheel's. A tip that
/// chatters above the highest resolved frequency leaves them alone.
class EngineOrderBand {
 public:
  /// `samples` a revolution; all orders that they resolve, if `orders` asks for more.
  EngineOrderBand(int samples, double orders);

  int orders() const { return orders_; }
  /// Of values by sample, each a mean over the sample's interval, channel by channel within a sample: the Fourier
  /// coefficients, channels x (2 orders + 1), the mean first. The sum of their squares is that of the band's motion
  /// over the samples (what the means took off the higher orders is put back). If all orders count, the values
  /// themselves.
  Eigen::MatrixXd coefficients(const Eigen::VectorXd& revolution) const;

 private:
  int orders_;
  int samples_;
  Eigen::MatrixXd waves_;  ///< samples x (2 orders + 1); empty if all orders count
};

/// What moves, of the last revolutions of a motion.
struct MotionReading {
  MotionClass motion = MotionClass::not_settled;
  int period_beats = 0;        ///< of a periodic (1) or subharmonic motion; a beat is 1/lobes of a revolution
  double off_beat_energy = 0;  ///< [1] share of the mean square that is at no multiple of lobes x Omega
};

/// How a class is told from a motion's lines; all of the mean square of the moving part in the band.
struct ClassLimits {
  static constexpr double off_lines = 1e-4;   ///< share beside the lines of a period, that still is one
  static constexpr double few_lines = 0.1;    ///< share of all lines that holds ...
  static constexpr double most_energy = 0.9;  ///< ... this share off the beat, of a modulated motion
  static constexpr int longest_period = 12;   ///< beats
};

/// Classifies by the spectrum of whole revolutions (1/R of an engine order between lines, R revolutions, Hann's
/// window if the motion doesn't repeat within them): the shortest period of k beats beside whose lines less than
/// `off_lines` of the mean square is left; without one, modulated if a tenth of the lines holds nine tenths of what
/// is off the beat, else broadband. A motion without period whose change still decays (`decays`) is not settled: its
/// lines are those of a transient.
/// `revolutions`: the last ones, in order, each as EngineOrderBand takes them, `channels` values a sample; `orders`:
/// the highest engine order that counts.
enum class Change { settled, decays, stands };
MotionReading read_motion(const std::deque<Eigen::VectorXd>& revolutions, Eigen::Index channels, double orders,
                          int lobes, Change change);

}  // namespace tiprub
