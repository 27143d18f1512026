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
  int period_revolutions = 0;  ///< period of the settled motion; 0 if it has not settled
  double change = 0;           ///< [1] relative change over the period (over one revolution if not settled)
  double rate = 0;             ///< [1] factor of that change per revolution

  bool settled() const { return period_revolutions > 0; }
};

/// Judges after each revolution whether a motion has settled, and with which period. The change over L revolutions,
///   epsilon_L = |z(R) - z(R - L)|/|z(R)|,   L = 1 .. 6,
/// with the motion z(R) of revolution R, must be small and must decay. If rho is its factor per revolution, fitted to
/// the last changes, the remaining distance from the settled motion is epsilon_L rho^L/(1 - rho^L). A threshold on
/// the change alone does not suffice, because near critical speeds the change decreases and grows again.
///
/// The period is the smallest L that meets the tolerance. Periods beyond 1 are accepted only while epsilon_1 does not
/// decay: a motion that approaches a periodic one with alternating signs meets the tolerance with L = 2 first.
class SteadyState {
 public:
  static constexpr int longest_period = 6;

  /// `tolerance` [1] is the allowed distance from the settled motion. Motions with a norm below `quiet_norm` count as
  /// rest.
  SteadyState(double tolerance, double quiet_norm) : tolerance_(tolerance), quiet_norm_(quiet_norm) {}

  /// Adds the samples of one revolution.
  void add(Eigen::VectorXd revolution);
  SettlingState judge() const;
  /// Whether the change per revolution clearly decreases: the slope of a line through the logarithms of the last
  /// changes is negative by more than twice its uncertainty.
  bool decays() const;
  /// Whether the change per revolution neither decreases nor increases clearly over the last `count` revolutions: the
  /// slope of a line through its logarithms is within twice its uncertainty, or it is positive, and the change does
  /// not double. The uncertainty is too small for the rise of a slow modulation, because its residuals are not
  /// independent.
  bool stands(int count) const;

 private:
  double tolerance_;
  double quiet_norm_;
  std::deque<Eigen::VectorXd> last_;  ///< newest first
  std::array<std::vector<double>, longest_period> changes_;
};

/// What is known of the motion with which a march starts.
enum class StartMotion {
  unknown,
  wanders,  ///< it has been marched for long and did not settle: no transient has to pass
};

/// Judges whether the march of one speed has settled, by the band of resolved frequencies only, and stops a motion
/// that grows without bound.
class Settling {
 public:
  /// `min_revolutions` is the number of revolutions before settling is judged.
  Settling(const Scene& scene, TimeMarch& march, int min_revolutions, StartMotion start);

  /// Adds a marched revolution. Raises NoMotion if the motion has grown without bound.
  void add(Eigen::VectorXd motion);
  /// Whether the motion has settled; false before the smallest allowed number of revolutions.
  bool settled() const;
  /// Whether further marching is useless: the motion has not settled after four times the smallest allowed number of
  /// revolutions (at least 60; twice and 30 if it wandered before), and its change per revolution neither decreases
  /// nor increases. An increasing change shows that the motion leaves an orbit, and it will then approach
  /// another one.
  bool wanders() const;
  SettlingState state() const { return orbit_ ? *orbit_ : state_.judge(); }
  /// The class of the motion, from one period of a settled motion or, otherwise, from at most the last 24
  /// revolutions.
  MotionReading reading() const;
  int revolutions() const { return revolutions_; }
  /// The highest engine order of the band.
  int highest_order() const { return band_.orders(); }

  /// Marches and adds one revolution.
  void advance();
  /// Declares the motion settled. The march must have been put onto an orbit that repeats after `period_revolutions`,
  /// and whose disturbances change by the factor `rate` per revolution.
  void stand_on_orbit(int period_revolutions, double rate);
  bool stands_on_orbit() const { return orbit_.has_value(); }
  /// `drift` [1] is the relative distance of the march from the orbit after the recording.
  void confirm_orbit(double drift);
  /// Withdraws the orbit. The revolutions that are added from now on decide again.
  void leave_orbit();

 private:
  bool casing_has_grown() const;

  const Scene& scene_;
  TimeMarch& march_;
  EngineOrderBand band_;
  SteadyState state_;
  std::optional<SettlingState> orbit_;
  std::deque<Eigen::VectorXd> last_;  ///< the last revolutions, the newest last
  double bound_;                      ///< [m]
  int min_revolutions_;
  StartMotion start_;
  int revolutions_ = 0;
};

}  // namespace tiprub::simulate
