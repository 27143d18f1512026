// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <deque>

#include "simulate/march/time_march.h"
#include "simulate/orbits/engine_order_band.h"
#include "simulate/orbits/motion_class.h"
#include "simulate/orbits/steady_state.h"
#include "simulate/orbits/symmetric_map.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"

namespace tiprub {

struct SettlingPlan {
  int min_revolutions = 0;  ///< before settling is judged
  Acceleration acceleration = Acceleration::none;
};

/// The march of one speed on its way to the settled motion: revolutions, their bound, and the judgement, which looks
/// at the band of resolved frequencies only.
class Settling {
 public:
  Settling(const Scene& scene, TimeMarch& march, const SettlingPlan& plan);

  /// One revolution that was marched. Raises RunError if the motion has grown without bound.
  void add(Eigen::VectorXd motion);
  /// Whether the motion has settled after the fewest revolutions allowed.
  bool settled() const;
  SettlingState state() const { return state_.judge(); }
  /// What moves, of the last revolutions: of a settled motion one period, else up to 24.
  MotionReading reading() const;
  int revolutions() const { return revolutions_; }
  /// The highest engine order of the band.
  int highest_order() const { return band_.orders(); }

  /// Marches one revolution, or, once and after the casing has grown, jumps to the settled motion: Anderson's
  /// acceleration of the symmetric map (acceleration = "anderson"). The jump counts only if the motion is then judged
  /// steady by marching on from beside it (14 .. 20 revolutions), so that an unstable one is not taken; if not, the
  /// march goes on from where it was, to the bit, and all that is lost is time. Raises what add() raises.
  void advance();
  /// What became of the jump; `revolutions` counts those of the map, and of a confirmation that failed.
  const AccelerationReport& acceleration() const { return acceleration_; }

 private:
  bool should_jump() const;
  void jump();
  /// Whether the march is put on a fixed point of the symmetric map.
  bool find_orbit();
  void put_beside(const Eigen::VectorXd& orbit, const Eigen::VectorXd& start, SymmetricMap& map) const;
  /// Whether the march is on a steady motion; then its judgement takes the place of the former one.
  bool confirm();

  const Scene& scene_;
  TimeMarch& march_;
  EngineOrderBand band_;
  SteadyState state_;
  std::deque<Eigen::VectorXd> last_;  ///< revolutions as they were marched, the newest last
  double bound_;                      ///< [m]
  SettlingPlan plan_;
  int revolutions_ = 0;
  AccelerationReport acceleration_;
};

}  // namespace tiprub
