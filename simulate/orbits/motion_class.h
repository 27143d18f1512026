// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <deque>

#include "simulate/motion/motion.h"

namespace tiprub {

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
