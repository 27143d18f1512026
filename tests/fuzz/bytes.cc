// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/bytes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace tiprub::fuzz {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double extreme_numbers[] = {0,      -0.0,   1,       -1,     2,      0.5,     1e-3,     1e6,       1e9,
                                      -1e9,   1e16,   1e-16,   1e200,  -1e200, 1e-200,  1e-300,   1e308,     -1e308,
                                      5e-324, 0x1p31, -0x1p31, 0x1p32, 0x1p63, -0x1p63, infinity, -infinity, nan};
constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t extreme_integers[] = {
    0, 1, -1, 2, -2, 127, 128, 255, 256, 65535, 65536, 0x7fffffff, 0x80000000, 0xffffffff, largest, -largest - 1};
constexpr unsigned char extreme_bytes[] = {0, 1, 2, 0x0a, 0x20, 0x22, 0x7f, 0x80, 0xfe, 0xff};
constexpr std::size_t longest_block = 4096;

/// What stands at the beginning of HDF5's own tables: where its metadata is.
constexpr const char* signatures[] = {"\x89HDF", "TREE", "SNOD", "HEAP", "GCOL"};
constexpr std::size_t metadata_reach = 600;

template <class Value>
void put(std::string& data, std::size_t at, Value value) {
  if (at < data.size()) std::memcpy(data.data() + at, &value, std::min(sizeof(value), data.size() - at));
}

/// Anywhere; of HDF5 files half of the time in their metadata, which are a small part of them.
std::size_t place_in(const std::string& data, Random& random) {
  const std::size_t anywhere = random.below(data.size());
  if (random.once_in(2)) return anywhere;
  const std::size_t found = data.find(random.of(signatures), anywhere);
  return found == std::string::npos ? anywhere : std::min(found + random.below(metadata_reach), data.size() - 1);
}

std::size_t block_from(const std::string& data, std::size_t at, Random& random) {
  return std::min(1 + random.below(random.once_in(2) ? 16 : longest_block), data.size() - at);
}

void change_block(std::string& data, const std::string& other, std::size_t at, Random& random) {
  const std::size_t size = block_from(data, at, random);
  const std::string block = data.substr(at, size);
  switch (random.below(6)) {
    case 0:
      data.erase(at, size);
      break;
    case 1:
      data.insert(at, block);
      break;
    case 2:
      data.erase(at, size), data.insert(random.below(data.size()), block);
      break;
    case 3:
      data.replace(at, size, size, static_cast<char>(random.of(extreme_bytes)));
      break;
    case 4:
      data.resize(at);
      break;
    default:
      data = data.substr(0, at) + other.substr(random.below(other.size()));
      break;
  }
}

}  // namespace

double extreme_number(Random& random) {
  return random.of(extreme_numbers);
}

void put_extreme_number(std::string& data, std::size_t at, Random& random) {
  switch (random.below(4)) {
    case 0:
      put(data, at, extreme_number(random));
      break;
    case 1:
      put(data, at, static_cast<float>(random.of(extreme_integers)));
      break;
    case 2:
      put(data, at, static_cast<std::int32_t>(random.of(extreme_integers)));
      break;
    default:
      put(data, at, random.of(extreme_integers));
      break;
  }
}

void change_bytes(std::string& data, const std::string& other, Random& random) {
  if (data.empty()) data = other;
  const std::size_t at = place_in(data, random);
  switch (random.below(6)) {
    case 0:
      data[at] = static_cast<char>(data[at] ^ (1 << random.below(8)));
      break;
    case 1:
      data[at] = static_cast<char>(random.below(256));
      break;
    case 2:
      data[at] = static_cast<char>(random.of(extreme_bytes));
      break;
    case 3:
      put_extreme_number(data, at - at % 8, random);
      break;
    case 4:
      put_extreme_number(data, at, random);
      break;
    default:
      change_block(data, other, at, random);
      break;
  }
}

}  // namespace tiprub::fuzz
