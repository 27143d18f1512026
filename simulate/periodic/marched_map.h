// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <memory>
#include <vector>

#include "simulate/march/march_state.h"
#include "simulate/march/time_march.h"
#include "simulate/orbits/excluded_growth.h"
#include "simulate/periodic/periodic_map.h"

namespace tiprub::simulate {

/// The march over 1/lcm(N, lobes) of a revolution, followed by a shift of sectors. Its fixed points are the orbits
/// that travel with the casing,
///   u_j(t + T/lcm(N, lobes)) = u_{j+s}(t).
/// Orbits that do so only after k such intervals are fixed points of its k-th power. The map costs lcm(N, lobes)
/// times less than a revolution. For nodal diameter n the shift is the phase e^{-i n s alpha}. The number of steps in
/// a revolution must be a multiple of lcm(N, lobes), and the distortion of the casing must be fully grown. The
/// contact law must have no memory, so that the modes at two instants are the whole state.
class SymmetricMap {
 public:
  explicit SymmetricMap(TimeMarch& march, int power = 1);

  /// The modes in the order of EnergyState; of a standing wave only the real parts.
  Eigen::VectorXd state() const { return energy_state_.of(march_); }
  void put(const Eigen::VectorXd& state) { energy_state_.put(state, march_); }
  /// The state after the shift of sectors. It is the image of the map once the march has done steps() steps.
  Eigen::VectorXd image() const { return energy_state_.of(march_, phases_); }

  const StateLayout& layout() const { return energy_state_.layout(); }
  /// The number of steps of the march in one map.
  int steps() const { return steps_; }
  double maps_per_revolution() const { return static_cast<double>(march_.steps_per_revolution()) / steps_; }

 private:
  TimeMarch& march_;
  int steps_;
  EnergyState energy_state_;
  std::vector<std::complex<double>> phases_;  ///< factors of the shift of sectors, by wave
};

/// The disturbances of a wheel that are followed along an orbit.
enum class Disturbance {
  symmetric,  ///< those of the nodal diameters of the orbit
  excluded,   ///< those of the nodal diameters that the orbit leaves out; to first order the two kinds do not couple
};

/// The march linearised along the contact pattern of an orbit. Nodes that the orbit closes stay in place, and no
/// force acts on the others. The instants of impacts within steps and the directions of the forces change with the
/// disturbance:
///   friction, with the path s over the casing in a step, its change ds and the unit vector e across s:
///     the drag changes by mu lambda (e . ds) e/|s|;
///   gap of second order, with the change dy of the coordinates at t_q: the slopes G change by dG = (d^2 s/dy^2) dy,
///     the forces on y by dG^T lambda, and the gaps by dG y_lambda, where y_lambda is the reduction of y by lambda.
/// A product costs as much as the march, without the search for the pattern.
class TangentMarch {
 public:
  /// `orbit` is the march of the orbit and must outlive this object. Excluded disturbances are those of
  /// RotorAtSpeed::others, on all N sectors. `power` is that of the symmetric map whose pattern is followed.
  TangentMarch(const TimeMarch& orbit, Disturbance disturbance, int power);

  Eigen::Index size() const { return map_.state().size(); }
  /// A disturbance with which an iteration may start, as seeded_disturbance() makes it.
  Eigen::VectorXd seed() const { return seeded_disturbance(march_, 0); }
  double maps_per_revolution() const { return map_.maps_per_revolution(); }
  /// The derivative DF times a change of a state of SymmetricMap. Raises NoMotion if the compliance of nodes that the
  /// pattern closes together is singular.
  Eigen::VectorXd operator()(const std::shared_ptr<const ContactPattern>& pattern, const Eigen::VectorXd& change);
  /// The same for a motion without contact.
  Eigen::VectorXd in_free_flight(const Eigen::VectorXd& change);

