// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "reduce/model/reduced_model.h"
#include "simulate/response/response.h"

namespace tiprub {

/// Where around the casing one contact node of sector 0 rubs, over speed (paper, sec. 5.2.2).
struct ContactMap {
  /// [1] share of the steps that the node begins over an area that are in contact: 0 never, 1 always; areas x speeds.
  /// A count of the file over the node's own steps there (steps_over_areas()) in all recorded revolutions: their
  /// mean, steps / areas, would give shares above 1, and stripes, wherever the areas don't divide the steps.
  Eigen::MatrixXd share;
  Eigen::VectorXd contrast;  ///< [1] by speed, see contact_contrast()
  Eigen::VectorXi clusters;  ///< by speed, see contact_clusters()
};

/// How uneven a column of the map is: 1 - (sum c)^2 / (A sum c^2) over its A areas, the share of the circumference
/// that the contact leaves out. 0: the same everywhere (a grey column); 1 - 1/A: one area only (a sharp one). A
/// column without contact has 0.
double contact_contrast(const Eigen::VectorXd& column);

/// How many separate places are rubbed: runs of areas around the casing that hold at least half of the largest value;
/// runs that only one area parts count as one.
int contact_clusters(const Eigen::VectorXd& column);

/// One speed's column of a contact node's map, for sector 0. An area narrower than a step, over which none begins, is
/// passed in the step before: it has the share of the area in which that began.
Eigen::VectorXd contact_shares(const SpeedResponse& speed, int sector_count, const ContactLine& contact, int node);

/// The map of a contact node. Needs a response at every speed, and areas at all of them alike.
ContactMap contact_map(const Response& response, const ContactLine& contact, int node);

}  // namespace tiprub
