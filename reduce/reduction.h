// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cases/case_file.h"
#include "cases/progress.h"
#include "reduce/fields_file.h"
#include "reduce/reduced_model.h"
#include "reduce/rotating_elasticity.h"
#include "reduce/sector_mesh.h"

namespace tiprub {

/// The table [reduce] of a case file.
struct ReductionParameters {
  Material material;
  double speed_max = 0;  ///< [rad/s] Omega_max of eq. 7
  Prestress prestress = Prestress::linear;
  SpinSoftening spin_softening = SpinSoftening::on;
  int contact_nodes = 10;
  int fixed_interface_modes = 0;            ///< at each of the two speeds that give modes, 0 and Omega_max
  int modes_at_speed = 0;                   ///< generalized dofs that do at any one speed; 0: all
  std::vector<double> verification_speeds;  ///< [1] over Omega_max
  int verification_modes = 0;               ///< a nodal diameter
  double verification_tolerance = 0;        ///< [1] of omega^2, estimated
  double frequency_tolerance = 0;           ///< [1] of the lowest frequencies between the speeds of the basis
  int polynomial_speeds = 0;                ///< of eq. 7; 0: as many as `polynomial_tolerance` takes, 3 or 5
  double polynomial_tolerance = 0;          ///< [1] of a frequency, by eq. 7 alone
  double cyclic_tolerance = 0;              ///< [1] over the largest radius
  int threads = 1;                          ///< for nodal diameters and the BLAS

  static ReductionParameters read(CaseTable& table);
};

/// What the reduction tells about itself.
struct ReductionReport {
  int newton_steps = 0;        ///< most of all speeds, with nonlinear prestress
  double newton_residual = 0;  ///< [1] largest of all speeds; see spin_equilibrium()
  int sector_dofs = 0;
  int clamped_face_nodes = 0;
  double memory_needed = 0;           ///< [bytes] estimated before the start
  std::vector<int> generalized_dofs;  ///< a nodal diameter
  std::vector<int> dropped;           ///< a nodal diameter
  std::vector<int> corrections;       ///< shapes that modes between the speeds gave; a nodal diameter
  int polynomial_speeds = 0;          ///< that eq. 7 took
  std::vector<std::pair<std::string, double>> seconds;  ///< what took how long
};

/// The name of a prestress model in case files and in model.h5.
std::string name_of(Prestress prestress);

/// Eqs. 3-10 of the paper: K and M of a sector, nodal diameter by nodal diameter on one Craig-Bampton basis, eq. 7
/// through K at three speeds or more, and the unreduced frequencies that verify it. Costs two factorizations, at rest
/// and at Omega_max, for all nodal diameters and all speeds. Raises RunError for an unstable rotor, with the speed. `fields`,
/// if given, gets the basis on all nodes as soon as it is known.
ReducedModel reduce(const SectorMesh& mesh, const ReductionParameters& parameters, Progress::Shown progress,
                    ReductionReport& report, FieldsWriter* fields = nullptr);

/// Whether a sector can be reduced: contact nodes can be chosen and are free, no cell is inverted. Raises InputError.
void check_sector(const SectorMesh& mesh, const ReductionParameters& parameters);

/// How many of the wheel's first frequencies the verification holds at every speed: up to where the modes of some
/// nodal diameter end.
int verified_frequencies(const ReducedModel& model);

/// Largest relative difference of the first `count` frequencies of the whole wheel (nodal diameters strictly between
/// 0 and N/2 count twice) over all verification speeds, model against unreduced sector.
double verification_error(const ReducedModel& model, int count);

}  // namespace tiprub
