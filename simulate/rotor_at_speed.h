// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "reduce/reduced_model.h"

namespace tiprub {

/// Whether a nodal diameter's wave travels (complex) or stands (real: n = 0 and n = N/2).
enum class WaveKind { travelling, standing };

/// One nodal diameter at one speed in its own modes: u_j = Re(Phi q e^{i n j alpha}), Phi^H M Phi = 1,
/// Phi^H K Phi = omega^2. A real force f_j on the sectors acts on q as
///   Phi^H (w/N) sum_j f_j e^{-i n j alpha},  w = 1 for a standing wave, 2 for a travelling one.
struct WaveModes {
  int nodal_diameter = 0;
  WaveKind kind = WaveKind::travelling;
  Eigen::ArrayXd omega;           ///< [rad/s], ascending; m
  Eigen::ArrayXd damping_ratio;   ///< [1] of critical; m
  Eigen::MatrixXcd contact_rows;  ///< Phi at the contact dofs; 3 n_c x m
  Eigen::MatrixXcd normal_rows;   ///< Y: normal displacement of the contact nodes by mode; n_c x m

  double weight() const { return kind == WaveKind::standing ? 1.0 : 2.0; }
};

/// The model at one speed, diagonalised.
struct RotorAtSpeed {
  double speed = 0;              ///< [rad/s]
  int sector_count = 0;          ///< N
  std::vector<WaveModes> waves;  ///< the nodal diameters asked for
  double first_frequency = 0;    ///< [Hz] the lowest of all nodal diameters, asked for or not
  double omega_max = 0;          ///< [rad/s] the highest of those asked for
};

/// Solves one Hermitian eigenproblem a nodal diameter (n^3 once a speed, against millions of steps). Damping is by
/// family: mode m of each nodal diameter takes damping_ratios[m], the last one holds for the rest.
/// Raises RunError if K(Omega) has a negative eigenvalue: the rotor at this speed has no stable shape.
RotorAtSpeed rotor_at_speed(const ReducedModel& model, double speed, const std::vector<int>& nodal_diameters,
                            const std::vector<double>& damping_ratios);

}  // namespace tiprub
