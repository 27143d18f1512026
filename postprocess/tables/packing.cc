// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/tables/packing.h"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <limits>

#include "cases/program/errors.h"

namespace tiprub::postprocess {

std::string base64(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * ((bytes.size() + 2) / 3));
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8U) | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[(group >> (18U - 6U * k)) & 63U] : '=';
  }
  return text;
}

std::string deflated(const std::string& bytes, Packing packing) {
  const bool fast = packing == Packing::fast;
  constexpr int most_memory = 9;
  z_stream stream{};
  if (deflateInit2(&stream, fast ? Z_BEST_SPEED : Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS, most_memory,
                   fast ? Z_RLE : Z_DEFAULT_STRATEGY) != Z_OK)
    throw RunError("the data of a report can't be compressed: not enough memory");
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // NOLINT: zlib only reads it
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);  // there is room for all of it
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

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

}  // namespace tiprub::postprocess
