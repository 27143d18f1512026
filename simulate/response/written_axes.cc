// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/response/written_axes.h"

#include <numeric>

namespace tiprub {

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
