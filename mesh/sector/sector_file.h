// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "mesh/sector/sector_mesher.h"

namespace tiprub {

/// Writes the sector as gmsh 4.1 in text, with the named groups that README.md lists. The same mesh gives the same
/// bytes. Raises RunError if the file can't be written.
void write_sector(const MeshedSector& mesh, const std::filesystem::path& path);

}  // namespace tiprub
