// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <deque>
#include <optional>

#include "simulate/march/time_march.h"
#include "simulate/orbits/motion_class.h"
#include "simulate/orbits/steady_state.h"
#include "simulate/scene/scene.h"

namespace tiprub {

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

}  // namespace tiprub
