// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "postprocess/fields/wheel_surface.h"
#include "postprocess/figures/figure.h"
#include "reduce/model/reduced_model.h"

namespace tiprub {

/// The outer line of each piece that some faces cover of the meridional plane, closed; r, z [m], 2 x points. Edges of
/// faces bend at their middle nodes. Pieces of less than a ten-thousandth of the largest one's area are left out.
std::vector<Eigen::Matrix2Xd> meridional_outline(const Eigen::Matrix3Xd& nodes,
                                                 const std::vector<SurfaceFace>& faces);

/// Paper, fig. 2; `clearance` [m] as the case gives it, by contact node.
Figure meridional_section_figure(const SectorFields& sector, const ContactLine& line,
                                 const Eigen::VectorXd& clearance);

}  // namespace tiprub
