// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/energy_audit.h"

#include <algorithm>
#include <cmath>

#include "reduce/model/nodal_diameter.h"

namespace tiprub::simulate {

namespace {

/// The work of the drag of forces on some nodes of the whole wheel while the modes on which friction acts move.
double drag_work(const TimeMarch& march, const std::vector<Eigen::VectorXcd>& moved, const Eigen::VectorXd& forces,
                 const std::vector<int>& nodes) {
  double work = 0;
  for (std::size_t i = 0; i < march.wave_count(); ++i) {
    const Eigen::VectorXcd slides = march.rotor().waves[i].sliding_rows * moved[i];
    for (const int index : nodes) {
      const int sector = index / march.width(), node = index % march.width();
      const std::complex<double> phase = sector_phase(march.wave(i).nodal_diameter, sector, march.sector_count());
      const Eigen::Vector2d slide = (phase * slides.segment<2>(2 * node)).real();
      work -= forces[index] * march.drag_ratio().segment<2>(2 * index).dot(slide);
    }
  }
  return march.symmetry() * work;
}

}  // namespace

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
  work_ += march.symmetry() * march.contact_work();
  if (march.has_friction() && !march.contact().closed().empty()) observe_drag(march);
  observe_left_out(march);
}

/// The work of impulses is that of their jump, jump_work(), which holds the drag's part.
void EnergyAudit::observe_drag(const TimeMarch& march) {
  std::vector<Eigen::VectorXcd> moved, moved_by_impulses;
  const bool struck = !march.impacts().empty();
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Eigen::Index modes = march.rotor().waves[i].sliding_rows.cols();
    const Eigen::VectorXcd last = march.increments(i).head(modes);
    moved.emplace_back((last + march.increments_before(i).head(modes)) / 2);
    if (!struck) continue;
    const Eigen::VectorXcd jump = march.jumps(i).head(modes), now = march.coordinates(i).head(modes);
    moved.back() -= jump / 2;
    const auto head = [&](const Eigen::ArrayXd& values) { return values.head(modes).matrix().asDiagonal(); };
    moved_by_impulses.emplace_back(head(march.wave(i).coefficients.c) *
                                   (head(terms_[i].inertia) * (2 * last - jump) - head(terms_[i].stiffness) * now));
  }
  const double work = drag_work(march, moved, march.contact().multipliers(), march.contact().closed());
  work_ += work;
  drag_work_ += work;
  if (struck) drag_work_ += drag_work(march, moved_by_impulses, march.impulses(), march.contact().closed());
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
  ledger.drag_work = drag_work_;
  ledger.dissipated = dissipated_;
  ledger.energy_change = energy(march) - start_;
  const double scale = std::max({std::abs(work_), std::abs(dissipated_), std::abs(ledger.energy_change)});
  if (scale > 0) ledger.closing_error = (work_ - dissipated_ - ledger.energy_change) / scale;
  return ledger;
}

}  // namespace tiprub::simulate
