// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/energy_audit.h"

#include <algorithm>
#include <cmath>

namespace tiprub {

EnergyAudit::EnergyAudit(const TimeMarch& march, const RotorAtSpeed& rotor) {
  for (std::size_t i = 0; i < march.waves().size(); ++i) {
    const TimeMarch::Wave& wave = march.waves()[i];
    const auto& [a, b, c] = wave.coefficients;
    const auto moves = c > 0;
    const Eigen::ArrayXd divisor = moves.select(c, 1.0);
    terms_.push_back({march.sector_count() / wave.weight, moves.select((1 + b) / (4 * divisor), 0.0),
                      0.5 * wave.omega.square(), moves.select((1 - b) / (4 * divisor), 0.0),
                      rotor.waves[i].rest_compliance});
  }
  start_ = energy(march);
}

double EnergyAudit::energy(const TimeMarch& march) const {
  double sum = 0;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const TimeMarch::Wave& wave = march.waves()[i];
    const Eigen::Index modes = wave.modes();
    for (Eigen::Index part : {Eigen::Index{0}, modes}) {
      const auto q = wave.q.segment(part, modes).array();
      const auto before = wave.before.segment(part, modes).array();
      sum += terms_[i].ring * (terms_[i].inertia * (q - before).square() + terms_[i].stiffness * q * before).sum();
    }
  }
  return sum;
}

void EnergyAudit::observe(const TimeMarch& march) {
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const TimeMarch::Wave& wave = march.waves()[i];
    const Eigen::Index modes = wave.modes();
    for (Eigen::Index part : {Eigen::Index{0}, modes})
      dissipated_ +=
          terms_[i].ring *
          (terms_[i].damping * (wave.q.segment(part, modes) - wave.two_before.segment(part, modes)).array().square())
              .sum();
  }
  double work = 0;
  for (int index : march.contact().closed())
    work -= march.contact().multipliers()[index] *
            (march.displacement()[index] - march.displacement_two_before()[index]) / 2;
  work_ += march.symmetry() * work;
  observe_left_out(march);
}

/// 1/2 Lambda^H (Y omega^-2 Y^H) Lambda of the left-out modes, under the forces of the step.
void EnergyAudit::observe_left_out(const TimeMarch& march) {
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Eigen::MatrixXcd& rest = terms_[i].rest;
    if (rest.size() == 0) continue;
    const TimeMarch::Wave& wave = march.waves()[i];
    for (Eigen::Index part : {Eigen::Index{0}, wave.modes()})
      elastic_ += terms_[i].ring *
                  (terms_[i].stiffness * wave.q.segment(part, wave.modes()).array().square()).head(wave.moving).sum();
    if (march.contact().closed().empty()) continue;
    const Eigen::Index nodes = rest.rows();
    Eigen::VectorXcd forces(nodes);
    forces.real() = wave.forces.head(nodes);
    forces.imag() = wave.forces.segment(march.width(), nodes);
    left_out_ += terms_[i].ring * 0.5 * forces.dot(rest * forces).real();
  }
}

double EnergyAudit::left_out_share() const {
  return left_out_ > 0 ? left_out_ / (left_out_ + elastic_) : 0.0;
}

EnergyLedger EnergyAudit::ledger(const TimeMarch& march) const {
  EnergyLedger ledger;
  ledger.contact_work = work_;
  ledger.dissipated = dissipated_;
  ledger.energy_change = energy(march) - start_;
  const double scale = std::max({std::abs(work_), std::abs(dissipated_), std::abs(ledger.energy_change)});
  if (scale > 0) ledger.closing_error = (work_ - dissipated_ - ledger.energy_change) / scale;
  return ledger;
}

}  // namespace tiprub