 private:
  void hold(const std::shared_ptr<const ContactPattern>& pattern);
  std::vector<int> on_all_sectors(const std::vector<int>& nodes) const;
  /// Whether the directions of the forces change with the motion.
  bool turns() const { return march_.has_friction() || march_.is_curved(); }
  /// Sets the directions of the forces in a step to those of the orbit.
  void direct(std::size_t step, std::size_t contact);
  /// The factor of the block of W of some nodes, for these directions.
  Eigen::PartialPivLU<Eigen::MatrixXd> factor_of(const std::vector<int>& nodes);
  /// [m] The narrowing of the gaps of a disturbance with the coordinates `blades`, by the slopes of the orbit at the
  /// coordinates y in a step.
  Eigen::VectorXd narrowed(const Eigen::VectorXd& y, const Eigen::VectorXd& blades, std::int64_t step) const;
  /// Subtracts this narrowing from the gaps at the start of the map, or from those of a step.
  void narrow_start();
  void narrow(std::size_t step);
  /// Computes turned_slopes_ for a step.
  void turn_slopes(std::size_t step);
  /// Completes a step with contact, which is number `contact` among those of the pattern.
  void close(std::size_t step, std::size_t contact, const std::vector<InnerImpact>& impacts);
  /// The change of the forces of the orbit due to the change of their directions: from mu lambda over the length of
  /// the path of each node, from the forces, and from the reduction of y by them.
  TurnedForces turned(const Eigen::VectorXd& over_way, const Eigen::VectorXd& forces,
                      const Eigen::VectorXd& taken) const;
  /// The changes of the impacts by the gaps of the free step, one for each copy of the sectors.
  std::vector<InnerImpact::Change> changes(std::size_t step, const std::vector<InnerImpact>& impacts);
  void strike(const std::vector<InnerImpact>& impacts, const std::vector<InnerImpact::Change>& changes,
              const TurnedForces& more);

  const TimeMarch& orbit_;
  TimeMarch march_;
  SymmetricMap map_;
  int copies_, nodes_a_copy_;   ///< copies of the sectors of the orbit in this march; values per copy
  Eigen::MatrixXd compliance_;  ///< [m/N] W, of full rank
  std::shared_ptr<const ContactPattern> pattern_;
  std::vector<std::vector<int>> closed_;                               ///< the sets of the pattern, on all sectors
  std::vector<Eigen::LLT<Eigen::MatrixXd>> factors_;                   ///< of the sets, if directions do not change
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXd>> turning_factors_;  ///< of the steps with contact, otherwise
  Eigen::VectorXd forces_, target_, of_set_;
  Eigen::VectorXd slide_, way_;    ///< [m] TimeMarch::slide() of a step, and TimeMarch::way() of the orbit
  Eigen::MatrixXd turned_slopes_;  ///< the change of TimeMarch::slopes() at the start of a step
};

/// The symmetric map of a march, or a power of this map, with its derivative.
class MarchedMap final : public PeriodicMap {
 public:
  /// Keeps a reference to the march, and leaves its clock unchanged.
  explicit MarchedMap(TimeMarch& march, int power = 1);

  const SymmetricMap& symmetric() const { return map_; }
  /// Puts the march onto an orbit. The state does not contain modes without mass, which follow the forces; if there
  /// are any, a whole revolution is marched.
  void put(const Eigen::VectorXd& state);

  MapImage image(const Eigen::VectorXd& state) override;
  Eigen::VectorXd tangent(const std::shared_ptr<const ContactPattern>& pattern,
                          const Eigen::VectorXd& change) override;
  /// (1 - DF)^-1 of a motion without contact, in which the modes do not couple. The contact of an orbit hardly
  /// changes the slow modes, whose number determines how many steps GMRES takes.
  Eigen::VectorXd precondition(const Eigen::VectorXd& change) override;
  /// As seeded_disturbance() makes it.
  Eigen::VectorXd seed() const override { return tangent_.seed(); }
  /// The number of calls of tangent() so far.
  int tangents() const { return tangents_; }

 private:
  /// The inverse of a 2 x 2 matrix for each mode of a wave, which acts on its position and velocity.
  struct Inverse {
    Eigen::ArrayXcd position_from_position, position_from_velocity, velocity_from_position, velocity_from_velocity;
  };
  void invert_free_flight();

  TimeMarch& march_;
  SymmetricMap map_;
  TangentMarch tangent_;
  std::vector<Inverse> free_;  ///< by wave; empty until it is needed
  bool all_have_mass_;
  int tangents_ = 0;
};

}  // namespace tiprub::simulate
