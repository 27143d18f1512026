// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "postprocess/analysis/contact_map.h"
#include "reduce/model/reduced_model.h"

namespace tiprub {

/// How the place that an edge rubs moves around the casing with speed (paper, sec. 6.1.3): the middle of the contact
/// of a column c of the map, folded onto one lobe, theta = arg(sum c e^{i N_l theta}) / N_l, followed from speed to
/// speed, and the line theta = intercept + slope Omega through it by least squares (Boost). A contact that is passed
/// on along the blade at the wave speed v comes l/v late, l the length of the tip: then slope = l/v.
struct ContactDrift {
  Eigen::VectorXd
      angle;             ///< [rad] by speed, against the rotation positive as the casing's angle; NaN without contact
  double slope = 0;      ///< [s]
  double intercept = 0;  ///< [rad]
  double determination = 0;       ///< [1] R^2 of the line; 0 if there is none, 1 of angles all the same
  double implied_wave_speed = 0;  ///< [m/s] tip length over |slope|
};

/// Needs ascending speeds [rad/s], one for each column of the map; no line with fewer than three columns in contact.
ContactDrift contact_drift(const ContactMap& map, const Eigen::VectorXd& speeds, int lobes,
                           const ContactLine& contact);

/// How much later the leading edge meets a place of the casing than the trailing edge: the lag of its contact force,
/// in which resonances that turn the contact of both edges around the casing do not show. The circular
/// cross-correlation of the two forces over the recorded revolutions, summed over the sectors, is largest at it;
/// within half a beat of the casing (1/N_l of a revolution) of the lag that the nodes' angles give, which is taken
/// off. Its maximum lies between samples on a parabola.
struct EdgeLag {
  Eigen::VectorXd time;      ///< [s] by speed, positive: the leading edge is late; NaN unless both edges touch
  Eigen::VectorXd likeness;  ///< [1] by speed, the correlation there over the forces' norms: 1 of like forces
  double median = 0, lower_quartile = 0, upper_quartile = 0;  ///< [s] over the speeds
  /// Of the line Omega time = intercept + slope Omega by least squares: a contact passed on at the wave speed v along
  /// the tip l has slope l/v and R^2 near 1.
  double slope = 0;          ///< [s]
  double intercept = 0;      ///< [rad]
  double determination = 0;  ///< [1] R^2; 0 if there is no line
};

/// Needs a response at every speed; no line and no quartiles with fewer than three speeds at which both edges touch.
EdgeLag edge_lag(const Response& response, const ContactLine& contact);

/// What both edges of the main blade of sector 0 rub.
struct ContactMaps {
  ContactMap leading, trailing;
  ContactDrift leading_drift, trailing_drift;
  EdgeLag lag;
};
/// As contact_map() does.
ContactMaps contact_maps(const Response& response, const ContactLine& contact);

}  // namespace tiprub
