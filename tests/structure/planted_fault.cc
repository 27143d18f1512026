// SPDX-License-Identifier: GPL-3.0-or-later
// One wrong step, by name, for the tests that the sanitized build ends it.
#include <Eigen/Core>
#include <climits>
#include <string>
#include <vector>

namespace {

int out_of_bounds(int far) {
  std::vector<int> values(4);
  return values.data()[far];
}

int overflow(int far) {
  return INT_MAX - 4 + far;
}

int library_assertion(int far) {
  std::vector<int> values(4);
  return values[static_cast<std::size_t>(far)];
}

int eigen_assertion(int far) {
  const Eigen::VectorXi values = Eigen::VectorXi::Zero(4);
  return values[far];
}

}  // namespace

/// usage: planted_fault address|overflow|library|eigen
int main(int argc, char** argv) {
  const std::string fault = argc > 1 ? argv[1] : "";
  const int far = argc + 3;  // 5: unknown to the compiler
  if (fault == "address") return out_of_bounds(far);
  if (fault == "overflow") return overflow(far) == 0;
  if (fault == "library") return library_assertion(far);
  if (fault == "eigen") return eigen_assertion(far);
  return 0;
}
