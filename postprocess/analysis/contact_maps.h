// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <limits>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// Where around the casing one contact node of sector 0 rubs, at each speed (paper, sec. 5.2.2).
struct ContactMap {
  /// [1] The share in contact of the steps that the node begins over an area: 0 never, 1 always; areas x speeds.
  /// The counts of the file are divided by the node's own number of steps over that area (steps_over_areas()). If
  /// the number of areas does not divide the number of steps, dividing by the mean, steps / areas, would give
  /// shares above 1 and stripes.
  Eigen::MatrixXd share;
  Eigen::VectorXd contrast;  ///< [1] by speed, see contact_contrast()
  Eigen::VectorXi clusters;  ///< by speed, see contact_clusters()
};

/// How uneven a column of the map is: 1 - (sum c)^2 / (A sum c^2) over its A areas. It is 0 where the contact is the
/// same everywhere, 1 - 1/A where only one area is touched, and 0 without contact.
double contact_contrast(const Eigen::VectorXd& column);

/// How many separate places are rubbed. A place is a run of neighbouring areas with at least half of the largest
/// value; two runs with a single area between them count as one.
int contact_clusters(const Eigen::VectorXd& column);

/// The map of a contact node. Requires a response at every speed, and the same areas at all speeds.
ContactMap contact_map(const Response& response, const ContactLine& contact, int node);

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A line y = intercept + slope x, fitted by least squares (Boost); NaN where there is none.
struct FittedLine {
  double intercept = unknown, slope = unknown;
  double determination = unknown;  ///< [1] R^2
};

/// How the contact of an edge moves around the casing with speed (paper, sec. 6.1.3). The middle of the contact of
/// a column c of the map, folded onto one lobe, is theta = arg(sum c e^{i N_l theta}) / N_l. It is followed from
/// speed to speed, and the line theta = intercept + slope Omega is fitted to it. Contact that travels along a tip of
/// length l at the wave speed v arrives l/v later: then slope = l/v.
struct ContactDrift {
  Eigen::VectorXd angle;  ///< [rad] by speed, in the direction of the casing's angle; NaN without contact
  FittedLine line;        ///< [rad, s] of the angle over the speed
  double implied_wave_speed = unknown;  ///< [m/s] tip length over |slope|; NaN without a line
};

/// Needs ascending speeds [rad/s], one for each column of the map. Fits a line if three columns or more have contact.
ContactDrift contact_drift(const ContactMap& map, const Eigen::VectorXd& speeds, int lobes,
                           const ContactLine& contact);

/// The time by which the contact force at the leading edge lags behind that at the trailing edge, at the same
/// place of the casing. A resonance that shifts the contact of both edges around the casing does not change this
/// lag. It is the shift at which the circular cross-correlation of the two forces, over the recorded revolutions
/// and summed over the sectors, is largest. The search covers half a beat (1/N_l of a revolution) around the lag
/// due to the nodes' angles, which is subtracted. A parabola gives the maximum between samples.
struct EdgeLag {
  Eigen::VectorXd time;      ///< [s] by speed, positive if the leading edge is late; NaN unless both edges touch
  Eigen::VectorXd likeness;  ///< [1] by speed: this correlation over the norms of the forces; 1 for equal forces
  // NaN at fewer than three speeds
  double median = unknown, lower_quartile = unknown, upper_quartile = unknown;  ///< [s] over the speeds
  /// [rad, s] Omega time over Omega. Contact that travels along a tip of length l at the wave speed v gives slope l/v
  /// and R^2 near 1.
  FittedLine line{};
};

/// Needs a response at every speed. The line and the quartiles need three speeds at which both edges touch.
EdgeLag edge_lag(const Response& response, const ContactLine& contact);

/// Where both edges of the main blade of sector 0 rub.
struct ContactMaps {
  ContactMap leading, trailing;
  ContactDrift leading_drift, trailing_drift;
  EdgeLag lag;
};
ContactMaps contact_maps(const Response& response, const ContactLine& contact);

}  // namespace tiprub::postprocess
