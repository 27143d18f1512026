// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <limits>
#include <vector>

#include "reduce/model/nodal_diameter.h"
#include "reduce/model/reduced_model.h"
#include "simulate/motion/motion.h"
#include "simulate/scene/damping.h"

namespace tiprub::simulate {

/// How many modes of each nodal diameter a march keeps, and how it treats the others.
struct ModeChoice {
  enum class Others { dropped, quasi_static };

  int count = 0;  ///< the lowest ones; 0: all
  Others others = Others::dropped;
  /// [Hz] Friction acts on modes up to here, and the second order of the gap is that of their motion.
  double sliding_below = std::numeric_limits<double>::infinity();
};

/// Whether the modes of the nodal diameters that are not asked for are computed as well.
enum class OtherDiameters { known, unknown };

/// One nodal diameter at one speed, a block of the paper's eq. 12, in its own modes: u_j = Re(Phi q e^{i n j alpha}),
/// Phi^H M Phi = 1, Phi^H K Phi = omega^2. A real force f_j on the sectors acts on q as
///   Phi^H (w/N) sum_j f_j e^{-i n j alpha},  w = 1 for a standing wave, 2 for a travelling one.
struct WaveModes {
  int nodal_diameter = 0;
  WaveKind kind = WaveKind::travelling;
  Eigen::Index moving = 0;        ///< number of modes with mass; the others follow their forces without delay
  Eigen::ArrayXd omega;           ///< [rad/s], ascending; m
  Eigen::ArrayXd damping_ratio;   ///< [1] of critical; m
  Eigen::MatrixXcd contact_rows;  ///< Phi at the contact dofs; 3 n_c x m
  Eigen::MatrixXcd normal_rows;   ///< Y: normal displacement of the contact nodes by mode; n_c x m
  /// S: displacement of the contact nodes along theta, then along e_m = nu x e_theta, node by node, in the modes on
  /// which friction acts. These have mass and are resolved by the mesh; 2 n_c x m_s.
  Eigen::MatrixXcd sliding_rows;
  /// V' Phi: the coordinates of the blades in SecondOrderGap, in the same modes; p x m_s, no rows without it.
  Eigen::MatrixXcd blade_rows;
  Eigen::MatrixXcd shapes;  ///< Phi, in the model's coordinates; n x m
  /// [m/N] Y omega^-2 Y^H, the compliance of the modes that have no mass or are dropped; n_c x n_c, empty if all
  /// modes have mass.
  Eigen::MatrixXcd residual_compliance;
};

/// The model at one speed, diagonalised block by block of eq. 12. The matrix F of eq. 11 is never formed.
struct RotorAtSpeed {
  double speed = 0;               ///< [rad/s]
  int sector_count = 0;           ///< N
  std::vector<WaveModes> waves;   ///< the nodal diameters asked for
  std::vector<WaveModes> others;  ///< those not asked for, if known
  double first_frequency = 0;     ///< [Hz] the lowest of all nodal diameters that are known
  double omega_max = 0;           ///< [rad/s] the highest with mass of those asked for
  double tip_stiffness = 0;       ///< [N/m] static stiffness of the stiffest contact node, loaded by itself
};

/// The modes of one nodal diameter of the model as it is marched, condensed at the speed.
struct ModesAtSpeed {
  Eigen::VectorXd omega_squared;  ///< [rad^2/s^2], ascending; below zero where the rotor is statically unstable
  Eigen::MatrixXcd shapes;        ///< Phi, Phi^H M Phi = 1, in the model's coordinates; a standing wave's are real
};
enum class ModeParts { all, frequencies };  ///< `frequencies`: without shapes

/// Solves (K(Omega) - omega^2 M) Phi = 0, with K of eq. 11, by a dense solver. Accepts statically unstable speeds.
ModesAtSpeed modes_at_speed(const ReducedModel& model, int nodal_diameter, double speed,
                            ModeParts parts = ModeParts::all);

/// Solves one Hermitian eigenproblem for each nodal diameter. Mode m of each nodal diameter has the damping of family
/// m at its frequency. Raises NoMotion if K(Omega) has a negative eigenvalue: the rotor is then statically unstable.
RotorAtSpeed rotor_at_speed(const ReducedModel& model, double speed, const std::vector<int>& nodal_diameters,
                            const Damping& damping, const ModeChoice& modes = {},
                            OtherDiameters others = OtherDiameters::known);

/// [rad/s] The highest frequency with every contact node on a spring kappa [N/m]: the root of the largest eigenvalue
/// of omega^2 + kappa Y^H Y over the nodal diameters of the rotor, which is K + kappa C C^T in modes. With fewer
/// closed nodes it is lower (interlacing). Central differences are thus stable for h omega_max < 2, whichever nodes
/// are closed. Solves one Hermitian eigenproblem for each nodal diameter.
double penalised_omega_max(const RotorAtSpeed& rotor, double stiffness);

/// Number of speeds in the table. The squares of the frequencies are nearly polynomials in Omega^2 (eq. 11); cubics
/// between 33 speeds are exact to 1e-5 of the frequency on the wheel of the demo.
constexpr int frequency_speeds = 33;

/// The natural frequencies of the model as it is marched (modes_at_speed), at `frequency_speeds` evenly spaced speeds
/// from 0 to speed_max [rad/s]. Frequencies are negative where the rotor is statically unstable. Each speed and nodal
/// diameter costs a condensation and the eigenvalues of a dense Hermitian pencil. The result does not depend on the
/// number of threads.
FrequencyTable frequency_table(const ReducedModel& model, const Damping& damping, double speed_max, int threads);

}  // namespace tiprub::simulate
