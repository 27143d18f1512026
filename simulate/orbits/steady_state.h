// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <deque>
#include <vector>

namespace tiprub {

/// What the motion looks like after some revolutions.
struct SettlingState {
  enum class Settled { yes, no };

  Settled settled = Settled::no;
  int period_revolutions = 0;  ///< after which it repeats itself; 0 if it has not settled
  double change = 0;           ///< [1] norm of the change over the period (one revolution if not settled)
  double rate = 0;             ///< [1] factor of that change per revolution
};

/// Judges from revolution to revolution whether a motion has settled, and to what. The change over L revolutions,
///   delta_L = |x(r) - x(r - L)| / |x(r)|,  L = 1 .. 6,
/// must be small and must decay: with the factor rho per revolution, fitted to the last changes, what is still to
/// come is delta_L rho^L / (1 - rho^L). A threshold on the change alone lies: near critical speeds it falls, and
/// grows again. The smallest L that holds is the period; beyond 1 only while delta_1 stands: a motion whose
/// disturbances alternate on their way to a periodic one meets delta_2 first.
class SteadyState {
 public:
  static constexpr int longest_period = 6;

  /// `tolerance` [1]: allowed distance from the settled motion. `quiet_norm`: motions below count as no motion.
  SteadyState(double tolerance, double quiet_norm) : tolerance_(tolerance), quiet_norm_(quiet_norm) {}

  /// The samples of one whole revolution, always of the same length.
  void add(Eigen::VectorXd revolution);
  SettlingState judge() const;
  /// Whether the change from revolution to revolution has clearly fallen over the last ones: by a line through its
  /// logarithms, with twice the line's uncertainty.
  bool decays() const;

 private:
  double decay_rate(const std::vector<double>& changes) const;

  double tolerance_;
  double quiet_norm_;
  std::deque<Eigen::VectorXd> last_;  ///< newest first
  std::array<std::vector<double>, longest_period> changes_;
};

}  // namespace tiprub
