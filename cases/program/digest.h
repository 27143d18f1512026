// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace tiprub {

/// A short name for much data, to tell whether two files hold or were made from the same: 64 bits of Fowler, Noll and
/// Vo's hash, variant 1a. Against mistakes and damage, not against malice.
class Digest {
 public:
  void add_bytes(const void* data, std::size_t count);
  /// A number by its bytes; -0.0 counts as 0.0, which files don't keep apart.
  template <class Value>
  void add(Value value) {
    static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>);
    if constexpr (std::is_floating_point_v<Value>) value += Value(0);
    add_bytes(&value, sizeof(value));
  }
  void add(const std::string& text);
  /// `count` numbers from `data` on, each as by add().
  template <class Value>
  void add(const Value* data, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) add(data[i]);
  }
  /// 16 hexadecimal digits.
  std::string digits() const;

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace tiprub
