// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <memory>
#include <optional>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"
#include "simulate/orbits/excluded_growth.h"
#include "simulate/periodic/marched_map.h"
#include "simulate/periodic/newton.h"
#include "simulate/scene/scene.h"

namespace tiprub {

/// Whether the steady motion of a scene can be looked for as a fixed point of the symmetric map: its law of contact
/// has no memory, and all that moves is what symmetry needs.
bool has_symmetric_map(const Scene& scene);

/// Looks for the steady motion that a march from rest is on its way to, instead of marching there: with a coarse step
/// first, then with one step size after another from the orbit before, by Newton's method for a fixed point of the
/// symmetric map; where there is none that attracts, of the power of it after which the march nearly comes back.
/// Orbits that repel are told from those that don't by their multiplier, and not taken. What was learnt with one step
/// size makes the next one cheap.
class OrbitSearch {
 public:
  /// The scene is referred to.
  explicit OrbitSearch(const Scene& scene) : scene_(scene) {}

  /// From rest with a coarse step: marches until the casing has grown and some revolutions more, then puts the march
  /// on a stable orbit near to it; if there is none, after ever more revolutions. Whether it has found one.
  bool approach(TimeMarch& coarse);
  /// Puts a march that goes on from the orbit before onto its own; else leaves it as it is, to the bit, and gives up.
  bool jump(TimeMarch& march);
  /// [1] how far the march, whole revolutions later, has moved from its orbit, of the orbit's size.
  double drift(TimeMarch& march) const;
  /// Whether the orbit that the march is on attracts with this march's step: what does so with a coarse one may
  /// repel. Looks also at what symmetry leaves out. No, if the search has given up since it put a march on an orbit.
  bool stands(TimeMarch& march);
  /// The march did not confirm the last orbit, or nothing was found.
  void give_up();

  const OrbitReport& report() const { return report_; }
  /// After which the orbit repeats itself.
  int period_revolutions() const;
  /// How disturbances grow that symmetry leaves out, along the orbit that stands; none if there are none, or none
  /// stands.
  const std::optional<Growth>& excluded() const { return excluded_; }

 private:
  bool has_given_up() const { return report_.outcome == OrbitReport::Outcome::marched; }
  int recurrence(TimeMarch& march) const;
  /// Marches on from rest until jump() finds an orbit. Raises what the march raises.
  bool look_along(TimeMarch& coarse);
  bool find(TimeMarch& march);
  bool attracts(MarchedMap& map, const NewtonResult& orbit);
  void follow_excluded(const TimeMarch& march, const NewtonResult& orbit);

  const Scene& scene_;
  std::shared_ptr<RecycledGmres> solver_ = std::make_shared<RecycledGmres>();
  NewtonResult orbit_;  ///< the last one found
  OrbitReport report_;
  std::optional<Growth> excluded_;
};

}  // namespace tiprub
