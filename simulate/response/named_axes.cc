// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/named_axes.h"

#include <numeric>

namespace tiprub {

void NamedAxes::set(const std::string& axis, std::size_t length, const std::string& because) {
  lengths_[axis] = {length, because};
}

std::string NamedAxes::describe(const std::vector<std::string>& axes) const {
  return listed(axes, " x ", [&](const std::string& axis) {
    const auto known = lengths_.find(axis);
    return known == lengths_.end() ? "at least 1 " + axis
                                   : text_of(known->second.value, " ", axis, " (", known->second.because, ")");
  });
}

void NamedAxes::require(const std::string& dataset, const std::vector<std::string>& axes) {
  const std::vector<std::size_t> shape = file_.shape_of(dataset);
  bool fits = shape.size() == axes.size();
  for (std::size_t i = 0; fits && i < axes.size(); ++i) {
    const auto known = lengths_.find(axes[i]);
    fits = shape[i] > 0 && (known == lengths_.end() || known->second.value == shape[i]);
  }
  if (!fits) {
    const std::string found = listed(shape, " x ", [](std::size_t extent) { return std::to_string(extent); });
    throw FileError(file_.path() + ": " + dataset + ": has shape " + (found.empty() ? "scalar" : found) +
                    ", must have " + describe(axes));
  }
  for (std::size_t i = 0; i < axes.size(); ++i) lengths_.try_emplace(axes[i], Length{shape[i], "as " + dataset});
}

void write_axis(Hdf5File& file, const std::string& name, const Eigen::VectorXd& values, const std::string& unit,
                const std::string& long_name) {
  file.write(name, values, unit);
  file.make_axis(name);
  file.describe(name, long_name);
}

void write_counting_axis(Hdf5File& file, const std::string& name, Eigen::Index count, const std::string& long_name) {
  Array<std::int32_t> numbers{{static_cast<std::size_t>(count)}, std::vector<std::int32_t>(count)};
  std::iota(numbers.values.begin(), numbers.values.end(), 0);
  file.write(name, numbers, "1");
  file.make_axis(name);
  file.describe(name, long_name);
}

}  // namespace tiprub
