// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/speed_audit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "simulate/orbits/even_line_fit.h"

namespace tiprub {

namespace {

constexpr double seed_share = 1e-8;  // of the settled motion's modal norm
constexpr int highest_order = 60;    // of the spectra that are compared

double modal_energy(const TimeMarch& march, const std::vector<std::size_t>& waves) {
  double sum = 0;
  const double h = march.time_step();
  for (std::size_t i : waves) {
    const Eigen::ArrayXd& omega = march.wave(i).omega;
    const auto of_part = [&](const auto& q, const auto& before) {
      return ((q - before) / h).square().sum() + (omega * q).square().sum();
    };
    const ModalCoordinates now = march.coordinates(i), before = march.coordinates(i, Instant::before);
    sum += of_part(now.real, before.real);
    sum += of_part(now.imaginary, before.imaginary);
  }
  return sum;
}

/// Lower modes more than higher ones, at rest; always the same.
Eigen::VectorXcd disturbance(Eigen::Index modes, double size, WaveKind kind, std::mt19937& source) {
  const auto random = [&] { return 2.0 * source() / std::mt19937::max() - 1.0; };
  Eigen::VectorXcd q(modes);
  for (Eigen::Index m = 0; m < modes; ++m) {
    const double re = random(), im = random();
    q[m] = size / static_cast<double>((1 + m) * (1 + m)) *
           std::complex<double>(re, kind == WaveKind::travelling ? im : 0.0);
  }
  return q;
}

/// The settled waves into the whole wheel's march, and the seed into the others; the indices of these.
std::vector<std::size_t> seed_whole_wheel(const TimeMarch& settled, std::size_t held, TimeMarch& whole) {
  double norm = 0;
  for (std::size_t i = 0; i < held; ++i) {
    const Eigen::Index modes = settled.wave(i).modes();
    const Eigen::VectorXcd now = settled.coordinates(i).head(modes);
    whole.set_state(i, now, settled.coordinates(i, Instant::before).head(modes));
    norm += now.squaredNorm();
  }
  std::mt19937 source(1);
  std::vector<std::size_t> others;
  for (std::size_t i = held; i < whole.wave_count(); ++i) {
    const MarchedWave& wave = whole.wave(i);
    const Eigen::VectorXcd q = disturbance(wave.moving, seed_share * std::sqrt(norm), wave.kind, source);
    whole.set_state(i, q, q);
    others.push_back(i);
  }
  return others;
}

/// rms over the revolutions of the amplitudes of engine orders 0 .. highest; orders x columns.
Eigen::MatrixXd averaged_spectrum(const SpeedResponse& response) {
  const Eigen::Index samples = response.samples_per_revolution;
  const Eigen::Index orders = std::min<Eigen::Index>(highest_order, (samples - 1) / 2) + 1;
  Eigen::MatrixXcd waves(orders, samples);
  for (Eigen::Index m = 0; m < orders; ++m)
    for (Eigen::Index s = 0; s < samples; ++s)
      waves(m, s) = std::polar((m == 0 ? 1.0 : 2.0) / static_cast<double>(samples),
                               -2 * std::numbers::pi * static_cast<double>(m * s % samples) / samples);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(orders, response.displacement.cols());
  for (int r = 0; r < response.recorded_revolutions; ++r)
    sum += (waves * response.displacement.middleRows(r * samples, samples)).cwiseAbs2();
  return (sum / response.recorded_revolutions).cwiseSqrt();
}

/// The last period of a settled response, begun `shift` revolutions later.
Eigen::MatrixXd last_period(const SpeedResponse& response, int shift) {
  const Eigen::Index rows = static_cast<Eigen::Index>(response.period_revolutions) * response.samples_per_revolution;
  const Eigen::Index first = static_cast<Eigen::Index>(shift) * response.samples_per_revolution;
  const auto period = response.displacement.bottomRows(rows);
  Eigen::MatrixXd moved(rows, response.displacement.cols());
  moved << period.bottomRows(rows - first), period.topRows(first);
  return moved;
}

double relative(double difference, double one_norm, double other_norm) {
  const double larger = std::max(one_norm, other_norm);
  return larger > 0 ? difference / larger : 0.0;
}

}  // namespace

double compliance_condition(const TimeMarch& march) {
  const Eigen::Index nodes = march.node_count(), size = nodes * march.sectors();
  Eigen::MatrixXd dense(size, size);
  for (int row = 0; row < march.sectors(); ++row)
    for (int column = 0; column < march.sectors(); ++column)
      dense.block(row * nodes, column * nodes, nodes, nodes) =
          march.compliance().block(row * march.width(), column * march.width(), nodes, nodes);
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly).eigenvalues();
  const double floor = std::numeric_limits<double>::epsilon() * values.maxCoeff();
  return values.maxCoeff() / std::max(values.minCoeff(), floor);
}

double excluded_growth(const TimeMarch& settled, const RotorAtSpeed& rotor, const Casing& casing,
                       const ContactLine& contact, int revolutions) {
  RotorAtSpeed whole_rotor = rotor;
  whole_rotor.waves.insert(whole_rotor.waves.end(), rotor.others.begin(), rotor.others.end());
  MarchSetup setup = settled.setup();
  setup.symmetry = 1;
  TimeMarch whole(whole_rotor, casing, contact, settled.clearance(), setup);
  const std::vector<std::size_t> others = seed_whole_wheel(settled, rotor.waves.size(), whole);
  whole.set_step(settled.step_count());
  std::vector<double> logarithms;
  for (int r = 0; r < revolutions; ++r) {
    for (int i = 0; i < setup.steps_per_revolution; ++i) whole.step();
    if (2 * (r + 1) < revolutions) continue;
    logarithms.push_back(0.5 * std::log(std::max(modal_energy(whole, others), std::numeric_limits<double>::min())));
  }
  return std::exp(slope_per_place(logarithms));
}

ResponseDifference difference(const SpeedResponse& here, const SpeedResponse& there) {
  const bool alike = here.motion == there.motion && here.motion != MotionClass::irregular &&
                     here.period_revolutions == there.period_revolutions &&
                     std::min(here.recorded_revolutions, there.recorded_revolutions) >= here.period_revolutions;
  if (!alike) {
    const Eigen::MatrixXd mine = averaged_spectrum(here), spectrum = averaged_spectrum(there);
    return {relative((mine - spectrum).norm(), mine.norm(), spectrum.norm()), "spectrum"};
  }
  const Eigen::MatrixXd motion = last_period(there, 0);
  double smallest = std::numeric_limits<double>::infinity();
  for (int shift = 0; shift < here.period_revolutions; ++shift)
    smallest = std::min(smallest, (last_period(here, shift) - motion).norm());
  return {relative(smallest, last_period(here, 0).norm(), motion.norm()), "motion"};
}

}  // namespace tiprub
