// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <map>
#include <optional>
#include <vector>

#include "reduce/model/reduced_model.h"
#include "reduce/sector/sector_dofs.h"

namespace tiprub::reduce {

/// What carries contact in a sector: nodes of the tip line, or segments of the tip.
struct ContactUnknowns {
  std::vector<int> nodes;  ///< one of the contact line for each unknown: the chosen one, or that next to the centre
  ContactLine line;        ///< static shifts are left zero
  std::vector<int> tip = {};     ///< the nodes that segments spread over; none with points
  Eigen::MatrixXd weights = {};  ///< [1] W, of each node of the tip in a segment; each row's sum over points is one
  /// [1] W of the functions that the cells of a tip lack (see added_functions.h), by the nodes in the middles of a
  /// function's edges, ascending; one weight for each segment.
  std::map<std::vector<int>, Eigen::VectorXd> added_weights = {};
};

/// Numbers the dofs of a sector with these contact unknowns, see sector_dofs.h. Raises InputError also if a node of
/// the tip is clamped or lies on a cut face.
SectorDofs number_dofs(const SectorMesh& mesh, const ContactUnknowns& contact);

/// `count` contact unknowns on each blade that has a contact line, of the kind that is asked for. If none is, they
/// are segments where the mesh names the tips' faces and each line has more than one node, else points. Points are
/// chosen by choose_contact_nodes().
///
/// Segments are those of section 5 of reduce/theory.md: with N_i the shape functions of the tip's faces, or all
/// functions of cubic bricks,
///     W_ki = int N_i w_k dA / int w_k dA,   q_k = sum_i W_ki u_i.
/// Raises InputError if the mesh doesn't name the tip's faces, if they leave out a stretch of the line, or if there
/// are more segments than the mesh can tell apart.
ContactUnknowns choose_contact(const SectorMesh& mesh, std::optional<ContactKind> kind, int count);

}  // namespace tiprub::reduce
