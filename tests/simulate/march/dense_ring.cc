// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulate/march/dense_ring.h"

#include <complex>
#include <numbers>

#include "reduce/model/dense_eigen.h"

namespace tiprub::simulate::testing {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// eq. 11, eq. 12: the ring's matrix from those of its nodal diameters: block (j, k) = 1/N sum over n = 0 .. N-1 of
/// A_n e^{i n (j - k) alpha}, with A_{N-n} = conj A_n.
Eigen::MatrixXd ring(const std::vector<Eigen::MatrixXcd>& by_diameter, int sectors) {
  const Eigen::Index size = by_diameter.front().rows();
  Eigen::MatrixXd whole(size * sectors, size * sectors);
  for (int j = 0; j < sectors; ++j)
    for (int k = 0; k < sectors; ++k) {
      Eigen::MatrixXcd block = Eigen::MatrixXcd::Zero(size, size);
      for (int n = 0; n < sectors; ++n) {
        const std::complex<double> phase = std::polar(1.0, two_pi * n * (j - k) / sectors);
        block += 2 * n <= sectors ? Eigen::MatrixXcd(by_diameter[n] * phase)
                                  : Eigen::MatrixXcd(by_diameter[sectors - n].conjugate() * phase);
      }
      whole.block(j * size, k * size, size, size) = block.real() / sectors;
    }
  return whole;
}

}  // namespace

DenseRing::DenseRing(const ReducedModel& model, const Casing& casing, double speed, double damping_ratio,
                     int steps_per_revolution, ContactRule rule)
    : model_(model), casing_(casing), steps_(steps_per_revolution), rule_(rule) {
  const int N = model.sector_count, nodes = model.contact.size();
  const double h = two_pi / speed / steps_per_revolution;
  std::vector<Eigen::MatrixXcd> K_n, M_n;
  for (const NodalDiameterModel& at : model.nodal_diameters) {
    K_n.push_back(at.stiffness(speed));
    M_n.push_back(at.M);
  }
  const Eigen::MatrixXd K = ring(K_n, N), M = ring(M_n, N);
  const RealEigenpairs modes = eigenpairs(K, M);
  const Eigen::MatrixXd MPhi = M * modes.vectors;
  const Eigen::VectorXd omega = modes.values.cwiseSqrt();
  const Eigen::MatrixXd D = MPhi * (2 * damping_ratio * omega).asDiagonal() * MPhi.transpose();  // modal damping
  const Eigen::MatrixXd inverse =
      (M / (h * h) + D / (2 * h)).llt().solve(Eigen::MatrixXd::Identity(M.rows(), M.rows()));
  onto_u_ = inverse * (2 / (h * h) * M - K);
  onto_before_ = inverse * (D / (2 * h) - M / (h * h));
  const Eigen::Index size = M.rows() / N;
  C_ = Eigen::MatrixXd::Zero(M.rows(), N * nodes);
  for (int j = 0; j < N; ++j)
    for (int k = 0; k < nodes; ++k)
      C_.block<3, 1>(j * size + 3 * k, j * nodes + k) = model.contact.normal.row(k).transpose();
  push_ = inverse * C_;
  W_ = C_.transpose() * push_;
  clearance_ = casing.running_clearance(model.contact, speed).replicate(N, 1);
  for (int j = 0; j < N; ++j) clearance_.segment(j * nodes, nodes).array() += casing.extra_clearance(j);
  u_ = before_ = Eigen::VectorXd::Zero(M.rows());
  lambda_ = gap_ = Eigen::VectorXd::Zero(N * nodes);
}

/// eq. 15, with the sign that eq. 14 asks for.
void DenseRing::close_penetrating() {
  std::vector<Eigen::Index> closed;
  for (Eigen::Index i = 0; i < gap_.size(); ++i)
    if (gap_[i] < 0) closed.push_back(i);
  lambda_(closed) = W_(closed, closed).llt().solve(Eigen::VectorXd(-gap_(closed))).eval();
}

/// Murty's least-index method, from scratch in every step.
void DenseRing::complement() {
  std::vector<char> is_closed(gap_.size(), 0);
  const double tolerance = 1e-13 * gap_.cwiseAbs().maxCoeff();
  while (true) {
    std::vector<Eigen::Index> closed;
    for (Eigen::Index i = 0; i < gap_.size(); ++i)
      if (is_closed[i] != 0) closed.push_back(i);
    lambda_.setZero();
    if (!closed.empty()) lambda_(closed) = W_(closed, closed).llt().solve(Eigen::VectorXd(-gap_(closed))).eval();
    const Eigen::VectorXd after = gap_ + W_ * lambda_;
    Eigen::Index wrong = 0;
    while (wrong < gap_.size() && (is_closed[wrong] != 0 ? lambda_[wrong] >= 0 : after[wrong] >= -tolerance)) ++wrong;
    if (wrong == gap_.size()) return;
    is_closed[wrong] = is_closed[wrong] != 0 ? 0 : 1;
  }
}

void DenseRing::step() {
  const Eigen::VectorXd free = onto_u_ * u_ + onto_before_ * before_;  // eq. 13
  ++step_;
  const double turned = two_pi * static_cast<double>(step_) / steps_;
  const double ramp = casing_.ramp(static_cast<double>(step_) / steps_);
  const int nodes = model_.contact.size();
  const Eigen::VectorXd normal = C_.transpose() * free;
  const Eigen::VectorXd& arc = model_.contact.arc_length;
  const auto fraction = [&](int k) { return (arc[k] - arc[0]) / (arc[nodes - 1] - arc[0]); };
  for (int j = 0; j < model_.sector_count; ++j)
    for (int k = 0; k < nodes; ++k) {
      const double angle = model_.contact.position(k, 1) + two_pi * j / model_.sector_count + turned;
      gap_[j * nodes + k] =
          clearance_[j * nodes + k] - ramp * casing_.distortion(angle, fraction(k)) - normal[j * nodes + k];
    }
  lambda_.setZero();
  if (gap_.minCoeff() < 0) {  // eq. 14: penetrations are to be cancelled
    if (rule_ == ContactRule::paper)
      close_penetrating();
    else
      complement();
  }
  before_ = u_;
  u_ = free - push_ * lambda_;  // eq. 15: the corrected displacements
  gap_ += W_ * lambda_;
}

}  // namespace tiprub::simulate::testing
