// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tiprub::postprocess {

/// Base 64 (RFC 4648, padded, without line breaks), for bytes inside text files.
std::string base64(const std::string& bytes);

/// Compressed bytes as a browser's DecompressionStream("deflate") reads them (RFC 1950).
/// `fast`, for numbers whose last digits are noise, takes a third of the time and gives a tenth more bytes.
enum class Packing { small, fast };
std::string deflated(const std::string& bytes, Packing packing = Packing::small);

/// Arrays for a page: their numbers one after the other, little-endian, and a directory of where each array begins.
/// The page's typed arrays read them in place.
class PackedArrays {
 public:
  /// In single precision; matrices column by column.
  void add(const std::string& name, const Eigen::MatrixXd& values);
  /// In 16 bits, with steps of 1/32767 of the largest magnitude: enough for what is drawn as a curve or a surface.
  void add_coarse(const std::string& name, const Eigen::MatrixXd& values);
  /// Whole numbers of 32 bits.
  void add(const std::string& name, const std::vector<std::uint32_t>& values);

  /// The length of the directory (4 bytes), the directory as JSON together with `about`, and the numbers; deflated
  /// and in base 64.
  std::string packed(nlohmann::json about) const;

 private:
  template <class Number>
  void append(const std::string& name, const char* type, const std::vector<Number>& numbers, double scale);

  nlohmann::json directory_ = nlohmann::json::object();
  std::string bytes_;
};

}  // namespace tiprub::postprocess
