// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reduce/model/reduced_model.h"

namespace tiprub::simulate::testing {

/// A wheel of one sector with one contact node, whose normal is radial: its matrices are the caller's.
inline ReducedModel one_sector() {
  ReducedModel model;
  model.sector_count = 1;
  model.speed_max = 5000;  // rad/s
  model.prestress = Prestress::given;
  model.contact.position = Eigen::RowVector3d(0.1, 0, 0);
  model.contact.normal = Eigen::RowVector3d(1, 0, 0);
  model.contact.arc_length = Eigen::VectorXd::Zero(1);
  model.contact.static_shift.terms = {Eigen::MatrixX3d::Zero(1, 3)};
  return model;
}

}  // namespace tiprub::simulate::testing
