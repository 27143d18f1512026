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

namespace tiprub::simulate {

/// Whether the steady motion of a scene can be sought as a fixed point of the symmetric map: the contact law has no
/// memory, and only the nodal diameters that symmetry needs are marched.
bool has_symmetric_map(const Scene& scene);

/// The growth of the nodal diameters that symmetry leaves out, along a march that has settled with this period: the
/// largest multiplier of the linearised symmetric map, at most `revolutions` long. Leaves the march unchanged. Raises
/// NoMotion if the motion can't be followed.
Growth excluded_growth_along(TimeMarch& settled, int period_revolutions, int revolutions);

/// Finds the steady motion that a march from rest approaches, without marching all the way. Newton's method seeks a
/// fixed point of the symmetric map, with a coarse step first and then with finer steps from the orbit before. If no
/// fixed point attracts, it seeks one of the power of the map after which the march nearly returns. Orbits that repel
/// are recognised by their multiplier and rejected.
class OrbitSearch {
 public:
  /// Refers to the scene.
  explicit OrbitSearch(const Scene& scene) : scene_(scene) {}

  /// Marches from rest with a coarse step until the casing has grown, and some revolutions further. Then puts the
  /// march onto a stable orbit nearby; if there is none, tries again after more revolutions. Returns whether one was
  /// found.
  bool approach(TimeMarch& coarse);
  /// Puts a march that continues from the last orbit onto its own orbit. If there is none, leaves the march
  /// unchanged, to the bit, and gives up.
  bool jump(TimeMarch& march);
  /// [1] The distance of the march from its orbit after whole revolutions, relative to the orbit.
  double drift(TimeMarch& march) const;
  /// Whether the orbit of the march attracts with the step of this march, since an orbit that attracts with a coarse
  /// step may repel with a finer one. Also computes excluded(). False if the search has given up.
  bool stands(TimeMarch& march);
  /// Ends the search: the march did not confirm the last orbit, or none was found.
  void give_up();

  const OrbitReport& report() const { return report_; }
  /// The period of the orbit.
  int period_revolutions() const;
  /// The growth of the nodal diameters that symmetry leaves out along the orbit; empty if none is left out or there
  /// is no stable orbit.
  const std::optional<Growth>& excluded() const { return excluded_; }

 private:
  bool has_given_up() const { return report_.outcome == OrbitReport::Outcome::marched; }
  int recurrence(TimeMarch& march) const;
  /// Marches on from rest until jump() finds an orbit. Raises what the march raises.
  bool look_along(TimeMarch& coarse);
  bool find(TimeMarch& march);
  bool attracts(MarchedMap& map, const NewtonResult& orbit, double tolerance);
  void follow_excluded(const TimeMarch& march, const NewtonResult& orbit);

  const Scene& scene_;
  NewtonResult orbit_;  ///< the last orbit found
  OrbitReport report_;
  std::optional<Growth> excluded_;
};

}  // namespace tiprub::simulate
