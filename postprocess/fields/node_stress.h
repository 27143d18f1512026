// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <vector>

#include "postprocess/fields/cell_stress.h"
#include "postprocess/fields/cycle_stress.h"
#include "postprocess/fields/field_peak.h"
#include "postprocess/fields/wheel_cycle.h"
#include "reduce/model/fields_file.h"
#include "simulate/response/response.h"

namespace tiprub::postprocess {

/// The nodes of the body whose stress of the vibration is above `least` [1] of the largest one there; ascending.
std::vector<int> nodes_above(double least, const CycleStress& stress, const StressZones& zones);

/// The stress at some nodes of the sector, from the cells around them alone.
class NodeStress {
 public:
  /// `nodes`: ascending, each once. The reader must outlive this object.
  NodeStress(const FieldsReader& reader, const std::vector<int>& nodes);

  /// A wave for each column of `basis` (dofs x any) as amplitudes of a nodal diameter's dofs, with displacement and
  /// stress at the nodes.
  std::vector<WaveField> waves(int nodal_diameter, const Eigen::MatrixXcd& basis) const;
  /// [Pa] Their stress; (component, node) x columns.
  Eigen::MatrixXcd of(int nodal_diameter, const Eigen::MatrixXcd& basis) const;

 private:
  const FieldsReader& reader_;
  std::vector<int> used_, places_;  // nodes of the part in the sector, and those asked for in the part
  SectorFields part_;
  CellStress cells_;
};

/// [Pa] The largest von Mises stress of the vibration at some nodes, over a cycle's samples and sectors.
using LargestStress = std::function<double(const WheelCycle&)>;

/// Recovers the stress at the nodes for each dof of the nodal diameters that are given, the order of the states of a
/// cycle, so that a cycle then takes no field of the sector.
LargestStress largest_stress(const NodeStress& stress, const FieldsReader& reader,
                             const std::vector<int>& nodal_diameters);

/// Checks that the fields are of the model that the error budgets of the response compare with ([simulate]
/// budget_model); a response without critical speeds has no budgets. Raises InputError if they are not, or if a cell
/// has no stress.
void check_budget_fields(const FieldsReader& other, const Response& response);

/// The nodes in the body of another mesh of the same sector whose nearest node in `sector` is one of `nodes`;
/// ascending.
std::vector<int> nodes_near(const std::vector<int>& nodes, const SectorFields& sector, const SectorFields& other,
                            const StressZones& zones_of_other);

/// The stress over the cycles of varied peaks that were marched with another model, near `nodes` of the sector.
/// Raises InputError if the other mesh has no node there.
LargestStress stress_of_other_model(const FieldsReader& other, const SectorFields& sector,
                                    const std::vector<int>& nodes, const StressZones& zones,
                                    const SimulatedScene& scene);

}  // namespace tiprub::postprocess
