// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <span>
#include <vector>

#include "postprocess/fields/cell_stress.h"
#include "reduce/model/fields_file.h"

namespace tiprub::postprocess {

/// A travelling wave on the sector's nodes, in the x, y, z of sector 0: sector j moves by
/// R_j Re(u e^{i n j alpha}), R_j its turning by j alpha about z.
struct WaveField {
  int nodal_diameter = 0;
  Eigen::Matrix3Xcd displacement;  ///< [m]; 3 x nodes
  ComplexTensors stress;           ///< [Pa]; 6 x nodes; may be empty
};

/// Displacement and stress of one sector at one instant, in the x, y, z of sector 0.
struct SectorField {
  Eigen::Matrix3Xd displacement;  ///< [m]
  Tensors stress;                 ///< [Pa]; empty if the waves have none
};

/// Displacement and stress of all sectors at one instant, in the wheel's x, y, z.
struct WheelField {
  std::vector<Eigen::Matrix3Xd> displacement;  ///< [m] by sector
  std::vector<Tensors> stress;                 ///< [Pa] by sector
};

/// From r, theta, z of node 0, node 1, ... to x, y, z.
Eigen::Matrix3Xcd cartesian(const SectorFields& sector, const Eigen::VectorXcd& cylindrical);

/// Computes the stress of waves from their displacement. At nodes of the cut faces it is averaged over the cells of
/// both sectors that share them: the high face is the low face of the next sector, turned and with the wave's phase.
/// Threads share the waves, two at a time.
void add_stress(const SectorFields& sector, const CellStress& bricks, std::span<WaveField> waves);

/// The static shape under spin [rad/s], the same in every sector: a wave of nodal diameter 0.
WaveField spin_field(const SectorFields& sector, const CellStress& bricks, double speed);

/// A sum of waves on sector j.
SectorField on_sector(const std::vector<WaveField>& waves, int j, int sector_count);

/// A sum of waves on all N sectors.
WheelField on_wheel(const std::vector<WaveField>& waves, int sector_count);

/// Positions [m] of the nodes of sector j.
Eigen::Matrix3Xd nodes_of_sector(const SectorFields& sector, int j);

/// [m] from the axis to the outermost node.
double outer_radius(const SectorFields& sector);

}  // namespace tiprub::postprocess
