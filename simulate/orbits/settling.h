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

/// The march of one speed on its way to the settled motion: revolutions, their bound, and the judgement, which looks
/// at the band of resolved frequencies only.
class Settling {
 public:
  /// `min_revolutions`: before settling is judged.
  Settling(const Scene& scene, TimeMarch& march, int min_revolutions);

  /// One revolution that was marched. Raises NoMotion if the motion has grown without bound.
  void add(Eigen::VectorXd motion);
  /// Whether the motion has settled after the fewest revolutions allowed.
  bool settled() const;
  SettlingState state() const { return orbit_ ? *orbit_ : state_.judge(); }
  /// What moves, of the last revolutions: of a settled motion one period, else up to 24.
  MotionReading reading() const;
  int revolutions() const { return revolutions_; }
  /// The highest engine order of the band.
  int highest_order() const { return band_.orders(); }

  /// Marches one revolution. Raises what add() raises.
  void advance();
  /// The march stands on an orbit that is known to repeat itself after so many revolutions, what disturbs it changing
  /// by the factor `rate` a revolution: settled, whatever came before.
  void stand_on_orbit(int period_revolutions, double rate);
  bool stands_on_orbit() const { return orbit_.has_value(); }
  /// `drift` [1]: by how much a revolution has moved it.
  void confirm_orbit(double drift);
  /// It doesn't after all: settled is what add() says, from here on.
  void leave_orbit();

 private:
  const Scene& scene_;
  TimeMarch& march_;
  EngineOrderBand band_;
  SteadyState state_;
  std::optional<SettlingState> orbit_;
  std::deque<Eigen::VectorXd> last_;  ///< revolutions as they were marched, the newest last
  double bound_;                      ///< [m]
  int min_revolutions_;
  int revolutions_ = 0;
};

}  // namespace tiprub
