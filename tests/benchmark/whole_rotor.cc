// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/whole_rotor.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace tiprub::simulate::testing {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// One real mode a standing mode, two a travelling one: Re and -Im of Y e^{i n j alpha} over all sectors, scaled to
/// unit modal mass.
Eigen::MatrixXd real_shapes(const WaveModes& wave, int sectors) {
  const Eigen::MatrixXcd& Y = wave.normal_rows;
  const Eigen::Index nodes = Y.rows(), modes = Y.cols();
  const Eigen::Index parts = wave.kind == WaveKind::travelling ? 2 : 1;
  Eigen::MatrixXd shapes(sectors * nodes, parts * modes);
  for (int j = 0; j < sectors; ++j) {
    const Eigen::MatrixXcd own =
        Y * std::polar(std::sqrt(static_cast<double>(parts) / sectors), two_pi * wave.nodal_diameter * j / sectors);
    shapes.block(j * nodes, 0, nodes, modes) = own.real();
    if (parts == 2) shapes.block(j * nodes, modes, nodes, modes) = -own.imag();
  }
  return shapes;
}

}  // namespace

WholeRotor whole_rotor(const RotorAtSpeed& rotor, const ContactLine& contact) {
  const int sectors = rotor.sector_count;
  WaveModes all;
  all.kind = WaveKind::standing;
  for (const WaveModes& wave : rotor.waves) {
    const Eigen::MatrixXd shapes = real_shapes(wave, sectors);
    const Eigen::Index before = all.omega.size(), more = shapes.cols(), modes = wave.omega.size();
    all.omega.conservativeResize(before + more);
    all.damping_ratio.conservativeResize(before + more);
    all.normal_rows.conservativeResize(shapes.rows(), before + more);
    all.omega.tail(more) = wave.omega.replicate(more / modes, 1);
    all.damping_ratio.tail(more) = wave.damping_ratio.replicate(more / modes, 1);
    all.normal_rows.rightCols(more) = shapes.cast<std::complex<double>>();
  }
  all.moving = all.omega.size();
  WholeRotor whole;
  whole.rotor = {rotor.speed, 1, {all}, {}, rotor.first_frequency, rotor.omega_max, rotor.tip_stiffness};
  whole.contact.position = contact.position.replicate(sectors, 1);
  for (int j = 0; j < sectors; ++j)
    whole.contact.position.col(1).segment(j * contact.size(), contact.size()).array() += two_pi * j / sectors;
  whole.contact.normal = contact.normal.replicate(sectors, 1);
  whole.contact.arc_length = contact.arc_length.replicate(sectors, 1);
  return whole;
}

}  // namespace tiprub::simulate::testing
