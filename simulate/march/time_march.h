// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulate/march/contact_impulses.h"
#include "simulate/march/marched_scene.h"
#include "simulate/march/modal_waves.h"
#include "simulate/march/second_order_terms.h"

namespace tiprub::simulate {

/// The positions of the modes of a nodal diameter at t_q, and their increments since t_{q-1}; both [m sqrt(kg)].
struct ModalState {
  Eigen::VectorXcd q, increment;
};

/// The change of the forces of an orbit due to the change of their directions by a disturbance. Members are empty
/// where directions do not change.
struct TurnedForces {
  Eigen::VectorXd drag;    ///< [N] along theta and along the tip line, alternately
  Eigen::VectorXd blades;  ///< [N] on the coordinates y
  Eigen::VectorXd gaps;    ///< [m] opening of the gaps by the forces of the orbit as the slopes change; by node
};

/// The time loop of all schemes: a rotor in modal coordinates against a rigid casing. A step is
///   q+ = q + d+,   d+ = d - r d - k q - c Y^H Lambda_n,
///   Lambda_n = (w_n g / N) sum_j lambda_j e^{-i n j alpha},   j < N/g,
/// with lambda from the contact law of the scheme, usually 0 <= lambda perpendicular to g+ >= 0. Nodal diameters are
/// coupled by the contact nodes only. The lambda that the step from t_q to t_{q+1} finds is the force at t_q. The
/// march starts from rest. With the coefficients of central differences, predict() is the paper's eq. 13, and the
/// contact forces and their effect are its eqs. 14 and 15. Modes without mass (residual flexibility) take no part in
/// the free step. A step costs 2 m n_c complex multiplications for each nodal diameter, and twice that in contact.
///
/// With friction the force on a closed node is -lambda (nu + mu tau), where tau is the direction in which the node
/// slides over the casing, that of (r_k Omega + u'_theta) e_theta + u'_m e_m. The velocity is that of the last step,
/// which lags by half a step. The direction is therefore known before the forces, and a march is still a map of the
/// modes at two instants. Friction acts on the modes of WaveModes::sliding_rows only.
///
/// With a gap of second order (SecondOrderTerms), the gap of the free step is exact in the coordinates y of the
/// blades. The forces act along the slopes of the gap at t_q, and the gap that they add is linear in y about t_q.
/// Their work is that of the gap but for terms of second order in the step while a node stays closed, and of first
/// order in the step of an impact.
///
/// Values at contact nodes are stored in one vector, sector after sector, each padded to width() nodes.
class TimeMarch {
 public:
  /// All members raise NoMotion if a contact problem has no solution, or if a node with friction no longer slides
  /// forward over the casing.
  explicit TimeMarch(MarchedScene scene);

  /// One step: predict(), the contact law of the scheme, and the effect of its forces.
  void step();
  /// The free step to t_{q+1}. Returns whether a node penetrates.
  bool predict();
  /// Adds forces [N] along -normal at t_q to the step just predicted. `nodes` are the indices of the nodes with a
  /// force; `more` are additional forces on the sectors of these nodes.
  void correct(const Eigen::VectorXd& forces, const std::vector<int>& nodes, const TurnedForces& more = {});
  /// Adds impulses along -normal at t_{q+1}, given as forces [N] that act over a step. They change the increments,
  /// and with them the displacements and gaps at t_q that these imply (InnerImpact); the displacements at t_{q+1}
  /// stay.
  void jump(const Eigen::VectorXd& impulses, const std::vector<int>& nodes, const TurnedForces& more = {});
  /// [m] The opening of the gaps by such additional forces; by node.
  Eigen::VectorXd opened_by(const TurnedForces& more) const;
  /// [m] The displacements of the contact nodes by the modes in the step before the one just predicted, along theta
  /// and along the tip line alternately; only with friction.
  const Eigen::VectorXd& slide();
  /// Sets the directions of sliding for the step just predicted, in place of those that step() finds: paths of any
  /// length over the casing, in the same order. The object keeps a reference to them.
  void slide_along(const Eigen::VectorXd& way) { of_step_->slide(way); }
  /// Sets the slopes of the gaps in the same way.
  void tilt(const Eigen::MatrixXd& slopes) { of_step_->tilt() = slopes; }
  /// [m/N] The block of W of some nodes for these directions.
  Eigen::MatrixXd compliance(const std::vector<int>& nodes);
  /// [1] The slopes ds/dy of a gap of second order in a step, for blades with the coordinates y [m]: a row for each
  /// node, a column for each coordinate of a sector and its padding. They are affine in y.
  Eigen::MatrixXd slopes(const Eigen::VectorXd& blades, std::int64_t step) const;
  /// [m] By how much contact forces [N] of the last step reduce y.
  Eigen::VectorXd blade_response(const Eigen::VectorXd& forces, const std::vector<int>& nodes);

