// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/fuzz/readers.h"

namespace tiprub::fuzz {

struct Base {
  std::filesystem::path file;
  std::string bytes;
};

std::vector<Base> read_bases(const std::vector<std::string>& files);

/// Writes input `index` of a seed: one of the bases, changed at a few places. Returns the base's folder.
std::filesystem::path make_input(const std::filesystem::path& file, Format format, const std::vector<Base>& bases,
                                 std::uint64_t seed, std::uint64_t index);

}  // namespace tiprub::fuzz
