// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/rotor_at_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "cases/program/machine.h"
#include "cases/program/text.h"
#include "cases/program/units.h"
#include "reduce/model/condensation.h"
#include "reduce/model/dense_eigen.h"
#include "simulate/motion/attempt.h"

namespace tiprub::simulate {

namespace {

constexpr double zero_eigenvalue = 1e-12;  // of the largest one; a rigid-body motion, not an instability

struct Spectrum {
  Eigen::ArrayXd omega;
  Eigen::MatrixXcd modes;
};

Eigen::ArrayXd frequencies(const Eigen::VectorXd& squares, int nodal_diameter, double speed) {
  const double scale = squares.cwiseAbs().maxCoeff();
  if (squares.minCoeff() < -zero_eigenvalue * scale) {
    throw NoMotion(
        text_of("nodal diameter ", nodal_diameter, " has omega^2 = ", squares.minCoeff(), " (rad/s)^2 at ", speed,
                " rad/s: the rotor is statically unstable there, spin softening exceeds its stiffness; stay below "
                "this speed"));
  }
  return squares.array().max(0.0).sqrt();
}

Spectrum solve(const ReducedModel& model, int nodal_diameter, double speed) {
  const ModesAtSpeed modes = modes_at_speed(model, nodal_diameter, speed);
  return {frequencies(modes.omega_squared, nodal_diameter, speed), modes.shapes};
}

Eigen::MatrixXcd normal_rows(const ReducedModel& model, const Spectrum& spectrum) {
  Eigen::MatrixXcd rows(model.contact.size(), spectrum.omega.size());
  for (int k = 0; k < model.contact.size(); ++k)
    rows.row(k) = model.contact.normal.row(k) * spectrum.modes.middleRows<3>(3 * k);
  return rows;
}

Eigen::MatrixXcd sliding_rows(const ContactLine& contact, const Eigen::MatrixXcd& contact_rows) {
  Eigen::MatrixXcd rows(2 * contact.size(), contact_rows.cols());
  for (int k = 0; k < contact.size(); ++k) {
    const Eigen::Vector3d normal = contact.normal.row(k), theta = Eigen::Vector3d::UnitY();
    rows.row(2 * k) = contact_rows.row(3 * k + 1);
    rows.row(2 * k + 1) = normal.cross(theta).normalized().transpose() * contact_rows.middleRows<3>(3 * k);
  }
  return rows;
}

/// The number of modes on which friction acts, and whose motion narrows the gap to second order.
Eigen::Index sliding_modes(const Eigen::ArrayXd& omega, const ModeChoice& choice) {
  return (omega <= 2 * std::numbers::pi * choice.sliding_below).count();
}

/// Y omega^-2 Y^H over the last `count` modes.
Eigen::MatrixXcd static_compliance(const Eigen::MatrixXcd& rows, const Eigen::ArrayXd& omega, Eigen::Index count) {
  const Eigen::MatrixXcd last = rows.rightCols(count);
  const Eigen::MatrixXcd flexible = last * omega.tail(count).square().inverse().matrix().asDiagonal();
  return flexible * last.adjoint();
}

WaveModes wave_modes(const ReducedModel& model, int nodal_diameter, WaveKind kind, const Spectrum& spectrum,
                     const Damping& damping, const ModeChoice& choice) {
  const Eigen::Index all = spectrum.omega.size();
  const Eigen::Index moving = choice.count > 0 ? std::min<Eigen::Index>(choice.count, all) : all;
  const Eigen::Index held = choice.others == ModeChoice::Others::quasi_static ? all : moving;
  WaveModes wave;
  wave.nodal_diameter = nodal_diameter;
  wave.kind = kind;
  wave.moving = moving;
  wave.omega = spectrum.omega.head(held);
  wave.damping_ratio.resize(held);
  for (Eigen::Index mode = 0; mode < held; ++mode)
    wave.damping_ratio[mode] =
        damping.ratio(nodal_diameter, static_cast<int>(mode), wave.omega[mode] / (2 * std::numbers::pi));
  wave.shapes = spectrum.modes.leftCols(held);
  wave.contact_rows = wave.shapes.topRows(model.contact_dofs());
  const Eigen::MatrixXcd rows = normal_rows(model, spectrum);
  wave.normal_rows = rows.leftCols(held);
  const Eigen::MatrixXcd sliding = wave.contact_rows.leftCols(sliding_modes(wave.omega.head(moving), choice));
  wave.sliding_rows = sliding_rows(model.contact, sliding);
  if (model.contact.second_order) wave.blade_rows = model.contact.second_order->coordinates.transpose() * sliding;
  if (moving < all) wave.residual_compliance = static_compliance(rows, spectrum.omega, all - moving);
  return wave;
}

/// For real or complex matrices.
template <class Matrix>
ModesAtSpeed modes_of(const Matrix& K, const Matrix& M, const Eigen::MatrixXcd& basis, ModeParts parts) {
  if (parts == ModeParts::frequencies) return {eigenvalues(K, M), {}};
  const auto [squares, shapes] = eigenpairs(K, M);
  return {squares, basis * shapes.template cast<std::complex<double>>()};
}

Eigen::VectorXd signed_frequencies(const Eigen::VectorXd& omega_squared) {
  return omega_squared.unaryExpr(
      [](double square) { return std::copysign(std::sqrt(std::abs(square)), square) * hz_per_rad_s; });
}

}  // namespace

ModesAtSpeed modes_at_speed(const ReducedModel& model, int nodal_diameter, double speed, ModeParts parts) {
  // eq. 11: K(Omega) of this nodal diameter
  const CondensedModel condensed =
      condense(model.nodal_diameters[nodal_diameter], speed, model.contact_dofs(), model.modes_at_speed);
  if (is_standing(nodal_diameter, model.sector_count))
    return modes_of<Eigen::MatrixXd>(condensed.K.real(), condensed.M.real(), condensed.basis, parts);
  return modes_of(condensed.K, condensed.M, condensed.basis, parts);
}

RotorAtSpeed rotor_at_speed(const ReducedModel& model, double speed, const std::vector<int>& nodal_diameters,
                            const Damping& damping, const ModeChoice& modes, OtherDiameters others) {
  RotorAtSpeed rotor;
  rotor.speed = speed;
  rotor.sector_count = model.sector_count;
  double omega_min = std::numeric_limits<double>::infinity();
  Eigen::VectorXd tip_compliance = Eigen::VectorXd::Zero(model.contact.size());
  for (int n = 0; n <= model.nodal_diameter_max(); ++n) {  // eq. 12: block by block
    const bool asked = std::ranges::find(nodal_diameters, n) != nodal_diameters.end();
    if (!asked && others == OtherDiameters::unknown) continue;
    const WaveKind kind = wave_kind(n, model.sector_count);
    const Spectrum spectrum = solve(model, n, speed);
    omega_min = std::min(omega_min, spectrum.omega.minCoeff());
    const double share = static_cast<double>(wave_count(n, model.sector_count)) / model.sector_count;
    tip_compliance +=
        share *
        static_compliance(normal_rows(model, spectrum), spectrum.omega, spectrum.omega.size()).diagonal().real();
    WaveModes wave = wave_modes(model, n, kind, spectrum, damping, modes);
    if (!asked) {
      rotor.others.push_back(std::move(wave));
      continue;
    }
    rotor.waves.push_back(std::move(wave));
    rotor.omega_max = std::max(rotor.omega_max, rotor.waves.back().omega[rotor.waves.back().moving - 1]);
  }
  rotor.first_frequency = omega_min / (2 * std::numbers::pi);
  rotor.tip_stiffness = 1 / tip_compliance.minCoeff();
  return rotor;
}

double penalised_omega_max(const RotorAtSpeed& rotor, double stiffness) {
  double square = 0;
  for (const WaveModes& wave : rotor.waves) {
    Eigen::MatrixXcd sprung = stiffness * wave.normal_rows.adjoint() * wave.normal_rows;
    sprung.diagonal() += wave.omega.square().matrix().cast<std::complex<double>>();
    square = std::max(square, eigenvalues(sprung).maxCoeff());
  }
  return std::sqrt(square);
}

FrequencyTable frequency_table(const ReducedModel& model, const Damping& damping, double speed_max, int threads) {
  FrequencyTable table;
  table.speed = Eigen::VectorXd::LinSpaced(frequency_speeds, 0.0, speed_max);
  const int diameters = model.nodal_diameter_max() + 1;
  std::vector<Eigen::VectorXd> rows(static_cast<std::size_t>(diameters) * frequency_speeds);
  work_on_pieces(std::ssize(rows), 1, threads, [&](std::ptrdiff_t i, std::ptrdiff_t) {
    const double speed = table.speed[i % frequency_speeds];
    rows[static_cast<std::size_t>(i)] = signed_frequencies(
        modes_at_speed(model, static_cast<int>(i / frequency_speeds), speed, ModeParts::frequencies).omega_squared);
  });
  for (int n = 0; n < diameters; ++n) {
    const std::size_t first = static_cast<std::size_t>(n) * frequency_speeds;
    Eigen::MatrixXd& curves = table.by_nodal_diameter.emplace_back(frequency_speeds, rows[first].size());
    for (int s = 0; s < frequency_speeds; ++s) curves.row(s) = rows[first + static_cast<std::size_t>(s)];
    Eigen::MatrixXd& ratios = table.damping_ratio.emplace_back(curves.rows(), curves.cols());
    for (Eigen::Index mode = 0; mode < curves.cols(); ++mode)
      ratios.col(mode) = curves.col(mode).unaryExpr(
          [&](double frequency) { return damping.ratio(n, static_cast<int>(mode), frequency); });
  }
  return table;
}

}  // namespace tiprub::simulate
