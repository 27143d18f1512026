// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "simulate/march/cache_lines.h"
#include "simulate/march/contact_compliance.h"
#include "simulate/march/contact_kernels.h"
#include "simulate/motion/scene_choices.h"

namespace tiprub::simulate {

struct MarchSetup;

/// A law that gives the contact forces of a step. It is expressed by gaps only, so that no velocity of the casing is
/// needed.
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;

  /// Finds the forces from the gaps at t_q and those of the free step to t_{q+1}, and updates the latter. Returns
  /// whether there are any forces. `penetrates`: whether a free gap is negative.
  virtual bool step(const Eigen::VectorXd& gap_before, Eigen::VectorXd& gap, bool penetrates) = 0;

  /// [N] the forces at t_q along -normal; zero for open nodes.
  virtual const Eigen::VectorXd& multipliers() const = 0;
  /// [m] W lambda, by which the forces change the gaps.
  virtual const Eigen::VectorXd& correction() const = 0;
  /// Indices of the nodes that have a force, ascending.
  virtual const std::vector<int>& closed() const = 0;
  virtual std::int64_t fallbacks() const { return 0; }
};

/// The inverse V of the block of W that belongs to the closed nodes, kept from step to step. A node that closes or
/// opens changes it by a matrix of rank one, and the forces of a set are one product. Rounding errors accumulate, and
/// W may be singular. The caller must therefore check the gaps that remain under the forces, and call clear() where
/// they are larger than rounding.
class ClosedInverse {
 public:
  /// W [m/N] in columns of `stride` rows, a whole number of vectors. W must outlive this object.
  ClosedInverse(const double* compliance, std::size_t stride, double diagonal_shift);

  /// Updates the inverse to this set. Returns false, and leaves the inverse empty, if a pivot is not positive.
  bool follow(const std::vector<int>& closed);
  void clear();
  /// The nodes in the order of forces().
  const std::vector<int>& nodes() const { return nodes_; }
  /// [N] -V g, with the gaps g [m] of the closed nodes; nodes().size() values, then zeros up to a whole vector.
  const double* forces(const double* gap);

 private:
  bool close(int node);
  void open(std::size_t slot);

  const double* compliance_;
  std::size_t stride_;
  double diagonal_;
  kernels::Lines inverse_, column_, product_;
  std::vector<int> nodes_, all_slots_;
  std::vector<char> wanted_;  ///< by node, while the set is followed
};

/// Contact in positions: the force at t_q closes the gap at t_{q+1}. With g the gaps of the free step (positive open)
/// and W the compliance of the contact nodes over one step (block circulant, built once a speed), finds lambda >= 0
/// with
///   g+ = g + W lambda >= 0,  lambda . g+ = 0
/// by a primal-dual active set (Hintermueller, Ito, Kunisch 2003), which starts from the set of the last step. Each
/// set is solved with the inverse of the block of the closed nodes, which is kept from step to step, or with a factor
/// where the inverse leaves more than rounding. If the active set does not converge, Murty's least-index method
/// (1974) follows, which is finite for a positive definite W. W gets a relative shift on its diagonal, so that tied
/// or doubled nodes (a singular W) have a solution; the shift leaves a closed node off the wall by 1e-12 W_ii
/// lambda_i.
///
/// With friction W is unsymmetric, and with friction or a gap of second order it changes from step to step, so that
/// each set is factorized anew. The forces are unique, and Murty's method is finite, as long as W is a P-matrix: all
/// its principal minors are positive.
///
/// The paper's rule accepts a negative multiplier (the casing pulls) in some steps and leaves other nodes penetrating
/// in many. It is kept for reproduction, and its violations are counted. The paper's eq. 15 has the opposite sign of
/// its eq. 14: here g+ = g + W lambda.
class ContactImpulses final : public ContactLaw {
 public:
  /// A row of zeros of W belongs to a node that never closes.
  ContactImpulses(std::shared_ptr<ContactCompliance> compliance, ContactRule rule);
  /// W [m/N] without friction; n x n, symmetric positive semidefinite.
  ContactImpulses(const Eigen::MatrixXd& compliance, ContactRule rule)
      : ContactImpulses(std::make_shared<ContactCompliance>(compliance), rule) {}

  bool step(const Eigen::VectorXd& /*gap_before*/, Eigen::VectorXd& gap, bool penetrates) override {
    if (penetrates)
      solve(gap);
    else
      open();
    return penetrates;
  }
  /// Takes the gaps [m] of the free step to those of the step: g += W lambda. At least one gap must be negative.
  /// Raises NoMotion if no solution is found (W has a negative principal minor).
  void solve(Eigen::Ref<Eigen::VectorXd> gap);
  /// Records a step without contact.
  void open();

  const Eigen::VectorXd& multipliers() const override { return multipliers_; }
  const Eigen::VectorXd& correction() const override { return correction_; }
  const std::vector<int>& closed() const override { return closed_; }

  /// How often a set was factorized: always if W changes, otherwise where the kept inverse was not accurate enough.
  std::int64_t factorizations() const { return factorizations_; }
  std::int64_t fallbacks() const override { return fallbacks_; }

 private:
  // These work on free_gap_, gap_, closed_, multipliers_ and correction_.
  void solve_closed();
  bool solve_by_inverse();
  void solve_by_factor();
  bool set_stands(double tolerance);
  void factorize();
  kernels::Columns columns() const { return {compliance_->data(), stride_, stride_}; }
  kernels::Factor factor() { return {lower_.data(), upper_.data(), inverse_pivots_.data(), stride_}; }
  bool settle_active_set(double tolerance);
  void settle_least_index(double tolerance);
  void close_penetrating();

  ContactRule rule_;
  Eigen::VectorXd multipliers_, correction_, free_gap_, gap_;
  // padded for contact_kernels.h
  std::size_t stride_;
  std::shared_ptr<ContactCompliance> compliance_;
  kernels::Lines lower_, upper_;  ///< the factor of the block of `factorized_`
  kernels::Lines inverse_pivots_, closed_forces_, padded_correction_;
  ClosedInverse inverse_;
  std::vector<int> closed_, next_, factorized_, warm_;
  std::int64_t factorizations_ = 0;
  std::int64_t fallbacks_ = 0;
};

/// The law of a scheme: complementarity or the paper's rule in positions, impulses in velocities, or springs.
std::unique_ptr<ContactLaw> contact_law(const MarchSetup& setup,
                                        const std::shared_ptr<ContactCompliance>& compliance);

}  // namespace tiprub::simulate
