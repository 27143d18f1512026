// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/energy_audit.h"

#include <algorithm>
#include <cmath>

namespace tiprub {

EnergyAudit::EnergyAudit(const TimeMarch& march) {
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const MarchedWave& wave = march.wave(i);
    const auto& [a, b, c] = wave.coefficients;
    const auto moves = c > 0;
    const Eigen::ArrayXd divisor = moves.select(c, 1.0);
    terms_.push_back({march.sector_count() / wave.weight, moves.select((1 + b) / (4 * divisor), 0.0),
                      0.5 * wave.omega.square(), moves.select((1 - b) / (4 * divisor), 0.0),
                      march.rotor().waves[i].residual_compliance});
  }
  start_ = energy(march);
}

double EnergyAudit::energy(const TimeMarch& march) const {
  double sum = 0;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Terms& terms = terms_[i];
    const auto of_part = [&](const auto& q, const auto& before) {
      return terms.ring * (terms.inertia * (q - before).square() + terms.stiffness * q * before).sum();
    };
    const ModalCoordinates now = march.coordinates(i), before = march.coordinates(i, Instant::before);
    sum += of_part(now.real, before.real);
    sum += of_part(now.imaginary, before.imaginary);
  }
  return sum;
}

void EnergyAudit::observe(const TimeMarch& march) {
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Terms& terms = terms_[i];
    const auto of_part = [&](const auto& q, const auto& two_before) {
      return terms.ring * (terms.damping * (q - two_before).square()).sum();
    };
    const ModalCoordinates now = march.coordinates(i), two_before = march.coordinates(i, Instant::two_before);
    dissipated_ += of_part(now.real, two_before.real);
    dissipated_ += of_part(now.imaginary, two_before.imaginary);
  }
  double work = 0;
  for (int index : march.contact().closed())
    work -= march.contact().multipliers()[index] *
            (march.displacement()[index] - march.displacement_two_before()[index]) / 2;
  work_ += march.symmetry() * work;
  observe_left_out(march);
}

/// Adds 1/2 Lambda^H (Y omega^-2 Y^H) Lambda, the energy of the left-out modes under the forces of the step.
void EnergyAudit::observe_left_out(const TimeMarch& march) {
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Terms& terms = terms_[i];
    if (terms.residual.size() == 0) continue;
    const auto of_part = [&](const auto& q) {
      return terms.ring * (terms.stiffness * q.square()).head(march.wave(i).moving).sum();
    };
    const ModalCoordinates now = march.coordinates(i);
    elastic_ += of_part(now.real);
    elastic_ += of_part(now.imaginary);
    if (march.contact().closed().empty()) continue;
    const Eigen::VectorXcd forces = march.modal_forces(i);
    left_out_ += terms.ring * 0.5 * forces.dot(terms.residual * forces).real();
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
