// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "reduce/sector/reduction_parameters.h"
#include "reduce/sector/sector_mesh.h"

namespace tiprub::reduce {

/// Modes of one nodal diameter of the unreduced sector over the speeds, sorted by frequency at each speed.
struct ModesOverSpeed {
  Eigen::MatrixXd frequency;  ///< [Hz] n_s x n_f
  Eigen::MatrixXi
      branch;           ///< mode k at speed s continues the branch of this number; at the first speed, k; n_s x n_f
  Eigen::MatrixXd mac;  ///< [1] MAC with the same branch at the speed before, 1 where a branch begins; n_s x n_f
  std::vector<Eigen::MatrixXd> energy_share;  ///< [1] for each part, its share of the strain energy; n_s x n_f
};

/// The modes and the static state of the unreduced sector under spin, without contact.
struct LinearResults {
  int sector_count = 0;
  int sector_dofs = 0;
  std::string prestress;
  Eigen::VectorXd speeds;          ///< [rad/s] n_s
  std::vector<std::string> parts;  ///< volume groups of the mesh: "disc", "main_blade", "splitter"; or "sector"
  std::vector<ModesOverSpeed> nodal_diameters;  ///< n = 0 .. floor(N/2)
  Eigen::MatrixXd displacement;                 ///< [m] largest under spin; n_s x parts
  Eigen::MatrixXd von_mises;                    ///< [Pa] largest under spin, of the Gauss points; n_s x parts
  Eigen::VectorXd tip_arc_length;  ///< [m] of the tip line's nodes from the leading edge, in the meridional plane
  Eigen::MatrixXd clearance_loss;  ///< [m] motion of the tip towards the casing, along its normal; n_s x nodes
  std::string doubts;              ///< shift_doubts() at the highest speed

  int speed_count() const { return static_cast<int>(speeds.size()); }
};

/// Finds the modes at each verification speed independently, with one factor and block Lanczos, and tracks them
/// over speed by the modal assurance criterion MAC_ij = |phi_i^H M phi_j|^2 of M-orthonormal shapes. The pair with
/// the largest MAC is joined first, then the largest of the remaining pairs; a mode whose MAC is below 0.5 begins
/// a branch. A mode's strain energy is that of the material at rest, u^H K(0) u / 2, summed over the cells of each
/// part. Raises RunError for an unstable rotor, with the speed, and for too little memory.
LinearResults linear_results(const SectorMesh& mesh, const ReductionParameters& parameters);

/// Three tables, blank-separated, one header line each: modes, static state of the parts, tip.
void print(std::ostream& out, const LinearResults& results);

/// Writes modes.h5, schema "tiprub-modes", which reduce/format.md describes.
void write_linear_results(const LinearResults& results, const std::filesystem::path& path,
                          const std::string& generator, const std::string& provenance);

}  // namespace tiprub::reduce
