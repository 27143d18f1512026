// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/time_march.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "simulate/wave_kernels.h"

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

/// Y in the two orders of the kernels; a standing wave has no imaginary part.
void lay_out_rows(const Eigen::MatrixXcd& normal_rows, std::size_t width, std::size_t modes, WaveKind kind,
                  TimeMarch::Wave& wave) {
  const std::size_t parts = kind == WaveKind::travelling ? 2 : 1;
  wave.rows.assign(parts * modes * width, 0.0);
  wave.columns.assign(parts * modes * width, 0.0);
  for (Eigen::Index m = 0; m < normal_rows.cols(); ++m)
    for (Eigen::Index k = 0; k < normal_rows.rows(); ++k) {
      const double values[2] = {normal_rows(k, m).real(), normal_rows(k, m).imag()};
      for (std::size_t part = 0; part < parts; ++part) {
        wave.rows[(m * parts + part) * width + k] = values[part];
        wave.columns[(k * parts + part) * modes + m] = values[part];
      }
    }
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
  wave.nodes = wave.forces = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(width));
  wave.cosine.resize(sectors);
  wave.sine.resize(sectors);
  for (int j = 0; j < sectors; ++j) {
    const std::complex<double> phase = sector_phase(from.nodal_diameter, j, sector_count);
    wave.cosine[j] = phase.real();
    wave.sine[j] = phase.imag();
  }
  lay_out_rows(from.normal_rows, width, modes, from.kind, wave);
  return wave;
}

}  // namespace

TimeMarch::TimeMarch(const RotorAtSpeed& rotor, const Casing& casing, const ContactLine& contact,
                     const MarchSetup& setup)
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
  const auto size = static_cast<Eigen::Index>(sectors_ * width_);
  gap_ = gap_before_ = Eigen::VectorXd::Constant(size, std::numeric_limits<double>::infinity());
  for (Eigen::VectorXd& displacement : displacement_) displacement = Eigen::VectorXd::Zero(size);
  clearance_ = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(width_), std::numeric_limits<double>::infinity());
  clearance_.head(node_count_) = casing.running_clearance(contact, rotor.speed);
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
  Wave& at = waves_[wave];
  at.q.head(q.size()) = q.real();
  at.q.segment(at.modes(), q.size()) = q.imag();
  at.before.head(q.size()) = before.real();
  at.before.segment(at.modes(), q.size()) = before.imag();
  map_to_nodes();
  measure_gaps();
}

void TimeMarch::set_revolutions(int revolutions) {
  step_ = static_cast<std::int64_t>(revolutions) * setup_.steps_per_revolution;
  measure_gaps();
}

void TimeMarch::map_to_nodes() {
  displacement_[0].setZero();
  for (Wave& wave : waves_) {
    const auto modes = static_cast<std::size_t>(wave.modes()), moving = static_cast<std::size_t>(wave.moving);
    if (wave.kind == WaveKind::travelling)
      kernels::to_nodes_travelling(wave.rows.data(), wave.q.data(), wave.q.data() + modes, moving, width_,
                                   wave.nodes.data(), wave.nodes.data() + width_);
    else
      kernels::to_nodes_standing(wave.rows.data(), wave.q.data(), moving, width_, wave.nodes.data());
    for (int j = 0; j < sectors_; ++j)
      kernels::add_wave(wave.nodes.data(), wave.nodes.data() + width_, wave.cosine[j], wave.sine[j], width_,
                        displacement_[0].data() + j * width_);
  }
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

bool TimeMarch::predict() {
  displacement_[2].swap(displacement_[1]);
  displacement_[1].swap(displacement_[0]);
  gap_before_.swap(gap_);
  for (Wave& wave : waves_) {
    const auto modes = static_cast<std::size_t>(wave.modes()), moving = static_cast<std::size_t>(wave.moving);
    const double* a = wave.coefficients.a.data();
    const double* b = wave.coefficients.b.data();
    wave.two_before.swap(wave.before);
    wave.before.swap(wave.q);  // wave.q now holds what is overwritten: the oldest instant
    kernels::advance(a, b, wave.before.data(), wave.two_before.data(), wave.q.data(), moving);
    if (wave.kind == WaveKind::travelling)
      kernels::advance(a, b, wave.before.data() + modes, wave.two_before.data() + modes, wave.q.data() + modes,
                       moving);
    if (moving == modes) continue;
    wave.q.segment(wave.moving, wave.modes() - wave.moving).setZero();
    wave.q.tail(wave.modes() - wave.moving).setZero();
  }
  map_to_nodes();
  ++step_;
  return measure_gaps();
}

void TimeMarch::correct_modes(const Eigen::VectorXd& forces, const std::vector<int>& nodes) {
  const auto width = static_cast<int>(width_);
  closed_nodes_.clear();
  for (int index : nodes) closed_nodes_.push_back(index % width);
  std::sort(closed_nodes_.begin(), closed_nodes_.end());
  closed_nodes_.erase(std::unique(closed_nodes_.begin(), closed_nodes_.end()), closed_nodes_.end());
  for (Wave& wave : waves_) {
    const auto modes = static_cast<std::size_t>(wave.modes());
    const double share = wave.weight * setup_.symmetry / sector_count_;
    wave.forces.setZero();
    for (int index : nodes) {
      const int j = index / width, k = index % width;
      wave.forces[k] += share * wave.cosine[j] * forces[index];
      wave.forces[width + k] -= share * wave.sine[j] * forces[index];
    }
    if (wave.kind == WaveKind::travelling)
      kernels::add_force_travelling(wave.columns.data(), wave.coefficients.c.data(), wave.forces.data(),
                                    wave.forces.data() + width, closed_nodes_.data(), closed_nodes_.size(), modes,
                                    wave.q.data(), wave.q.data() + modes);
    else
      kernels::add_force_standing(wave.columns.data(), wave.coefficients.c.data(), wave.forces.data(),
                                  closed_nodes_.data(), closed_nodes_.size(), modes, wave.q.data());
  }
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
