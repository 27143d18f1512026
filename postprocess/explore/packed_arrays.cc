// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/explore/packed_arrays.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "postprocess/tables/packing.h"

namespace tiprub {

namespace {

constexpr std::size_t word = 4;  // [bytes] typed arrays begin at multiples of their element's size

static_assert(std::endian::native == std::endian::little, "the page's numbers are little-endian");

void pad(std::string& bytes, char with) {
  while (bytes.size() % word != 0) bytes += with;
}

}  // namespace

template <class Number>
void PackedArrays::append(const std::string& name, const char* type, const std::vector<Number>& numbers,
                          double scale) {
  pad(bytes_, '\0');
  directory_[name] = {type, bytes_.size(), numbers.size(), scale};
  bytes_.append(reinterpret_cast<const char*>(numbers.data()), sizeof(Number) * numbers.size());
}

void PackedArrays::add(const std::string& name, const Eigen::MatrixXd& values) {
  const Eigen::MatrixXf narrowed = values.cast<float>();
  append(name, "f32", std::vector<float>(narrowed.data(), narrowed.data() + narrowed.size()), 1);
}

void PackedArrays::add_coarse(const std::string& name, const Eigen::MatrixXd& values) {
  constexpr double most = std::numeric_limits<std::int16_t>::max();
  const double largest = values.size() == 0 ? 0 : values.cwiseAbs().maxCoeff();
  const double scale = largest > 0 ? largest / most : 1;
  std::vector<std::int16_t> numbers;
  numbers.reserve(static_cast<std::size_t>(values.size()));
  for (const double value : values.reshaped())
    numbers.push_back(static_cast<std::int16_t>(std::lround(value / scale)));
  append(name, "i16", numbers, scale);
}

void PackedArrays::add(const std::string& name, const std::vector<std::uint32_t>& values) {
  append(name, "u32", values, 1);
}

std::string PackedArrays::packed(nlohmann::json about) const {
  about["arrays"] = directory_;
  std::string text = about.dump();
  pad(text, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string bytes(reinterpret_cast<const char*>(&length), sizeof length);
  return base64(deflated(bytes + text + bytes_));
}

}  // namespace tiprub
