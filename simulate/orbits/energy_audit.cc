// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/energy_audit.h"

#include <algorithm>
#include <cmath>

namespace tiprub::simulate {

EnergyAudit::EnergyAudit(const TimeMarch& march) {
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const MarchedWave& wave = march.wave(i);
    const auto& [r, k, c] = wave.coefficients;
    const auto moves = c > 0;
    const Eigen::ArrayXd divisor = moves.select(c, 1.0);
    terms_.push_back({march.sector_count() / wave.weight, moves.select((2 - r) / (4 * divisor), 0.0),
                      0.5 * wave.omega.square(), moves.select(r / (4 * divisor), 0.0),
                      march.rotor().waves[i].residual_compliance});
  }
  start_ = energy(march);
}

double EnergyAudit::energy(const TimeMarch& march) const {
  double sum = 0;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Terms& terms = terms_[i];
    const auto of_part = [&](const auto& q, const auto& increment) {
      return terms.ring * (terms.inertia * increment.square() + terms.stiffness * q * (q - increment)).sum();
    };
    const ModalCoordinates now = march.coordinates(i), last = march.increments(i);
    sum += of_part(now.real, last.real);
    sum += of_part(now.imaginary, last.imaginary);
  }
  return sum;
}

/// The change of the energy by impulses at t_{q+1}, which have changed the increment by `jump`.
double EnergyAudit::jump_work(const Terms& terms, const Modes& q, const Modes& increment, const Modes& jump) {
  return terms.ring * (jump * (terms.inertia * (2 * increment - jump) - terms.stiffness * q)).sum();
}

void EnergyAudit::observe(const TimeMarch& march) {
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Terms& terms = terms_[i];
    const auto of_part = [&](const auto& increment, const auto& one_before) {
      return terms.ring * (terms.damping * (increment + one_before).square()).sum();
    };
    const ModalCoordinates last = march.increments(i), one_before = march.increments_before(i);
    if (!march.impacts().empty()) {
      const ModalCoordinates now = march.coordinates(i), jump = march.jumps(i);
      work_ += jump_work(terms, now.real, last.real, jump.real) +
               jump_work(terms, now.imaginary, last.imaginary, jump.imaginary);
      dissipated_ += of_part(last.real - jump.real, one_before.real);
      dissipated_ += of_part(last.imaginary - jump.imaginary, one_before.imaginary);
      continue;
    }
    dissipated_ += of_part(last.real, one_before.real);
    dissipated_ += of_part(last.imaginary, one_before.imaginary);
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

}  // namespace tiprub::simulate
