// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "cases/program/case_file.h"
#include "mesh/import/cell_mesh.h"
#include "mesh/import/selection.h"
#include "mesh/sector/sector_file.h"

namespace tiprub::mesh {

/// The reader of a format.
using ReadMesh = ForeignMesh (*)(const NamedText& file);

/// [mesh] with mesh_file instead of family: a mesh of another code, and the names of its faces, nodes and solids.
struct ImportParameters {
  NamedText file;
  ReadMesh read = read_inp;
  double length = 1;  ///< [m] of the file's unit
  Axis axis = Axis::z;
  int sector_count = 0;  ///< 0: found from the cuts
  /// By key of [mesh]: of faces (clamped, blade_tip, splitter_tip, cyclic_low, cyclic_high), of nodes (contact,
  /// contact_splitter), of solids (disc, main_blade, splitter). Empty or absent: the set of the key's name, if any.
  std::map<std::string, std::string> selection;
  LeadingEdge leading_edge = LeadingEdge::low_z;
  bool unusual = false;  ///< a radius that is usual for no wheel is meant
};

/// Whether [mesh] asks for a mesh of another code.
bool is_import(const CaseTable& table);

/// Raises InputError as CaseTable does.
ImportParameters read_import_parameters(CaseTable& table);

/// An imported mesh with the groups of sector.msh, and a description of what was found.
struct ImportedSector {
  NamedMesh mesh;
  double largest_radius;    ///< [m]
  std::string description;  ///< lines
};

/// Raises InputError at length_unit if the wheel has a radius above 5 m that is not said to be meant.
void require_usual_radius(const CaseTable& table, const ImportParameters& parameters, double largest_radius);

/// Reads the file and names the groups of sector.msh. Raises InputError.
ImportedSector import_sector(const ImportParameters& parameters);

}  // namespace tiprub::mesh
