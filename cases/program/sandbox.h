// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace tiprub {

/// The process of the sandbox died, or took more than it may. what() tells how, for instance "Segmentation fault".
class SandboxFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct SandboxLimits {
  double bytes = std::numeric_limits<double>::infinity();    ///< of memory in addition to that of the caller
  double seconds = std::numeric_limits<double>::infinity();  ///< of processor time
};

/// The bytes that `make` returns, computed in a forked process. This is for libraries that read files from elsewhere.
/// A damaged or hostile file may make them write past their arrays, ask for all memory or never end; then only that
/// process is lost. What they print is dropped. Raises InputError and RunError as `make` does, and SandboxFailure.
std::string made_in_sandbox(const std::function<std::string()>& make, const SandboxLimits& limits);

}  // namespace tiprub
