// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/energy_audit.h"

#include <algorithm>
#include <cmath>

namespace tiprub {

EnergyAudit::EnergyAudit(const TimeMarch& march) {
  for (const TimeMarch::Wave& wave : march.waves()) {
    const auto& [a, b, c] = wave.coefficients;
    const auto moves = c > 0;
    const Eigen::ArrayXd divisor = moves.select(c, 1.0);
    terms_.push_back({march.sector_count() / wave.weight, moves.select((1 + b) / (4 * divisor), 0.0),
                      0.5 * wave.omega.square(), moves.select((1 - b) / (4 * divisor), 0.0)});
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
