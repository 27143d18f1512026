// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace tiprub {

/// A child process that died, or took more than it may. what(): how, for instance "Segmentation fault".
class ChildDied : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a child may take beside what its parent has.
struct ChildLimits {
  double bytes = std::numeric_limits<double>::infinity();    ///< of memory, beside its parent's
  double seconds = std::numeric_limits<double>::infinity();  ///< of processor time
};

/// The bytes that a function gives, made in a process of its own: a library that writes past its arrays, asks for all
/// memory, never ends there or takes a signal for its own can't harm this one. What it prints is lost. Raises
/// InputError and RunError as the function does, and ChildDied.
std::string made_by_a_child(const std::function<std::string()>& make, const ChildLimits& limits = {});

}  // namespace tiprub
