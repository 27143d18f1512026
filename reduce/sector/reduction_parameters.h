// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "cases/program/case_file.h"
#include "reduce/model/reduced_model.h"
#include "reduce/sector/rotating_elasticity.h"

namespace tiprub::reduce {

/// What factorizes the sector's stiffness.
enum class Factorization {
  automatic,  ///< CHOLMOD if its factors fit the memory, or else MUMPS
  cholmod,
  mumps,  ///< on disk if its factors don't fit the memory
};

/// The table [reduce] of a case file.
struct ReductionParameters {
  Material material;
  double speed_max = 0;  ///< [rad/s] Omega_max of eq. 7
  Prestress prestress = Prestress::linear;
  SpinSoftening spin_softening = SpinSoftening::on;
  std::optional<ContactKind> contact;       ///< none: chosen by what the mesh has, see contact_unknowns.h
  int contact_nodes = 10;                   ///< points, or segments
  int fixed_interface_modes = 0;            ///< at each of the two speeds that give modes, 0 and Omega_max
  int modes_at_speed = 0;                   ///< generalized dofs that suffice at any one speed; 0: all
  std::vector<double> verification_speeds;  ///< [1] over Omega_max
  int verification_modes = 0;               ///< a nodal diameter
  double verification_tolerance = 0;        ///< [1] of omega^2, estimated
  double frequency_tolerance = 0;           ///< [1] of omega^2 of the lowest modes between the speeds of the basis
  int polynomial_speeds = 0;                ///< of SpinShape, rest among them; 0: as many as it takes
  double polynomial_tolerance = 0;          ///< [1] of the load, that SpinShape may leave out of balance
  int refine = 0;                           ///< times that each cell is split into eight, see refinement.h
  Degree degree = Degree::quadratic;        ///< of the displacements, see cubic_bricks.h
  bool mesh_error = true;                   ///< whether to estimate it
  double cyclic_tolerance = 0;              ///< [1] over the largest radius
  bool unusual = false;                     ///< values that are usual for no wheel are meant
  Factorization factorization = Factorization::automatic;
  std::filesystem::path scratch_folder;  ///< for factors on disk; no key: the folder of the output
  int threads = 2;                       ///< for nodal diameters and the BLAS
};

/// What gives the sector. Keys of the material, of spin and of cells are refused beside matrices.
enum class SectorInput { mesh, matrices };

/// Reads and closes the table. Raises InputError.
ReductionParameters read_reduction_parameters(CaseTable& table, SectorInput input);

}  // namespace tiprub::reduce