  const MarchedScene& scene() const { return scene_; }
  const RotorAtSpeed& rotor() const { return *scene_.rotor; }
  std::int64_t step_count() const { return step_; }
  double time_step() const { return time_step_; }
  int sector_count() const { return sector_count_; }
  int symmetry() const { return scene_.setup.symmetry; }
  int sectors() const { return sectors_; }
  int node_count() const { return node_count_; }
  int width() const { return static_cast<int>(width_); }
  int steps_per_revolution() const { return scene_.setup.steps_per_revolution; }

  /// [m] The gaps after the last step; infinite for padding.
  const Eigen::VectorXd& gap() const { return gap_; }
  /// [m] The gaps at t_{q-2}, t_{q-1} and t_q, the end of the last step.
  GapHistory gaps() const { return {gap_two_before_, gap_before_, gap_}; }
  /// [m] The displacements along the normals at t_q and at t_{q-1}.
  const Eigen::VectorXd& displacement() const { return motion_[0].normal; }
  const Eigen::VectorXd& displacement_before() const { return motion_[1].normal; }
  /// [m] The coordinates y of the blades at t_q, at t_{q-1} and after look_ahead(); empty if the gap is linear.
  const Eigen::VectorXd& blades() const { return motion_[0].blades; }
  const Eigen::VectorXd& blades_before() const { return motion_[1].blades; }
  const Eigen::VectorXd& blades_ahead() const { return motion_ahead_.blades; }
  /// The contact forces of the last step: [N], zero for open nodes.
  const ContactLaw& contact() const { return *contact_; }
  bool has_friction() const { return scene_.setup.friction.size() > 0; }
  /// Whether the gap is of second order.
  bool is_curved() const { return second_order_.has_value(); }
  /// [J] The work of the contact forces of the last step, without drag, on the marched sectors.
  double contact_work() const;
  /// [1] mu tau of the nodes that were closed in the last step with contact, along theta and along the tip line
  /// alternately.
  const Eigen::VectorXd& drag_ratio() const { return of_step_->drag_ratio(); }
  /// [m] The paths of all nodes over the casing in the step before it, in the same order.
  const Eigen::VectorXd& way() const { return slide_; }
  /// The impacts within the last step. Their impulses act at its end, in addition to the forces of contact() at its
  /// start.
  const std::vector<InnerImpact>& impacts() const;
  /// [N] Their impulses, as forces over a step; by node.
  const Eigen::VectorXd& impulses() const { return impulses_; }
  /// [m] The gaps after one more step without forces, which is not carried out. Valid until the next step.
  const Eigen::VectorXd& look_ahead();
  /// [m/N] W of the whole problem, padded rows zero.
  const Eigen::MatrixXd& compliance() const { return compliance_; }

