// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/simulate/one_sector.h"
#include "tests/simulate/synthetic_wheel.h"

namespace tiprub::simulate::testing {

inline constexpr double radius = 0.1;  // m, of one_sector()

/// A mode of one blade with one contact node: how far it moves the tip along its normal, theta, and the tip line.
struct Mode {
  double omega, normal, theta, tip_line;  ///< [rad/s], [1/sqrt(kg)]
};

inline RotorAtSpeed rotor_of_modes(const std::vector<Mode>& modes, double speed, double damping_ratio = 0) {
  RotorAtSpeed rotor;
  rotor.speed = speed;
  rotor.sector_count = 1;
  const auto count = static_cast<Eigen::Index>(modes.size());
  WaveModes wave;
  wave.kind = WaveKind::standing;
  wave.moving = count;
  wave.omega.resize(count);
  wave.damping_ratio = Eigen::ArrayXd::Constant(count, damping_ratio);
  wave.normal_rows.resize(1, count);
  wave.sliding_rows.resize(2, count);
  for (Eigen::Index m = 0; m < count; ++m) {
    const Mode& mode = modes[static_cast<std::size_t>(m)];
    wave.omega[m] = mode.omega;
    wave.normal_rows(0, m) = mode.normal;
    wave.sliding_rows.col(m) << mode.theta, mode.tip_line;
  }
  wave.contact_rows = Eigen::MatrixXcd::Zero(3, count);
  wave.shapes = Eigen::MatrixXcd::Identity(count, count);
  rotor.waves.push_back(wave);
  return rotor;
}

inline MarchSetup rubbing(Scheme scheme, int steps, double friction) {
  MarchSetup setup{scheme, ContactRule::complementarity, steps};
  if (friction > 0) setup.friction = Eigen::VectorXd::Constant(1, friction);
  return setup;
}

/// The blade against a casing with a clearance [m], negative if it presses at rest.
inline TimeMarch blade(const RotorAtSpeed& rotor, const Casing& casing, double clearance, const MarchSetup& setup) {
  return march_of(rotor, casing, one_sector().contact, Eigen::VectorXd::Constant(1, clearance), setup);
}

}  // namespace tiprub::simulate::testing
