// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "simulate/march/time_march.h"
#include "simulate/orbits/steady_state.h"
#include "simulate/orbits/symmetric_map.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// The march of one speed on its way to the settled motion: revolutions, their bound, and the judgement.
class Settling {
 public:
  Settling(const Scene& scene, TimeMarch& march);

  /// One revolution that was marched. Raises RunError if the motion has grown without bound.
  void add(Eigen::VectorXd motion);
  /// Whether the motion has settled after min_revolutions.
  bool settled() const;
  SettlingState state() const { return state_.judge(); }
  int revolutions() const { return revolutions_; }

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
  SteadyState state_;
  double bound_;  ///< [m]
  int revolutions_ = 0;
  AccelerationReport acceleration_;
};

}  // namespace tiprub
