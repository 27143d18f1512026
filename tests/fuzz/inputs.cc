// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/inputs.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/hdf5_structure.h"
#include "tests/fuzz/text.h"

namespace tiprub::fuzz {

namespace {

constexpr std::size_t most_changes = 6;

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": can't be written");
}

}  // namespace

std::vector<Base> read_bases(const std::vector<std::string>& files) {
  std::vector<Base> bases;
  for (const std::string& path : files) {
    std::ifstream file(path, std::ios::binary);
    bases.push_back({path, std::string(std::istreambuf_iterator<char>(file), {})});
    if (bases.back().bytes.empty()) throw std::runtime_error(path + ": can't be read, or is empty");
  }
  return bases;
}

std::filesystem::path make_input(const std::filesystem::path& file, Format format, const std::vector<Base>& bases,
                                 std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index);
  const Base &base = random.of(bases), &other = random.of(bases);
  std::string bytes = base.bytes;
  const bool sound = format == Format::hdf5 && random.once_in(2);  // for HDF5; what it holds may be anything
  const bool as_text = format == Format::text ? !random.once_in(4) : format == Format::mesh && random.once_in(2);
  const std::size_t changes = random.few(most_changes);
  for (std::size_t i = 0; i < changes && !sound; ++i)
    if (as_text)
      change_text(bytes, other.bytes, random);
    else
      change_bytes(bytes, other.bytes, random);
  write(file, bytes);
  for (std::size_t i = 0; i < changes && sound; ++i) change_structure(file, random);
  return base.file.parent_path();
}

}  // namespace tiprub::fuzz
