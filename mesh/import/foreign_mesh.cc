// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/foreign_mesh.h"

#include "cases/program/errors.h"

namespace tiprub {

void refuse_linear(const NamedText& file, int line, const std::string& what) {
  throw InputError(file.name + ":" + std::to_string(line) + ": " + what +
                   ": elements that have corners only bend too stiffly; mesh again with quadratic ones, 10-node "
                   "tetrahedra, 15-node wedges or 20-node bricks");
}

void add_node(ForeignMesh& mesh, const NamedText& file, int line, long number, const Eigen::Vector3d& at) {
  const std::string where = file.name + ":" + std::to_string(line) + ": node " + std::to_string(number);
  if (number <= 0) throw InputError(where + " must have a number above 0");
  if (!mesh.nodes.emplace(number, at).second)
    throw InputError(where + " is there twice; does the file hold several parts? Write one");
}

}  // namespace tiprub
