// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace tiprub::simulate::kernels {

/// `count` rounded up to whole blocks.
template <class Integer>
constexpr Integer rounded_up(Integer count, std::size_t block) {
  const auto unit = static_cast<Integer>(block);
  return (count + unit - 1) / unit * unit;
}

/// An array of doubles, initially zero, that begins on a cache line: a vector of eight that straddles two lines would
/// cost two loads.
class Lines {
 public:
  static constexpr std::size_t doubles = 8;  ///< a line

  Lines() = default;
  /// Holds at least `size` doubles, in whole lines.
  explicit Lines(std::size_t size) : lines_((size + doubles - 1) / doubles) {}

  double* data() { return lines_.empty() ? nullptr : lines_.front().values; }
  const double* data() const { return lines_.empty() ? nullptr : lines_.front().values; }
  double& operator[](std::size_t i) { return lines_[i / doubles].values[i % doubles]; }
  double operator[](std::size_t i) const { return lines_[i / doubles].values[i % doubles]; }

 private:
  struct alignas(doubles * sizeof(double)) Line {
    double values[doubles] = {};
  };
  std::vector<Line> lines_;
};

}  // namespace tiprub::simulate::kernels
