// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <optional>

#include "simulate/march/rotor_at_speed.h"
#include "simulate/march/time_march.h"
#include "simulate/orbits/excluded_growth.h"
#include "simulate/periodic/marched_map.h"
#include "simulate/periodic/newton.h"
#include "simulate/response/response.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// Whether the steady motion of a scene can be looked for as a fixed point of the symmetric map: its law of contact
/// has no memory, and all that moves is what symmetry needs.
bool has_symmetric_map(const Scene& scene);

/// Looks for the steady motion that a march is on its way to, instead of marching there, with one step size after
/// another: Newton's method for a fixed point of the symmetric map. Orbits that repel are told from those that don't
/// by their multiplier, and not taken. What was learnt with one step size makes the next one cheap.
class OrbitSearch {
 public:
  /// Both are referred to. Raises nothing.
  OrbitSearch(const Scene& scene, const RotorAtSpeed& rotor) : scene_(scene), rotor_(rotor) {}

  /// Whether it is time to look again: some revolutions after the casing has grown, and then ever more rarely; at
  /// once where a march goes on from another one.
  bool is_due(const TimeMarch& march) const;
  /// Puts the march on a stable orbit near to it; else leaves it as it is, to the bit.
  bool jump(TimeMarch& march);
  /// [1] how far the march, whole revolutions later, has moved from its orbit, of the orbit's size.
  double drift(TimeMarch& march) const;
  /// The march did not confirm the last orbit: from now on nothing is due.
  void give_up();

  const OrbitReport& report() const { return report_; }
  /// How disturbances grow that symmetry leaves out, along the first orbit found; none if there are none, or none
  /// was found.
  const std::optional<Growth>& excluded() const { return excluded_; }

 private:
  bool find(TimeMarch& march);
  bool attracts(MarchedMap& map, const NewtonResult& orbit);
  void follow_excluded(const TimeMarch& march, const NewtonResult& orbit);

  const Scene& scene_;
  const RotorAtSpeed& rotor_;
  std::shared_ptr<RecycledGmres> solver_ = std::make_shared<RecycledGmres>();
  Eigen::VectorXd orbit_;
  int tries_ = 0;
  double next_revolution_ = 0;  ///< after which the next try is due
  bool has_given_up_ = false;
  OrbitReport report_;
  std::optional<Growth> excluded_;
};

}  // namespace tiprub
