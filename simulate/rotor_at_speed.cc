// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/rotor_at_speed.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "cases/errors.h"

namespace tiprub {

namespace {

constexpr double zero_eigenvalue = 1e-12;  // of the largest one: a free motion, not an instability

struct Spectrum {
  Eigen::ArrayXd omega;
  Eigen::MatrixXcd modes;
};

Eigen::ArrayXd frequencies(const Eigen::VectorXd& squares, int nodal_diameter, double speed) {
  const double scale = squares.cwiseAbs().maxCoeff();
  if (squares.minCoeff() < -zero_eigenvalue * scale) {
    std::ostringstream text;
    text << "nodal diameter " << nodal_diameter << " has omega^2 = " << squares.minCoeff() << " (rad/s)^2 at "
         << speed << " rad/s: the rotor is statically unstable there, spin softening beats its stiffness; stay below "
         << "this speed";
    throw RunError(text.str());
  }
  return squares.array().max(0.0).sqrt();
}

/// A standing wave's matrices are real, and so are its modes.
Spectrum solve(const NodalDiameterModel& model, int nodal_diameter, WaveKind kind, double speed) {
  const Eigen::MatrixXcd stiffness = model.stiffness(speed);
  if (kind == WaveKind::standing) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness.real(), model.M.real());
    return {frequencies(solver.eigenvalues(), nodal_diameter, speed),
            solver.eigenvectors().cast<std::complex<double>>()};
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> solver(stiffness, model.M);
  return {frequencies(solver.eigenvalues(), nodal_diameter, speed), solver.eigenvectors()};
}

WaveModes wave_modes(const ReducedModel& model, int nodal_diameter, WaveKind kind, const Spectrum& spectrum,
                     const std::vector<double>& damping_ratios) {
  WaveModes wave;
  wave.nodal_diameter = nodal_diameter;
  wave.kind = kind;
  wave.omega = spectrum.omega;
  wave.damping_ratio.resize(spectrum.omega.size());
  for (Eigen::Index mode = 0; mode < spectrum.omega.size(); ++mode)
    wave.damping_ratio[mode] = damping_ratios[std::min<std::size_t>(mode, damping_ratios.size() - 1)];
  wave.contact_rows = spectrum.modes.topRows(model.contact_dofs());
  wave.normal_rows.resize(model.contact.size(), spectrum.omega.size());
  for (int k = 0; k < model.contact.size(); ++k)
    wave.normal_rows.row(k) = model.contact.normal.row(k) * wave.contact_rows.middleRows<3>(3 * k);
  return wave;
}

}  // namespace

RotorAtSpeed rotor_at_speed(const ReducedModel& model, double speed, const std::vector<int>& nodal_diameters,
                            const std::vector<double>& damping_ratios) {
  RotorAtSpeed rotor;
  rotor.speed = speed;
  rotor.sector_count = model.sector_count;
  double omega_min = std::numeric_limits<double>::infinity();
  for (int n = 0; n <= model.nodal_diameter_max(); ++n) {
    const WaveKind kind = n == 0 || 2 * n == model.sector_count ? WaveKind::standing : WaveKind::travelling;
    const Spectrum spectrum = solve(model.nodal_diameters[n], n, kind, speed);
    omega_min = std::min(omega_min, spectrum.omega.minCoeff());
    if (std::find(nodal_diameters.begin(), nodal_diameters.end(), n) == nodal_diameters.end()) continue;
    rotor.omega_max = std::max(rotor.omega_max, spectrum.omega.maxCoeff());
    rotor.waves.push_back(wave_modes(model, n, kind, spectrum, damping_ratios));
  }
  rotor.first_frequency = omega_min / (2 * std::numbers::pi);
  return rotor;
}

}  // namespace tiprub
