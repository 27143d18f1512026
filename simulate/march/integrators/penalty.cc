// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/integrators/penalty.h"

#include <algorithm>
#include <cmath>

#include "reduce/model/dense_eigen.h"
#include "simulate/march/integrators/contact_law.h"

namespace tiprub {

double penalised_omega_max(const RotorAtSpeed& rotor, double stiffness) {
  double square = 0;
  for (const WaveModes& wave : rotor.waves) {
    Eigen::MatrixXcd sprung = stiffness * wave.normal_rows.adjoint() * wave.normal_rows;
    sprung.diagonal() += wave.omega.square().matrix().cast<std::complex<double>>();
    square = std::max(square, eigenvalues(sprung).maxCoeff());
  }
  return std::sqrt(square);
}

namespace {

class PenaltyContact final : public ContactLaw {
 public:
  PenaltyContact(const Eigen::MatrixXd& compliance, double stiffness)
      : compliance_(compliance),
        stiffness_(stiffness),
        multipliers_(Eigen::VectorXd::Zero(compliance.rows())),
        correction_(multipliers_) {}

  bool step(const Eigen::VectorXd& gap_before, Eigen::VectorXd& gap, bool /*penetrates*/) override {
    for (int i : closed_) multipliers_[i] = 0;
    closed_.clear();
    correction_.setZero();
    for (Eigen::Index i = 0; i < gap.size(); ++i) {
      if (!(gap_before[i] < 0)) continue;
      multipliers_[i] = -stiffness_ * gap_before[i];
      correction_.noalias() += multipliers_[i] * compliance_.col(i);
      closed_.push_back(static_cast<int>(i));
    }
    gap += correction_;
    return !closed_.empty();
  }
  const Eigen::VectorXd& multipliers() const override { return multipliers_; }
  const Eigen::VectorXd& correction() const override { return correction_; }
  const std::vector<int>& closed() const override { return closed_; }

 private:
  const Eigen::MatrixXd compliance_;
  double stiffness_;
  Eigen::VectorXd multipliers_, correction_;
  std::vector<int> closed_;
};

}  // namespace

std::unique_ptr<ContactLaw> penalty_contact(const Eigen::MatrixXd& compliance, double stiffness) {
  return std::make_unique<PenaltyContact>(compliance, stiffness);
}

}  // namespace tiprub
