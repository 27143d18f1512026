// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/fuzz/random.h"
#include "tests/fuzz/readers.h"

namespace tiprub::fuzz {

/// A number at which programs stumble: not finite, subnormal, at the ends of integers, far too large.
double extreme_number(Random& random);
/// Puts an extreme double, float, or integer of 4 or 8 bytes at a place, as far as the data reaches.
void put_extreme_number(std::string& data, std::size_t at, Random& random);

struct Base {
  std::filesystem::path file;
  std::string bytes;
};

std::vector<Base> read_bases(const std::vector<std::string>& files);

/// Writes input `index` of a seed: one of the bases, changed at a few places. Returns the base's folder.
std::filesystem::path make_input(const std::filesystem::path& file, Format format, const std::vector<Base>& bases,
                                 std::uint64_t seed, std::uint64_t index);

}  // namespace tiprub::fuzz
