// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/fuzz/random.h"

namespace tiprub::fuzz {

/// Numbers at which programs stumble: not finite, subnormal, at the ends of integers, far too large.
double extreme_number(Random& random);
/// Puts an extreme double, float, or integer of 4 or 8 bytes at a place, as far as the data reaches.
void put_extreme_number(std::string& data, std::size_t at, Random& random);

/// One change: a bit, a byte, a number; a block removed, doubled, moved, zeroed or made up; the end cut off; the rest
/// of another input from somewhere on.
void change_bytes(std::string& data, const std::string& other, Random& random);

}  // namespace tiprub::fuzz
