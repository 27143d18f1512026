// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>

#include "simulate/march/time_march.h"
#include "simulate/motion/motion.h"
#include "simulate/orbits/excluded_growth.h"
#include "simulate/periodic/marched_map.h"
#include "simulate/periodic/newton.h"
#include "simulate/scene/scene.h"

namespace tiprub::simulate {

/// Whether the steady motion of a scene can be sought as a fixed point of the symmetric map: the contact law has no
/// memory, and only the nodal diameters that symmetry needs are marched.
bool has_symmetric_map(const Scene& scene);

/// The growth of the nodal diameters that symmetry leaves out, along a march that has settled with this period. It is
/// the largest multiplier of the linearised symmetric map, found within `revolutions`. The march stays unchanged.
/// Raises NoMotion if the motion cannot be followed.
Growth excluded_growth_along(TimeMarch& settled, int period_revolutions, int revolutions);

/// What an orbit is sought for.
enum class OrbitUse {
  motion,
  amplitude,  ///< for scans: only of one map, because longer searches cost more than they save there
};

/// Finds the steady motion that a march from rest approaches, without marching all the way. Newton's method looks for
/// a fixed point of the symmetric map, first with a coarse step, then from the orbit found with finer steps. If no
/// fixed point attracts, it looks for one of the power of the map after which the march nearly returns to its state.
/// Repelling orbits are recognised by their multiplier and rejected.
class OrbitSearch {
 public:
  /// Keeps a reference to the scene.
  OrbitSearch(const Scene& scene, OrbitUse wanted) : scene_(scene), wanted_(wanted) {}

  /// Puts a march onto a stable orbit, and returns whether there is one. If there is none, ends the search and leaves
  /// the march at a state that it has come to by itself.
  ///
  /// The first march, from rest with a coarse step, is led by `revolution` until the distortion of the casing has
  /// grown, and for some revolutions more until an orbit is found nearby. Later ones continue from the last orbit and
  /// jump to that of their own step. Raises what the first march raises.
  bool reach(TimeMarch& march, const std::function<void()>& revolution);
  /// [1] The distance of the march from its orbit after whole revolutions, relative to the orbit.
  double drift(TimeMarch& march) const;
  /// Whether the orbit attracts with the step of this march: an orbit that attracts with a coarse step may repel with
  /// a finer one. Also computes excluded(). False if the search has ended.
  bool stands(TimeMarch& march);
  /// Ends the search, because the march did not confirm the last orbit or no orbit was found.
  void give_up() { report_.outcome = OrbitReport::Outcome::marched; }

  /// Whether an orbit has been found with any step.
  bool has_found() const { return orbit_.state.size() > 0; }
  const OrbitReport& report() const { return report_; }
  /// The period of the orbit.
  int period_revolutions() const { return revolutions_of(report_.maps); }
  /// The growth of the nodal diameters that symmetry leaves out along the orbit; empty if none is left out or there
  /// is no stable orbit.
  const std::optional<Growth>& excluded() const { return excluded_; }

 private:
  /// The march keeps its state if there is no orbit.
  bool jump(TimeMarch& march);
  bool has_given_up() const { return report_.outcome == OrbitReport::Outcome::marched; }
  /// The whole revolutions after which a number of maps comes back to the start.
  int revolutions_of(int maps) const;
  bool may_repeat_after(int maps) const;
  int recurrence(const TimeMarch& from) const;
  bool look_along(TimeMarch& coarse, const std::function<void()>& revolution);
  bool find(TimeMarch& march);
  bool repels(MarchedMap& map, const NewtonResult& orbit);
  bool attracts(MarchedMap& map, const NewtonResult& orbit, double tolerance);

  const Scene& scene_;
  OrbitUse wanted_;
  NewtonResult orbit_;         ///< the last orbit found
  Eigen::VectorXd repelling_;  ///< the state of an orbit that was rejected; empty if there is none
  OrbitReport report_;
  std::optional<Growth> excluded_;
};

}  // namespace tiprub::simulate
