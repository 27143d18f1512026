// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/time_march.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "simulate/march/wave_kernels.h"

namespace tiprub {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

Eigen::Index padded(Eigen::Index count, std::size_t block) {
  const auto unit = static_cast<Eigen::Index>(block);
  return (count + unit - 1) / unit * unit;
}

Eigen::ArrayXd padded(const Eigen::ArrayXd& values, Eigen::Index size) {
  Eigen::ArrayXd longer = Eigen::ArrayXd::Zero(size);
  longer.head(values.size()) = values;
  return longer;
}

/// e^{i n j alpha} with the angle reduced in whole numbers, so that it is exactly periodic in j.
std::complex<double> sector_phase(int nodal_diameter, int sector, int sector_count) {
  const auto turn = static_cast<double>(static_cast<std::int64_t>(nodal_diameter) * sector % sector_count);
  return std::polar(1.0, two_pi * turn / sector_count);
}

/// Y in the order of the kernels; a standing wave has no imaginary part.
kernels::Lines lay_out_shapes(const Eigen::MatrixXcd& normal_rows, Eigen::Index modes, WaveKind kind) {
  const std::size_t parts = kind == WaveKind::travelling ? 2 : 1, block = kernels::mode_block;
  const auto nodes = static_cast<std::size_t>(normal_rows.rows());
  kernels::Lines shapes(parts * nodes * modes);
  for (std::size_t m = 0; m < static_cast<std::size_t>(normal_rows.cols()); ++m)
    for (std::size_t k = 0; k < nodes; ++k) {
      const std::complex<double> value = normal_rows(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(m));
      const std::size_t at = ((m / block * nodes + k) * parts) * block + m % block;
      shapes[at] = value.real();
      if (parts == 2) shapes[at + block] = value.imag();
    }
  return shapes;
}

std::unique_ptr<ContactLaw> contact_law(const MarchSetup& setup, const Eigen::MatrixXd& compliance) {
  if (setup.scheme == Scheme::moreau_jean) return velocity_contact(compliance, setup.theta);
  if (setup.scheme == Scheme::penalty) return penalty_contact(compliance, setup.penalty_stiffness);
  return position_contact(compliance, setup.contact);
}

TimeMarch::Wave lay_out(const WaveModes& from, const SchemeOptions& scheme, double step, std::size_t width,
                        int sectors, int sector_count) {
  TimeMarch::Wave wave;
  const Eigen::Index modes = padded(from.omega.size(), kernels::mode_block);
  wave.nodal_diameter = from.nodal_diameter;
  wave.kind = from.kind;
  wave.weight = from.weight();
  wave.omega = padded(from.omega, modes);
  wave.moving = padded(from.moving, kernels::mode_block);
  const StepCoefficients unpadded = step_coefficients(scheme, from.omega, from.damping_ratio, step, from.moving);
  wave.coefficients = {padded(unpadded.a, modes), padded(unpadded.b, modes), padded(unpadded.c, modes)};
  wave.q = wave.before = wave.two_before = Eigen::VectorXd::Zero(2 * modes);
  wave.forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(width));
  wave.cosine.resize(sectors);
  wave.sine.resize(sectors);
  for (int j = 0; j < sectors; ++j) {
    const std::complex<double> phase = sector_phase(from.nodal_diameter, j, sector_count);
    wave.cosine[j] = phase.real();
    wave.sine[j] = phase.imag();
  }
  wave.shapes = lay_out_shapes(from.normal_rows, modes, from.kind);
  return wave;
}

}  // namespace

