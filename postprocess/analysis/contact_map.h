// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "simulate/response/response.h"

namespace tiprub {

/// Where around the casing one contact node of sector 0 rubs, over speed (paper, sec. 5.2.2).
struct ContactMap {
  /// [1] share of the steps spent over an area that are in contact: 0 never, 1 always; areas x speeds. A count of the
  /// file over the steps that a node spends over an area: (steps a revolution) (revolutions) / areas.
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

/// The map of a contact node; speeds that failed have an empty column.
ContactMap contact_map(const Response& response, int node);

}  // namespace tiprub
