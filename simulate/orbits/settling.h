// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <deque>
#include <optional>
#include <vector>

#include "simulate/march/time_march.h"
#include "simulate/orbits/motion_class.h"
#include "simulate/scene/scene.h"

namespace tiprub::simulate {

/// Whether a motion has settled, and how fast it still changes.
struct SettlingState {
  enum class Settled { yes, no };

  Settled settled = Settled::no;
  int period_revolutions = 0;  ///< period of the settled motion; 0 if it has not settled
  double change = 0;           ///< [1] relative change over the period (over one revolution if not settled)
  double rate = 0;             ///< [1] factor of that change per revolution
};

/// Judges from revolution to revolution whether a motion has settled, and with which period. The change over L
/// revolutions,
///   delta_L = |x(r) - x(r - L)| / |x(r)|,  L = 1 .. 6,
/// must be small and must decay. With its factor rho per revolution, fitted to the last changes, the remaining
/// distance from the settled motion is delta_L rho^L / (1 - rho^L). A threshold on the change itself would not do:
/// near critical speeds the change falls and grows again. The period is the smallest L that meets the tolerance.
/// Periods beyond 1 are accepted only while delta_1 does not decay, because a motion that approaches a periodic one
/// with alternating signs meets the tolerance with L = 2 first.
class SteadyState {
 public:
  static constexpr int longest_period = 6;

  /// `tolerance` [1]: the allowed distance from the settled motion. Motions of a norm below `quiet_norm` count as
  /// rest.
  SteadyState(double tolerance, double quiet_norm) : tolerance_(tolerance), quiet_norm_(quiet_norm) {}

  /// Adds the samples of one whole revolution.
  void add(Eigen::VectorXd revolution);
  SettlingState judge() const;
  /// Whether the change from revolution to revolution clearly falls: the slope of a line through the logarithms of
  /// the last changes is negative by more than twice its uncertainty.
  bool decays() const;
  /// Whether the change from revolution to revolution neither falls nor rises clearly over the last `count` ones: the
  /// slope of that line is within twice its uncertainty.
  bool stands(int count) const;

 private:
  double tolerance_;
  double quiet_norm_;
  std::deque<Eigen::VectorXd> last_;  ///< newest first
  std::array<std::vector<double>, longest_period> changes_;
};

/// Judges whether the march of one speed has settled, by the band of resolved frequencies only, and stops a motion
/// that grows without bound.
class Settling {
 public:
  /// `min_revolutions` are marched before settling is judged.
  Settling(const Scene& scene, TimeMarch& march, int min_revolutions);

  /// Adds a marched revolution. Raises NoMotion if the motion has grown without bound.
  void add(Eigen::VectorXd motion);
  /// Whether the motion has settled; never before the smallest allowed number of revolutions.
  bool settled() const;
  /// Whether marching on is of no use: the motion has not settled after seven times the smallest allowed number of
  /// revolutions (at least 70), and its change from revolution to revolution stands. A change that grows tells of a
  /// motion that leaves an orbit, and will come to another.
  bool wanders() const;
  SettlingState state() const { return orbit_ ? *orbit_ : state_.judge(); }
  /// The class of the motion, from one period of a settled motion, or else from up to 24 last revolutions.
  MotionReading reading() const;
  int revolutions() const { return revolutions_; }
  /// The highest engine order of the band.
  int highest_order() const { return band_.orders(); }

  /// Marches and adds one revolution.
  void advance();
  /// Declares the motion settled: the march has been put onto an orbit that repeats itself after
  /// `period_revolutions`, and whose disturbances change by the factor `rate` per revolution.
  void stand_on_orbit(int period_revolutions, double rate);
  bool stands_on_orbit() const { return orbit_.has_value(); }
  /// `drift` [1]: the relative distance of the march from the orbit after the recording.
  void confirm_orbit(double drift);
  /// Withdraws the orbit. From here on the revolutions added decide again.
  void leave_orbit();

 private:
  const Scene& scene_;
  TimeMarch& march_;
  EngineOrderBand band_;
  SteadyState state_;
  std::optional<SettlingState> orbit_;
  std::deque<Eigen::VectorXd> last_;  ///< the last revolutions, the newest last
  double bound_;                      ///< [m]
  int min_revolutions_;
  int revolutions_ = 0;
};

}  // namespace tiprub::simulate
