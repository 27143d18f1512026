// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>

namespace tiprub::fuzz {

/// The same numbers for the same seed on every machine, which the standard's distributions don't promise.
class Random {
 public:
  /// Of one input: an input can be made again without those before it.
  Random(std::uint64_t seed, std::uint64_t index) : engine_(seed * 0x9e3779b97f4a7c15ULL + index) {}

  /// 0 .. count-1; 0 if count is 0.
  std::size_t below(std::size_t count) { return count == 0 ? 0 : static_cast<std::size_t>(engine_() % count); }
  /// True once in `times`.
  bool once_in(std::size_t times) { return below(times) == 0; }
  /// 1, half as often 2, ..., at most `most`.
  std::size_t few(std::size_t most) {
    std::size_t count = 1;
    while (count < most && once_in(2)) ++count;
    return count;
  }
  template <class Container>
  const auto& of(const Container& choices) {
    return choices[below(std::size(choices))];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace tiprub::fuzz
