// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/import/import_parameters.h"
#include "mesh/sector/sector_file.h"

namespace tiprub {

/// A foreign mesh as sector.msh wants it, and what was found, for people.
struct ImportedSector {
  NamedMesh mesh;
  std::string description;  ///< lines
};

/// Reads the file, and names the groups of sector.msh: the one place where that is done. Raises InputError.
ImportedSector import_sector(const ImportParameters& parameters);

}  // namespace tiprub
