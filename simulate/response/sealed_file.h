// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tiprub {

/// What the end of a file tells of its bytes.
enum class Seal {
  none,    ///< it was never sealed
  broken,  ///< they are not those that were sealed
  whole,
};

/// Appends the digest of all bytes to a finished file. HDF5 doesn't mind what follows its end. Raises RunError.
void seal(const std::filesystem::path& path);

Seal seal_of(const std::filesystem::path& path);

}  // namespace tiprub
