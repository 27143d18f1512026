// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "cases/program/process_group.h"
#include "reduce/sector/rotating_elasticity.h"
#include "tests/reduce/brick_grid.h"

namespace tiprub::reduce::test {

enum class Bore { clamped, free };

/// An annulus of N equal sectors. The tip line stands on the rim, in the middle between the cut faces; the tip's
/// faces, if there are four bricks around or more, are those that don't touch them.
struct Annulus {
  int sector_count = 5;
  std::array<int, 3> bricks = {2, 2, 1};  ///< of one sector: radial, around, axial
  int nodes_per_brick = 20;
  Bore bore = Bore::clamped;
  double inner = 0.1;    ///< [m] radius
  double outer = 0.2;    ///< [m] radius
  double height = 0.03;  ///< [m]
  double wrap = 0.0;     ///< [rad] by which the rim is turned before the bore
  double twist = 0.0;    ///< [rad] by which the top is turned before the bottom
  double coning = 0.0;   ///< [m] by which the rim is lifted; bends the meridional section
  double grading = 0.0;  ///< [1] by how much smaller than the average the bricks at the bore are

  SectorMesh sector() const;
  /// The whole ring as one mesh without cut faces; the nodes of its sectors follow each other.
  SectorMesh wheel() const;

 private:
  Placement placement(double angle) const;
};

/// A wrapped, twisted and coned annulus: no symmetry left but the cyclic one.
Annulus skewed_annulus(int sector_count);

/// Steel, in SI.
Material steel();

/// This process, which shares its work with no other.
ProcessGroup& alone();

/// Matrices of a mesh, with the static displacement under spin by another solver than the program's.
class TestRotor {
 public:
  TestRotor(SectorMesh mesh, std::vector<int> contact, const Material& material = steel());
  TestRotor(const TestRotor&) = delete;
  TestRotor& operator=(const TestRotor&) = delete;

  const SectorMesh& mesh() const { return mesh_; }
  const SectorDofs& dofs() const { return dofs_; }
  RotatingElasticity& elasticity() { return elasticity_; }
  SymmetricMatrix mass() { return elasticity_.mass(); }
  SymmetricMatrix at_rest() { return at_speed(0.0, Prestress::linear); }
  SymmetricMatrix at_speed(double speed, Prestress prestress);
  /// [m] linear static displacement under spin, x, y, z; 3 x nodes.
  Eigen::Matrix3Xd static_displacement(double speed);

 private:
  SectorMesh mesh_;
  SectorDofs dofs_;
  RotatingElasticity elasticity_;
};

/// A rotor of one sector whose contact nodes are the first and the last of the tip line.
TestRotor tip_rotor(const Annulus& annulus, const Material& material = steel());

}  // namespace tiprub::reduce::test
