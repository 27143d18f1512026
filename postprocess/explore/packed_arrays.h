// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <nlohmann/json.hpp>
#include <string>

namespace tiprub {

/// Arrays on their way into a page: numbers one after the other, little-endian, and a directory that tells where each
/// one lies. A page's typed arrays look at them in place.
class PackedArrays {
 public:
  /// In single precision: 7 digits. Matrices by columns.
  void add(const std::string& name, const Eigen::MatrixXd& values);
  /// In 16 bits, of the largest magnitude 1/32767: for what is drawn as a curve or a surface.
  void add_coarse(const std::string& name, const Eigen::MatrixXd& values);
  /// Whole numbers 0 .. 4294967295.
  void add(const std::string& name, const std::vector<std::uint32_t>& values);

  /// All of it: the directory's length (4 bytes), the directory with `about` in it as JSON, the numbers; deflated and
  /// in base 64.
  std::string packed(nlohmann::json about) const;

 private:
  template <class Number>
  void append(const std::string& name, const char* type, const std::vector<Number>& numbers, double scale);

  nlohmann::json directory_ = nlohmann::json::object();
  std::string bytes_;
};

}  // namespace tiprub