TimeMarch::TimeMarch(const RotorAtSpeed& rotor, const Casing& casing, const ContactLine& contact,
                     const Eigen::VectorXd& clearance, const MarchSetup& setup)
    : setup_(setup),
      sector_count_(rotor.sector_count),
      sectors_(rotor.sector_count / setup.symmetry),
      node_count_(contact.size()),
      width_(padded(contact.size(), kernels::lane_count)),
      time_step_(two_pi / rotor.speed / setup.steps_per_revolution),
      casing_(casing) {
  const SchemeOptions scheme{setup.scheme, setup.theta, setup.penalty_stiffness};
  for (const WaveModes& wave : rotor.waves)
    waves_.push_back(lay_out(wave, scheme, time_step_, width_, sectors_, sector_count_));
  for (int j = 0; j < sectors_; ++j)
    for (const Wave& wave : waves_)
      phases_of_sectors_.insert(phases_of_sectors_.end(), {wave.cosine[j], wave.sine[j]});
  p_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * waves_.size() * width_));
  const auto size = static_cast<Eigen::Index>(sectors_ * width_);
  gap_ = gap_before_ = Eigen::VectorXd::Constant(size, std::numeric_limits<double>::infinity());
  for (Eigen::VectorXd& displacement : displacement_) displacement = Eigen::VectorXd::Zero(size);
  clearance_ = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(width_), std::numeric_limits<double>::infinity());
  clearance_.head(node_count_) = clearance;
  build_distortion(casing, contact);
  build_compliance(rotor);
  contact_ = contact_law(setup, compliance_);
  measure_gaps();
}

/// W = sum over n of Re(Y c Y^H e^{i n (j - j') alpha}) w_n g / N.
void TimeMarch::build_compliance(const RotorAtSpeed& rotor) {
  const auto width = static_cast<Eigen::Index>(width_);
  compliance_ = Eigen::MatrixXd::Zero(sectors_ * width, sectors_ * width);
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const Eigen::MatrixXcd& Y = rotor.waves[i].normal_rows;
    const Eigen::MatrixXcd own = Y * waves_[i].coefficients.c.head(Y.cols()).matrix().asDiagonal() * Y.adjoint() *
                                 (waves_[i].weight * setup_.symmetry / sector_count_);
    for (int row = 0; row < sectors_; ++row)
      for (int column = 0; column < sectors_; ++column) {
        const int apart = (row - column + sector_count_) % sector_count_;
        compliance_.block(row * width, column * width, node_count_, node_count_) +=
            (own * sector_phase(waves_[i].nodal_diameter, apart, sector_count_)).real();
      }
  }
  const Eigen::MatrixXd transposed = compliance_.transpose();
  compliance_ = 0.5 * (compliance_ + transposed);
}

void TimeMarch::build_distortion(const Casing& casing, const ContactLine& contact) {
  phases_ = setup_.steps_per_revolution / casing.lobes;
  distortion_.assign(phases_ * width_, 0.0);
  for (std::int64_t phase = 0; phase < phases_; ++phase)
    for (int k = 0; k < node_count_; ++k)
      distortion_[phase * width_ + k] = casing.distortion(
          contact.position(k, 1) + two_pi * static_cast<double>(phase) / setup_.steps_per_revolution);
}

void TimeMarch::set_state(std::size_t wave, const Eigen::VectorXcd& q, const Eigen::VectorXcd& before) {
  settle_modes();
  Wave& at = waves_[wave];
  at.q.head(q.size()) = q.real();
  at.q.segment(at.modes(), q.size()) = q.imag();
  at.before.head(q.size()) = before.real();
  at.before.segment(at.modes(), q.size()) = before.imag();
  for (std::size_t i = 0; i < waves_.size(); ++i) map_to_nodes(i);
  map_to_sectors();
  measure_gaps();
}

void TimeMarch::set_step(std::int64_t step) {
  step_ = step;
  measure_gaps();
}

void TimeMarch::map_to_nodes(std::size_t index) {
  const Wave& wave = waves_[index];
  const auto modes = static_cast<std::size_t>(wave.modes()), moving = static_cast<std::size_t>(wave.moving);
  const auto nodes = static_cast<std::size_t>(node_count_);
  double* p = p_.data() + 2 * index * width_;
  if (wave.kind == WaveKind::travelling)
    kernels::to_nodes_travelling(wave.shapes.data(), wave.q.data(), wave.q.data() + modes, moving, nodes, p,
                                 p + width_);
  else
    kernels::to_nodes_standing(wave.shapes.data(), wave.q.data(), moving, nodes, p);
}

void TimeMarch::map_to_sectors() {
  for (int j = 0; j < sectors_; ++j)
    kernels::add_waves(p_.data(), phases_of_sectors_.data() + 2 * waves_.size() * j, waves_.size(), width_,
                       displacement_[0].data() + j * width_);
}

