// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tiprub {

/// The state of the seal at the end of a file.
enum class Seal {
  none,    ///< there is no seal
  broken,  ///< the bytes have changed since the file was sealed
  whole,   ///< the bytes are those that were sealed
};

/// Appends the digest of all bytes to a finished file; HDF5 ignores bytes after its own end. Raises RunError.
void seal(const std::filesystem::path& path);

Seal seal_of(const std::filesystem::path& path);

}  // namespace tiprub