  std::size_t wave_count() const { return waves_.size(); }
  /// `wave` is an index in RotorAtSpeed::waves.
  const MarchedWave& wave(std::size_t wave) const { return waves_[wave]; }
  /// The modal coordinates, including the effect of the forces of the last step.
  ModalCoordinates coordinates(std::size_t wave) const { return waves_.coordinates(wave); }
  /// d = q - q- of the last step, and of the step before.
  ModalCoordinates increments(std::size_t wave) const { return waves_.increments(wave); }
  ModalCoordinates increments_before(std::size_t wave) const { return waves_.increments_before(wave); }
  /// The part of the increments that impulses of the last step have added; valid if impacts() is not empty.
  ModalCoordinates jumps(std::size_t wave) const { return waves_.jumps(wave); }
  /// [N] Lambda_n of the last step that had contact; n_c.
  Eigen::VectorXcd modal_forces(std::size_t wave) const { return waves_.forces(wave); }
  /// Sets the state of nodal diameters from `first_wave` on, or of one of them.
  void set_states(const std::vector<ModalState>& waves, std::size_t first_wave = 0);
  void set_state(std::size_t wave, const Eigen::VectorXcd& q, const Eigen::VectorXcd& increment) {
    set_states({{q, increment}}, wave);
  }
  /// Sets the clock: steps since the start (the casing's distortion grows over the first revolutions).
  void set_step(std::int64_t step);
  /// Sets the gaps [m] at t_{q-1} and t_q, exact to the last bit. The other setters compute them from the modes.
  void set_gaps(const Eigen::VectorXd& before, const Eigen::VectorXd& now) {
    gap_before_ = before;
    gap_ = now;
  }

 private:
  /// Computes the gaps of a step from the motion. Returns whether a gap is negative.
  bool measure_gaps(std::int64_t step, const TipMotion& motion, Eigen::VectorXd& gap) const;
  /// Computes the gaps at the last two instants.
  void measure_both();
  void tabulate_obstacle();
  void prepare_contact();
  /// The number of values per sector in TipMotion::blades.
  Eigen::Index blade_width() const { return blade_forces_.size() / sectors_; }
  SecondOrderTerms::Place casing_over(int sector, std::int64_t step) const;
  /// Computes the directions of the forces in a step: those of sliding, and the slopes of the gaps.
  void turn();
  void find_slopes(const Eigen::VectorXd& blades, std::int64_t step, Eigen::MatrixXd& slopes) const;
  /// Computes the forces of a step, and their effect on a motion and on its gaps, of which `direction` is the sign.
  void push(const Eigen::VectorXd& forces, const std::vector<int>& nodes, const TurnedForces& more, TipMotion& motion,
            Eigen::VectorXd& gap, double direction);
  /// Subtracts the effect of forces, times `direction`, from a motion.
  void move(TipMotion& motion, const Eigen::VectorXd& forces, const std::vector<int>& nodes, double direction);
  void require_sliding() const;
  /// [N] The drag due to contact forces, along theta and along the tip line alternately.
  const Eigen::VectorXd& drag_of(const Eigen::VectorXd& forces, const std::vector<int>& nodes);
  /// [N] The generalised forces of contact forces on the coordinates y of the blades.
  const Eigen::VectorXd& blade_forces(const Eigen::VectorXd& forces, const std::vector<int>& nodes);
  /// Shifts the gaps by the targets of the inner impacts; `direction` is -1 before and 1 after the contact law.
  void aim(double direction);
  void strike();

  MarchedScene scene_;
  int sector_count_, sectors_, node_count_;
  std::size_t width_;
  double time_step_;
  std::int64_t step_ = 0;
  ModalWaves waves_;
  Eigen::VectorXd clearance_;       ///< [m] sector by sector, padded with infinity
  std::vector<double> distortion_;  ///< [m] by phase (one lobe of steps), then node
  std::int64_t phases_ = 1;
  std::optional<SecondOrderTerms> second_order_;
  Eigen::VectorXd gap_, gap_before_, gap_two_before_, gap_ahead_;
  TipMotion motion_[3], motion_ahead_;
  Eigen::MatrixXd compliance_;
  std::shared_ptr<ContactCompliance> of_step_;  ///< W of the present step
  Eigen::VectorXd carried_;  ///< [m] path due to rotation in a step, along theta and along the tip line alternately
  Eigen::VectorXd slide_, drag_;  ///< [m] path in a step, [N] drag; in the order of carried_
  Eigen::VectorXd blade_forces_;  ///< [N] on the coordinates y, sector after sector
  std::unique_ptr<ContactLaw> contact_;
  std::optional<InnerImpacts> inner_;  ///< only if the scheme finds inner impacts
  std::vector<int> struck_;            ///< nodes with an inner impact in the last step
  Eigen::VectorXd impulses_;           ///< [N] their impulses; zero elsewhere
};

}  // namespace tiprub::simulate