bool TimeMarch::measure_gaps() {
  const double ramp = casing_.ramp(static_cast<double>(step_) / setup_.steps_per_revolution);
  bool penetrates = false;
  for (int j = 0; j < sectors_; ++j) {
    const std::int64_t phase =
        (step_ + static_cast<std::int64_t>(j) * (setup_.steps_per_revolution / sector_count_)) % phases_;
    penetrates |= kernels::gap_of_sector(clearance_.data(), distortion_.data() + phase * width_, ramp,
                                         displacement_[0].data() + j * width_, width_, gap_.data() + j * width_);
  }
  return penetrates;
}

void TimeMarch::advance(Wave& wave) {
  const auto modes = static_cast<std::size_t>(wave.modes()), moving = static_cast<std::size_t>(wave.moving);
  const double* a = wave.coefficients.a.data();
  const double* b = wave.coefficients.b.data();
  wave.two_before.swap(wave.before);
  wave.before.swap(wave.q);  // wave.q now holds what is overwritten: the oldest instant
  kernels::advance(a, b, wave.before.data(), wave.two_before.data(), wave.q.data(), moving);
  if (wave.kind == WaveKind::travelling)
    kernels::advance(a, b, wave.before.data() + modes, wave.two_before.data() + modes, wave.q.data() + modes, moving);
  if (moving == modes) return;
  wave.q.segment(wave.moving, wave.modes() - wave.moving).setZero();
  wave.q.tail(wave.modes() - wave.moving).setZero();
}

bool TimeMarch::predict() {
  displacement_[2].swap(displacement_[1]);
  displacement_[1].swap(displacement_[0]);
  gap_before_.swap(gap_);
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    if (forces_wait_) add_forces(waves_[i]);
    advance(waves_[i]);
    map_to_nodes(i);
  }
  forces_wait_ = false;
  map_to_sectors();
  ++step_;
  return measure_gaps();
}

void TimeMarch::add_forces(Wave& wave) const {
  const auto modes = static_cast<std::size_t>(wave.modes());
  const kernels::ForcedNodes forced{forced_nodes_.data(), forced_nodes_.size(),
                                    static_cast<std::size_t>(node_count_)};
  if (wave.kind == WaveKind::travelling)
    kernels::add_force_travelling(wave.shapes.data(), wave.coefficients.c.data(), wave.forces.data(),
                                  wave.forces.data() + width_, forced, modes, wave.q.data(), wave.q.data() + modes);
  else
    kernels::add_force_standing(wave.shapes.data(), wave.coefficients.c.data(), wave.forces.data(), forced, modes,
                                wave.q.data());
}

void TimeMarch::settle_modes() const {
  if (!forces_wait_) return;
  for (Wave& wave : waves_) add_forces(wave);
  forces_wait_ = false;
}

void TimeMarch::correct_modes(const Eigen::VectorXd& forces, const std::vector<int>& nodes) {
  settle_modes();
  const auto width = static_cast<int>(width_);
  forced_sectors_.clear();
  forced_nodes_.clear();
  node_has_force_.assign(width_, 0);
  for (int index : nodes) {  // ascending
    const int sector = index / width;
    if (forced_sectors_.empty() || forced_sectors_.back() != sector) forced_sectors_.push_back(sector);
    node_has_force_[index - sector * width] = 1;
  }
  for (int k = 0; k < node_count_; ++k)
    if (node_has_force_[k]) forced_nodes_.push_back(k);
  for (Wave& wave : waves_) {
    kernels::gather_sectors(forces.data(), wave.cosine.data(), wave.sine.data(), forced_sectors_.data(),
                            forced_sectors_.size(), width_, wave.forces.data(), wave.forces.data() + width_);
    wave.forces *= wave.weight * setup_.symmetry / sector_count_;
  }
  forces_wait_ = true;
}

void TimeMarch::correct(const Eigen::VectorXd& forces, const std::vector<int>& nodes) {
  for (int index : nodes) {
    displacement_[0].noalias() -= forces[index] * compliance_.col(index);
    gap_.noalias() += forces[index] * compliance_.col(index);
  }
  correct_modes(forces, nodes);
}

void TimeMarch::step() {
  const bool penetrates = predict();
  if (!contact_->step(gap_before_, gap_, penetrates)) return;
  displacement_[0] -= contact_->correction();
  correct_modes(contact_->multipliers(), contact_->closed());
}

}  // namespace tiprub
