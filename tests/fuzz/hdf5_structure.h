// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "tests/fuzz/random.h"

namespace tiprub::fuzz {

/// One change of an HDF5 file, by HDF5 itself, so that the file stays sound: an object or an attribute is removed,
/// renamed, put in another one's place, or made again with another shape, type or value. Nothing, where HDF5 won't.
void change_structure(const std::filesystem::path& file, Random& random);

}  // namespace tiprub::fuzz
