// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// A component of a contact node's displacement.
enum class Component {
  normal,      ///< along the normal from the blade to the casing: what closes the gap
  radial,      ///< r
  tangential,  ///< theta, with the rotation
  axial,       ///< z
};

/// A displacement component of one contact node in all N sectors [m]; samples x N. The file holds the independent
/// sectors 0 .. N/g - 1; sector j moves as sector j mod (N/g).
Eigen::MatrixXd tip_motion(const SpeedResponse& response, const SimulatedScene& scene, const ContactLine& contact,
                           int node, Component component);

/// The contact force [N] of one contact node in all N sectors; samples x N.
Eigen::MatrixXd tip_force(const SpeedResponse& response, const SimulatedScene& scene, int node);

/// Half of the peak-to-peak motion, the largest over the sectors; unit of the motion.
double vibration_amplitude(const Eigen::MatrixXd& motion);

/// Two-way space-time transform of a motion u_j(t_s), j = 0 .. N-1 sectors, s = 0 .. S R - 1 samples on R whole
/// revolutions of S samples (paper, sec. 5.1.1, made directional):
///
///   X(m, n) = 1/(N S R) sum_s sum_j u_j(t_s) e^{-i 2 pi (m s/(S R) + n j/N)}
///   u_j(t_s) = sum_m sum_n Re(a_m X(m, n) e^{i (2 pi m s/(S R) + n j alpha)}),  a_0 = 1, a = 1 at S R/2, else 2
///
/// The second line is the expansion of eq. 19, with both directions; one line m of it is eq. 20. So amplitude(m,
/// n) = a_m |X(m, n)| is the amplitude of one travelling wave: engine order m/R, signed nodal diameter n in (-N/2,
/// N/2], n > 0 backward, n < 0 forward (see aliasing.h). Over whole revolutions the spectrum of a periodic motion
/// has no leakage, and that of a subharmonic motion has its lines at fractions of an engine order. A transform
/// over time only would merge lines that are close in frequency and differ in nodal diameter (frequency
/// clustering); this one keeps them apart.
struct TravellingSpectrum {
  int sector_count = 0;       ///< N
  int revolutions = 0;        ///< R
  Eigen::MatrixXd amplitude;  ///< unit of the motion; (floor(S R/2) + 1) lines x N columns, column n mod N

  int lines() const { return static_cast<int>(amplitude.rows()); }
  double engine_order(int line) const { return static_cast<double>(line) / revolutions; }
  /// Amplitude at an engine order and a signed nodal diameter; 0 where the spectrum has no such line.
  double at(double engine_order, int signed_nodal_diameter) const;
  /// Amplitudes by nodal diameter 0 .. floor(N/2), both directions added; lines x (floor(N/2) + 1).
  Eigen::MatrixXd by_nodal_diameter() const;
};

/// @param motion samples x sectors, any unit; rows on whole revolutions. Costs O(N S R log(N S R)). With
/// FFTW_ESTIMATE the plan is the same in every run, and so is the rounding.
TravellingSpectrum travelling_spectrum(const Eigen::MatrixXd& motion, int revolutions);

/// The classical spectrum of one signal over time: the amplitude of each line; floor(samples/2) + 1 lines.
Eigen::VectorXd line_spectrum(const Eigen::VectorXd& signal);

}  // namespace tiprub::postprocess
