// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reduce/model/hdf5_file.h"
#include "reduce/model/speed_polynomial.h"

namespace tiprub {

/// What fields.h5 holds beside the basis: one sector of the wheel, its material, its shape under spin.
struct SectorFields {
  int sector_count = 0;    ///< N
  Eigen::Matrix3Xd nodes;  ///< [m] x, y, z; 3 x nodes
  Eigen::MatrixXi cells;   ///< node numbers in VTK's order, then -1 (see nodes_of()); most nodes x cells
  std::map<std::string, std::vector<int>> node_sets;  ///< `clamped`, `contact` (leading to trailing edge),
                                                      ///< `cyclic_low`, `cyclic_high` (partners, in the same order)
  std::map<std::string, std::vector<int>> parts;      ///< cells of `disc`, `main_blade`, ..., where the mesh has them
  std::string mesh_digest;                            ///< of the sector's mesh
  double young = 0;                                   ///< [Pa]
  double poisson = 0;                                 ///< [1]
  double density = 0;                                 ///< [kg/m^3]
  SpeedPolynomial<Eigen::Matrix3Xd, 1> static_displacement;  ///< [m] under spin; r, theta, z; 3 x nodes

  const std::vector<int>& node_set(const std::string& name) const { return node_sets.at(name); }
};

/// Writes fields.h5, schema "tiprub-fields" version 2 (see reduce/format.md), one nodal diameter after the other.
class FieldsWriter {
 public:
  FieldsWriter(const std::filesystem::path& path, const std::string& generator);

  void write_sector(const SectorFields& sector);
  /// The shape of model dof k on the sector's nodes, r, theta, z of node 0, then of node 1, ...
  using Shape = std::function<Eigen::VectorXcd(Eigen::Index k)>;
  /// The basis of one nodal diameter in single precision; a standing wave's shapes are real.
  void write_basis(int nodal_diameter, Eigen::Index dofs, bool standing, const Shape& shape);
  /// [1] what each cell contributes to the means of the model's /mesh_error/frequency and /mesh_error/compliance.
  void write_mesh_error(const Eigen::VectorXd& frequency, const Eigen::VectorXd& compliance);
  /// The last step, with the digest() of the model whose dofs these are. Raises RunError if the disk has not taken
  /// all of it.
  void close(const std::string& model_digest);

 private:
  Hdf5File file_;
  std::size_t nodes_ = 0;
};

/// Reads it. Raises FileError with the file and the dataset if something is missing or doesn't fit: partners on the
/// cuts that do not turn into each other, nodes or cells that are listed twice, parts that overlap.
class FieldsReader {
 public:
  explicit FieldsReader(const std::filesystem::path& path);

  const std::string& path() const { return file_.path(); }

  const SectorFields& sector() const { return sector_; }
  /// [1] what each cell contributes to the mean error of the model's frequencies; empty if that isn't estimated.
  const Eigen::VectorXd& cell_errors_of_frequencies() const { return frequency_errors_; }
  /// [1] likewise of its contact compliances.
  const Eigen::VectorXd& cell_errors_of_compliances() const { return compliance_errors_; }
  /// The digest() of the model that the fields were written with.
  const std::string& model_digest() const { return model_digest_; }
  /// How many dofs the model has at a nodal diameter 0 .. floor(N/2).
  Eigen::Index dofs(int nodal_diameter) const;
  /// The displacement of all nodes for a unit of one dof.
  Eigen::VectorXcd shape(int nodal_diameter, Eigen::Index dof) const;
  /// Fields of several states at once: basis times `amplitudes` (dofs x states), read in one pass; 3 nodes x states,
  /// r, theta, z of node 0, then of node 1, ...
  Eigen::MatrixXcd expand(int nodal_diameter, const Eigen::MatrixXcd& amplitudes) const;

 private:
  void read_shape(int nodal_diameter, Eigen::Index dof, const Eigen::Ref<Eigen::VectorXcf>& shape) const;

  Hdf5File file_;
  mutable std::map<int, std::vector<bool>> sound_;  ///< by nodal diameter and dof: shapes that were read before
  SectorFields sector_;
  std::string model_digest_;
  Eigen::VectorXd frequency_errors_, compliance_errors_;
};

}  // namespace tiprub
