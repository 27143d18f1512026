// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/orbits/speed_audit.h"

#include <algorithm>
#include <complex>
#include <limits>
#include <numbers>

#include "reduce/model/dense_eigen.h"

namespace tiprub::simulate {

namespace {

constexpr int highest_order = 60;  // of the spectra that are compared

/// The rms over the revolutions of the amplitudes of engine orders 0 .. highest_order; orders x columns.
Eigen::MatrixXd averaged_spectrum(const SampledMotion& motion) {
  const Eigen::Index samples = motion.samples_per_revolution;
  const Eigen::Index orders = std::min<Eigen::Index>(highest_order, (samples - 1) / 2) + 1;
  Eigen::MatrixXcd waves(orders, samples);
  for (Eigen::Index m = 0; m < orders; ++m)
    for (Eigen::Index s = 0; s < samples; ++s)
      waves(m, s) = std::polar((m == 0 ? 1.0 : 2.0) / static_cast<double>(samples),
                               -2 * std::numbers::pi * static_cast<double>(m * s % samples) / samples);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(orders, motion.displacement.cols());
  for (int r = 0; r < motion.recorded_revolutions; ++r)
    sum += (waves * motion.displacement.middleRows(r * samples, samples)).cwiseAbs2();
  return (sum / motion.recorded_revolutions).cwiseSqrt();
}

/// The last period of a settled motion, shifted cyclically by `first` samples.
Eigen::MatrixXd last_period(const SampledMotion& motion, Eigen::Index first) {
  const Eigen::Index rows = static_cast<Eigen::Index>(motion.period_revolutions) * motion.samples_per_revolution;
  const auto period = motion.displacement.bottomRows(rows);
  Eigen::MatrixXd moved(rows, motion.displacement.cols());
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
  const Eigen::VectorXd values = eigenvalues(dense);
  const double floor = std::numeric_limits<double>::epsilon() * values.maxCoeff();
  return values.maxCoeff() / std::max(values.minCoeff(), floor);
}

MotionDifference difference(const SampledMotion& here, const SampledMotion& there, int lobes) {
  const bool alike = here.period_revolutions > 0 && here.period_revolutions == there.period_revolutions &&
                     std::min(here.recorded_revolutions, there.recorded_revolutions) >= here.period_revolutions;
  if (!alike) {
    const Eigen::MatrixXd mine = averaged_spectrum(here), spectrum = averaged_spectrum(there);
    return {relative((mine - spectrum).norm(), mine.norm(), spectrum.norm()), MotionMeasure::spectrum};
  }
  const Eigen::MatrixXd motion = last_period(there, 0);
  double smallest = std::numeric_limits<double>::infinity();
  for (int beat = 0; beat < here.period_revolutions * lobes; ++beat)
    smallest = std::min(smallest, (last_period(here, beat * here.samples_per_revolution / lobes) - motion).norm());
  return {relative(smallest, last_period(here, 0).norm(), motion.norm()), MotionMeasure::motion};
}

}  // namespace tiprub::simulate
